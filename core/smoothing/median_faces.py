"""The face of each ring whose normal makes the median angle, for rings of any length."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange
from core.lanes import xyz
from core.smoothing.selection import select

# Faces a thread handles before it needs new tables: enough to make the tables free, few enough to
# share the work evenly.
_BLOCK = 2048
# Where that is most of all there are, each share is smaller: so many, for any number of threads.
_SHARES = 16
# Faces whose rings are sorted side by side: enough for the inner loop to be vector instructions.
_COLUMNS = 64
# Longest ring that is sorted, which takes the square of its length; of longer ones the median is
# selected, which takes its length: all faces around one vertex are each other's rings.
_LONGEST_SORTED = 64
# A cosine of no angle, which fills the columns of shorter rings.
_BELOW_ALL = -2.0


@kernel
def _longest_row(starts: IntArray, first: int, last: int) -> int:
    length = 0
    for t in range(first, last):
        length = max(length, int(np.intp(starts[t + 1] - starts[t])))
    return length


@kernel
def _fill_columns(
    columns: FloatArray,
    counts: IntArray,
    normals: FloatArray,
    own: FloatArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
) -> None:
    """Note the cosines of the angles between some faces and their rings, a column a face.

    `own` are the normals of the faces that have a row. A face without a normal makes no angle, so
    it does not count.
    """
    columns[:] = _BELOW_ALL
    for t in range(first, last):
        x, y, z = xyz(own, t)
        column, count = t - first, 0
        for k in range(starts[t], starts[t + 1]):
            a, b, c = xyz(normals, items[k])
            cosine = x * a + y * b + z * c
            if cosine != 0 or a != 0 or b != 0 or c != 0:
                columns[k - starts[t], column] = cosine
                count += 1
        counts[column] = count


@kernel
def _sort_upper_half(columns: FloatArray, height: int) -> None:
    """Bring the larger half of each column to its top, in descending order.

    A selection sort that swaps without branches, on all columns at once.
    """
    for top in range((height + 1) // 2):
        for slot in range(top + 1, height):
            for column in range(columns.shape[1]):
                upper, lower = columns[top, column], columns[slot, column]
                columns[top, column] = upper if upper > lower else lower
                columns[slot, column] = lower if upper > lower else upper


@kernel
def _find_medians(
    cosines: FloatArray, columns: FloatArray, counts: IntArray, height: int, slots: FloatArray
) -> None:
    """Note the first slot of each column that holds its lower median, from the sorted columns."""
    slots[:] = 0
    medians = np.empty(_COLUMNS)
    for column in range(_COLUMNS):
        medians[column] = columns[max(counts[column] - 1, 0) // 2, column]
    for slot in range(height - 1, -1, -1):
        _note_equal(cosines[slot], medians, slot, slots)


@kernel
def _note_equal(row: FloatArray, medians: FloatArray, slot: float, slots: FloatArray) -> None:
    """Note a slot, as wide as a cosine, without branches, so that vector instructions do it."""
    for column in range(len(row)):
        slots[column] = slot if row[column] == medians[column] else slots[column]


@kernel
def _set_by_sorting(
    normals: FloatArray,
    own: FloatArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
    cosines: FloatArray,
    columns: FloatArray,
    counts: IntArray,
    slots: FloatArray,
    medians: IntArray,
) -> None:
    """Note the median faces of some faces with short rings; four tables are scratch."""
    height = len(cosines)
    _fill_columns(cosines, counts, normals, own, first, last, starts, items)
    columns[:] = cosines
    _sort_upper_half(columns, height)
    _find_medians(cosines, columns, counts, height, slots)
    for t in range(first, last):
        if counts[t - first] > 0:
            medians[t] = items[starts[t] + np.uint32(slots[t - first])]


@kernel
def _set_by_selecting(
    normals: FloatArray,
    own: FloatArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
    longest: int,
    counts: IntArray,
    medians: IntArray,
) -> None:
    """Note the median faces of some faces with rings of any length; one table is scratch."""
    cosines, spare = np.empty((longest, 1)), np.empty(longest)
    for t in range(first, last):
        ring = items[starts[t] : starts[t + 1]]
        row = cosines[: len(ring)]
        _fill_columns(row, counts, normals, own, t, t + 1, starts, items)
        if counts[0] == 0:
            continue
        spare[: len(ring)] = row[:, 0]
        median = select(spare[: len(ring)], len(ring) - 1 - (counts[0] - 1) // 2)
        for slot, other in enumerate(ring):
            if row[slot, 0] == median:
                medians[t] = other
                break


@parallel_kernel
def set_median_faces(
    normals: FloatArray, first: int, starts: IntArray, items: IntArray, medians: IntArray
) -> None:
    """Note the face of each ring whose normal makes the lower median angle with its face's, (n,).

    For the faces from `first` on that the rings are given of. A face without a ring is its own.
    Ascending angles are descending cosines.
    """
    n = len(starts) - 1
    own, found = normals[first : first + n], medians[first : first + n]
    found[:] = np.arange(first, first + n)
    share = min(_BLOCK, (n // (_SHARES * _COLUMNS) + 1) * _COLUMNS)
    for block in prange((n + share - 1) // share):
        cosines = np.empty((_LONGEST_SORTED, _COLUMNS))
        columns = np.empty((_LONGEST_SORTED, _COLUMNS))
        counts, slots = np.zeros(_COLUMNS, np.int32), np.zeros(_COLUMNS)
        for low in range(block * share, min((block + 1) * share, n), _COLUMNS):
            high = min(low + _COLUMNS, n)
            rows = low, high, starts, items
            height = _longest_row(starts, low, high)
            if height > _LONGEST_SORTED:
                _set_by_selecting(normals, own, *rows, height, counts, found)
            else:
                tables = cosines[:height], columns[:height], counts, slots
                _set_by_sorting(normals, own, *rows, *tables, found)
