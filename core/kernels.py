"""How the hot loops of :mod:`core` are compiled: once, here, for all of them."""

import os
from collections.abc import Callable
from functools import cached_property, update_wrapper
from typing import Any, TypeVar, TypeVarTuple, cast

import numpy as np

# Threads that wait for each other by spinning take the cores from the window that is drawing and
# from other programs: an iteration then costs ten times as much. Read when OpenMP is loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

F = TypeVar("F", bound=Callable[..., Any])
Tables = TypeVarTuple("Tables")

__all__ = [
    "ONE",
    "Kernel",
    "fused_kernel",
    "fused_parallel_kernel",
    "kernel",
    "parallel_kernel",
    "prange",
    "unsigned",
]

# ``nogil`` lets a window stay responsive beside a plain worker thread, ``cache`` keeps the machine
# code on disk, and numpy's error model gives inf and nan instead of raising in a loop.
_OPTIONS: dict[str, Any] = {"cache": True, "nogil": True, "error_model": "numpy"}

ONE = np.uint64(1)
"""What to add to an unsigned number in a kernel: with a plain 1 numba makes it a float."""

prange = range
"""Range of a parallel loop; numba's takes its place where a kernel is compiled."""


class Kernel:
    """A loop that is compiled, or its machine code read, when it is first called.

    Until then numba is not imported: that takes as long as showing the window.

    Parameters
    ----------
    function : callable
        The loop.
    options : dict
        What numba is told beside :data:`_OPTIONS`.
    """

    def __init__(self, function: Callable[..., Any], **options: Any) -> None:
        self._function, self._options = function, _OPTIONS | options
        update_wrapper(self, function)

    def __call__(self, *arguments: Any) -> Any:
        """Run the loop."""
        return self.dispatcher(*arguments)

    @cached_property
    def dispatcher(self) -> Any:
        """What numba makes of the loop."""
        import numba

        names = self._function.__globals__
        if names.get("prange") is prange:
            names["prange"] = numba.prange
        return numba.njit(**self._options)(self._function)

    @property
    def _numba_type_(self) -> Any:
        """By what numba knows a kernel that another one calls."""
        from numba import typeof

        return typeof(self.dispatcher)


def kernel(function: F) -> F:
    """Compile a serial loop."""
    return cast("F", Kernel(function))


def fused_kernel(function: F) -> F:
    """Compile a loop or formula whose x·y + z is rounded once, where the processor can do so.

    For sums of many products. A difference of equal products may then be other than zero. A plain
    kernel that is first compiled because this one calls it is fused too.
    """
    return cast("F", Kernel(function, fastmath={"contract"}))


def parallel_kernel(function: F) -> F:
    """Compile a loop whose ``prange`` runs on all cores."""
    return cast("F", Kernel(function, parallel=True))


def fused_parallel_kernel(function: F) -> F:
    """Compile as :func:`parallel_kernel`, with products and sums as in :func:`fused_kernel`."""
    return cast("F", Kernel(function, parallel=True, fastmath={"contract"}))


def unsigned(*numbers: *Tables) -> tuple[*Tables]:
    """View arrays of vertex or face numbers as unsigned, for a kernel that looks them up.

    A signed number may count from the end, and a compiled loop tests each one for that: a pass
    over the rings takes a fifth longer.
    """
    views: Any = tuple(np.asarray(array).view(np.uint32) for array in numbers)
    return views  # type: ignore[no-any-return]
