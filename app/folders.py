"""Where Burnish keeps its own files: each platform's folders for states, caches and logs."""

import shutil
import time
from contextlib import suppress
from pathlib import Path

from platformdirs import PlatformDirs

_OLD_SECONDS = 30 * 24 * 3600
_DIRS = PlatformDirs("burnish", appauthor=False)


def sessions_folder() -> Path:
    """Folder for what is kept of each window while it runs."""
    return _DIRS.user_state_path / "sessions"


def cache_folder() -> Path:
    """Folder for what can be made again: thumbnails, unpacked models."""
    return _DIRS.user_cache_path


def unpacked_folder() -> Path:
    """Folder that the models of packed studies are unpacked into."""
    return cache_folder() / "unpacked"


def log_folder() -> Path:
    """Folder for log files."""
    return _DIRS.user_log_path


def forget_old(folder: Path) -> None:
    """Remove what has lain in a folder for a month; what cannot be removed stays."""
    now = time.time()
    for entry in folder.glob("*"):
        with suppress(OSError):  # another window may be removing it
            if now - entry.lstat().st_mtime > _OLD_SECONDS:
                shutil.rmtree(entry, ignore_errors=True)
