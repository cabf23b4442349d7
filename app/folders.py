"""Where Burnish keeps its own files: each platform's folders for states, caches and logs."""

from pathlib import Path

from platformdirs import PlatformDirs

_DIRS = PlatformDirs("burnish", appauthor=False)


def state_folder() -> Path:
    """Folder for what is kept of a session while it runs."""
    return _DIRS.user_state_path


def cache_folder() -> Path:
    """Folder for what can be made again: thumbnails, unpacked models."""
    return _DIRS.user_cache_path


def log_folder() -> Path:
    """Folder for log files."""
    return _DIRS.user_log_path
