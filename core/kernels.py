"""How the hot loops of :mod:`core` are compiled: once, here, for all of them."""

import os
from collections.abc import Callable
from typing import Any, TypeVar, TypeVarTuple

# Threads that wait for each other by spinning take the cores from the window that is drawing and
# from other programs: an iteration then costs ten times as much. Read when OpenMP is loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

import numba
import numpy as np
from numba import prange

F = TypeVar("F", bound=Callable[..., Any])
Tables = TypeVarTuple("Tables")

__all__ = ["kernel", "parallel_kernel", "prange", "unsigned"]

# ``nogil`` lets a window stay responsive beside a plain worker thread, ``cache`` keeps the machine
# code on disk, and numpy's error model gives inf and nan instead of raising in a loop.
_OPTIONS: dict[str, Any] = {"cache": True, "nogil": True, "error_model": "numpy"}


def kernel(function: F) -> F:
    """Compile a serial loop."""
    compiled: F = numba.njit(**_OPTIONS)(function)
    return compiled


def parallel_kernel(function: F) -> F:
    """Compile a loop whose ``prange`` runs on all cores."""
    compiled: F = numba.njit(parallel=True, **_OPTIONS)(function)
    return compiled


def unsigned(*numbers: *Tables) -> tuple[*Tables]:
    """View arrays of vertex or face numbers as unsigned, for a kernel that looks them up.

    A signed number may count from the end, and a compiled loop tests each one for that: a pass
    over the rings takes a fifth longer.
    """
    views: Any = tuple(np.asarray(array).view(np.uint32) for array in numbers)
    return views  # type: ignore[no-any-return]
