"""Four numbers side by side, for kernels: the x, y and z of a vertex and one number more.

They are one vector of the processor, so a kernel that follows rings takes one instruction where
three coordinates take three. The compiler does not find that by itself: numba leaves LLVM's
vectoriser for straight-line code off, because it has miscompiled. :mod:`core.lane_code` says what
each of these functions is compiled to; they can be called in kernels only.
"""

from collections.abc import Callable
from typing import Any, Protocol

from core.arrays import FloatArray

__all__ = ["Lanes", "every", "numbers", "row", "set_row", "turned", "with_fourth", "xyz"]


class Lanes(Protocol):
    """Four numbers, added, subtracted and multiplied each with its own."""

    def __add__(self, other: "Lanes") -> "Lanes": ...
    def __sub__(self, other: "Lanes") -> "Lanes": ...
    def __mul__(self, other: "Lanes") -> "Lanes": ...


class _InKernels:
    """Stands for a function of :mod:`core.lane_code` until a kernel that calls it is compiled.

    Until then, as with kernels, numba is not imported.
    """

    def __init__(self, name: str) -> None:
        self._name = name

    @property
    def _numba_type_(self) -> Any:
        from numba.core.registry import cpu_target  # noqa: PLC0415 - see above

        from core import lane_code  # noqa: PLC0415 - imports numba

        # The compiler that asks has made its list of what it knows before the import.
        cpu_target.typing_context.refresh()
        cpu_target.target_context.refresh()
        return cpu_target.typing_context.resolve_value_type(getattr(lane_code, self._name))


def _in_kernels(name: str) -> Any:
    return _InKernels(name)


xyz: Callable[[FloatArray, int], Lanes] = _in_kernels("xyz")
"""Row i of an (m, 3) array in C order, and 0."""

row: Callable[[FloatArray, int], Lanes] = _in_kernels("row")
"""Row i of an (m, 4) array in C order."""

set_row: Callable[[FloatArray, int, Lanes], None] = _in_kernels("set_row")
"""Write row i of an (m, 4) array in C order."""

every: Callable[[float], Lanes] = _in_kernels("every")
"""One number four times."""

with_fourth: Callable[[Lanes, float], Lanes] = _in_kernels("with_fourth")
"""The x, y and z of lanes, and a number."""

turned: Callable[[Lanes], Lanes] = _in_kernels("turned")
"""y, z, x and the fourth; ``a * turned(b) - turned(a) * b`` is z, x, y of the cross product."""

numbers: Callable[[Lanes], tuple[float, float, float, float]] = _in_kernels("numbers")
"""The four numbers one by one."""
