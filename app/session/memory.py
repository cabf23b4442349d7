"""Memory of the machine, and the share of it that results may take."""

import os

_MEGABYTE = 1024**2
_UNKNOWN = 8 * 1024**3


def machine_memory() -> int:
    """Return the machine's memory in bytes; 8 GB where the system does not tell."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        return _UNKNOWN


def default_budget() -> int:
    """Return a quarter of the machine's memory, in whole megabytes."""
    return machine_memory() // 4 // _MEGABYTE * _MEGABYTE
