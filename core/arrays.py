"""Names for the arrays that :mod:`core` passes around."""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

FloatArray: TypeAlias = NDArray[np.float64]
IntArray: TypeAlias = NDArray[np.int32]
BoolArray: TypeAlias = NDArray[np.bool_]


def first_rows(rows: NDArray[Any]) -> NDArray[np.int64]:
    """Numbers of the rows that equal none before them, in lexicographic order of the rows, (k,).

    What ``numpy.unique(rows, axis=0)`` finds; but that holds Python's lock while it compares rows,
    and a window beside it stands still.
    """
    order = np.lexsort(rows.T[::-1])
    ordered = rows[order]
    is_first = np.ones(len(rows), np.bool_)
    is_first[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    first: NDArray[np.int64] = order[is_first]
    return first


def frozen(array: NDArray[np.generic]) -> None:
    """Make an array read-only, in place."""
    array.flags.writeable = False
