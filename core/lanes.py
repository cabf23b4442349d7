"""One mesh or eight of the same faces at once, for kernels that are written for one.

Eight meshes stand side by side in the last place of an array: positions are (m, 3) or (m, 3, 8),
numbers of vertices (m,) or (m, 8). A kernel reads and writes them with the functions here. Of one
mesh it gets plain numbers; of eight it gets :data:`Lanes`, one vector of the processor or two, so
that one instruction does for many meshes what it does for one, and the numbers of neighbours and
corners are read once. Both are the same formula in the same order, so both give the same results.

The compiler does not find vectors by itself in loops over rings. :mod:`core.lane_code` says what
each of these functions is compiled to; they can be called in kernels only.
"""

from collections.abc import Callable, Sequence
from typing import Any, SupportsIndex, TypeAlias

import numpy as np

from core.arrays import FloatArray
from core.kernels import parallel_kernel, prange

__all__ = ["WIDTH", "Lanes", "Point", "row", "set_row", "side_by_side", "totals", "xyz"]

WIDTH = 8
"""So many meshes stand side by side."""

Lanes: TypeAlias = float
"""A number or eight. Each of eight is added, subtracted, multiplied and divided with its own, or
all with one number; to who checks types both are one."""

Point: TypeAlias = tuple[Lanes, Lanes, Lanes]
"""x, y and z."""


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


xyz: Callable[[FloatArray, SupportsIndex], Point] = _in_kernels("xyz")
"""The x, the y and the z of vertex i, of positions (m, 3) or (m, 3, 8) in C order."""

row: Callable[[FloatArray, SupportsIndex], Lanes] = _in_kernels("row")
"""Number i of an array (m,), or row i of one (m, 8) in C order."""

set_row: Callable[[FloatArray, SupportsIndex, Lanes], None] = _in_kernels("set_row")
"""Write what :data:`row` reads."""


@parallel_kernel
def _interleave(rows: FloatArray, columns: tuple[FloatArray, ...]) -> None:
    """Note eight arrays (k,) as the columns of one (k, 8)."""
    for i in prange(np.uint64(len(rows))):
        for k in range(WIDTH):
            rows[i, k] = columns[k][i]


def _flat(mesh: FloatArray) -> FloatArray:
    """All coordinates in a row, read-only: all that stand side by side are of one kind."""
    flat: FloatArray = np.ravel(mesh).view()
    flat.flags.writeable = False
    return flat


def side_by_side(meshes: Sequence[FloatArray], room: FloatArray | None = None) -> FloatArray:
    """Return the positions (m, 3) of one to eight meshes as evaluators take them.

    Those of one as they are, those of more as (m, 3, 8), where the last one fills up. `room` is
    where the latter are put, if it is given.
    """
    if len(meshes) == 1:
        return np.ascontiguousarray(meshes[0])
    positions = np.empty((len(meshes[0]), 3, WIDTH)) if room is None else room
    filled = [*meshes, *[meshes[-1]] * (WIDTH - len(meshes))]
    _interleave(positions.reshape(-1, WIDTH), tuple(_flat(mesh) for mesh in filled))
    return positions


def totals(sums: FloatArray) -> FloatArray:
    """Return the sum of numbers (k,), or of each column of (k, 8) in the same order."""
    result: FloatArray = np.ascontiguousarray(sums.T).sum(axis=-1)
    return result
