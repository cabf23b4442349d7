"""Joining equal positions, for formats that repeat a vertex for each of its faces."""

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray
from core.io.polygons import Numbers
from core.kernels import kernel

# Odd numbers without a pattern in their bits, one for each coordinate.
_MIX = np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9], np.uint64)
_SHIFT = np.uint64(29)


def merge_equal(positions: FloatArray) -> tuple[FloatArray, Numbers]:
    """Join equal positions.

    Parameters
    ----------
    positions : (s, 3) float64 ndarray
        Positions, some of them equal.

    Returns
    -------
    vertices : (m, 3) float64 ndarray
        Different positions, in the order of first appearance.
    numbers : (s,) int64 ndarray
        Row of `vertices` that each position became.
    """
    plain = np.ascontiguousarray(positions + 0.0)  # −0 and 0 are the same place
    slots = 1 << max(2 * len(plain), 2).bit_length()
    first = _first_equal(plain.view(np.uint64), np.full(slots, -1, np.int32))
    keep = first == np.arange(len(plain))
    return plain[keep], (np.cumsum(keep) - 1)[first]


@kernel
def _first_equal(keys: NDArray[np.uint64], table: IntArray) -> IntArray:
    """Row of the first equal key of each key, (s,); `table` is 2ᵏ free places for more than 2s."""
    first = np.zeros(len(keys), np.int32)
    last = len(table) - 1
    for i in range(len(keys)):
        a, b, c = keys[i, 0], keys[i, 1], keys[i, 2]
        mixed = a * _MIX[0] ^ b * _MIX[1] ^ c * _MIX[2]
        mixed = (mixed ^ (mixed >> _SHIFT)) * _MIX[0]
        place = np.int64(mixed >> _SHIFT) & last
        while table[place] >= 0:
            other = table[place]
            if keys[other, 0] == a and keys[other, 1] == b and keys[other, 2] == c:
                break
            place = (place + 1) & last
        if table[place] < 0:
            table[place] = i
        first[i] = table[place]
    return first
