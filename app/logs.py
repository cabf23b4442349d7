"""The log file: what happened, for a bug report."""

import logging
import sys
from logging.handlers import RotatingFileHandler
from pathlib import Path

from app.folders import log_folder

logger = logging.getLogger(__name__)

_MOST_BYTES = 1_000_000
_OLD_FILES = 3
_FORMAT = "%(asctime)s %(levelname)s %(name)s (%(threadName)s): %(message)s"


def log_file() -> Path:
    """Return the place of the log file."""
    return log_folder() / "burnish.log"


def start_logging() -> None:
    """Write a log of about four megabytes at most; without a place for it, go on without."""
    root = logging.getLogger()
    root.setLevel(logging.INFO)
    try:
        log_folder().mkdir(parents=True, exist_ok=True)
        handler = RotatingFileHandler(
            log_file(), maxBytes=_MOST_BYTES, backupCount=_OLD_FILES, encoding="utf-8", delay=True
        )
    except OSError as error:
        print(f"burnish: there is no log file: {error}", file=sys.stderr)  # noqa: T201
        return
    handler.setFormatter(logging.Formatter(_FORMAT))
    root.addHandler(handler)
    logger.info("Burnish starts, Python %s on %s", sys.version.split()[0], sys.platform)
