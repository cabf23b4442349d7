"""New files, named after who writes them, and what a writer that was killed leaves behind."""

import os
import platform
import re
import secrets
import sys
import time
import zlib
from contextlib import suppress
from pathlib import Path

# Nobody writes at one file for so long; of a writer on another machine nothing else is known.
_SECONDS_KEPT = 24 * 3600


def fresh_path(target: Path) -> Path:
    """Return the path of a new hidden file beside `target`, named after this process."""
    writer = f"{_machine()}-{os.getpid()}-{secrets.token_hex(3)}"
    return target.with_name(f".{target.stem}.{writer}.tmp{target.suffix}")


def remove_leftovers(target: Path) -> None:
    """Remove the new files of `target` that nobody writes any more.

    Those are of processes of this machine that have ended, and of others after a day. What cannot
    be removed stays: it keeps nobody from saving.
    """
    stem, suffix = re.escape(target.stem), re.escape(target.suffix)
    name = re.compile(rf"\.{stem}\.([0-9a-f]{{4}})-(\d{{1,9}})-[0-9a-f]{{6}}\.tmp{suffix}")
    with suppress(OSError), os.scandir(target.parent) as entries:
        for entry in entries:
            if (found := name.fullmatch(entry.name)) and _is_left(entry, found[1], int(found[2])):
                Path(entry).unlink(missing_ok=True)


def _is_left(entry: os.DirEntry[str], machine: str, process: int) -> bool:
    if machine == _machine() and not _may_run(process):
        return True
    return entry.stat(follow_symlinks=False).st_mtime < time.time() - _SECONDS_KEPT


def _machine() -> str:
    return f"{zlib.crc32(platform.node().encode()) & 0xFFFF:04x}"


def _may_run(process: int) -> bool:
    """Tell whether a process may be running; Windows would end it if it were asked so."""
    if sys.platform == "win32":
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:  # it runs, and belongs to somebody else
        return True
    return True
