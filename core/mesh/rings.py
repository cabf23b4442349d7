"""Compiled connectivity: who touches whom, as compressed sparse rows (CSR).

A CSR table is a pair ``(starts, items)``; row i is ``items[starts[i]:starts[i + 1]]``.
All rows are in ascending order, so results never depend on the number of threads.
"""

import numpy as np

from core.arrays import IntArray
from core.kernels import kernel, parallel_kernel, prange

# Longest ring of a face that is merged one by one.
_LONG_ROW = 64


@kernel
def vertex_faces(faces: IntArray, vertex_count: int) -> tuple[IntArray, IntArray]:
    """Faces around each vertex, by counting sort."""
    starts = np.zeros(vertex_count + 1, np.int32)
    for corner in faces.ravel():
        starts[corner + 1] += 1
    for i in range(vertex_count):
        starts[i + 1] += starts[i]
    items = np.zeros(faces.size, np.int32)
    free = starts[:-1].copy()
    for t in range(len(faces)):
        for c in range(3):
            corner = faces[t, c]
            items[free[corner]] = t
            free[corner] += 1
    return starts, items


@kernel
def sort_unique(values: IntArray) -> int:
    """Sort `values` in place, put the distinct ones first and return their number.

    Shell's sort with Knuth's gaps: for a few values it is sorting by insertion, and no order of
    very many takes the square of their number.
    """
    gap = 1
    while gap < len(values) // 9:
        gap = 3 * gap + 1
    while gap > 0:
        for a in range(gap, len(values)):
            value = values[a]
            b = a - gap
            while b >= 0 and values[b] > value:
                values[b + gap] = values[b]
                b -= gap
            values[b + gap] = value
        gap //= 3
    count = 0
    for value in values:
        if count == 0 or values[count - 1] != value:
            values[count] = value
            count += 1
    return count


@kernel
def running_sum(counts: IntArray) -> IntArray:
    """Row starts from row lengths."""
    starts = np.zeros(len(counts) + 1, np.int32)
    for i in range(len(counts)):
        starts[i + 1] = starts[i] + counts[i]
    return starts


@parallel_kernel
def _closed_up(room: IntArray, counts: IntArray, scratch: IntArray) -> tuple[IntArray, IntArray]:
    """CSR table of the rows that fill the first `counts` places of the `room` given to each."""
    starts = running_sum(counts)
    items = np.empty(starts[-1], np.int32)
    for i in prange(len(counts)):
        items[starts[i] : starts[i + 1]] = scratch[room[i] : room[i] + counts[i]]
    return starts, items


@parallel_kernel
def vertex_ring(
    faces: IntArray, face_starts: IntArray, face_items: IntArray
) -> tuple[IntArray, IntArray]:
    """Distinct neighbours of each vertex."""
    m = len(face_starts) - 1
    room = 2 * face_starts
    scratch = np.empty(room[-1], np.int32)
    counts = np.zeros(m, np.int32)
    for i in prange(m):
        last = room[i]
        for t in face_items[face_starts[i] : face_starts[i + 1]]:
            for c in range(3):
                corner = faces[t, c]
                if corner != i:
                    scratch[last] = corner
                    last += 1
        counts[i] = sort_unique(scratch[room[i] : last])
    return _closed_up(room, counts, scratch)


@kernel
def _merge_rows(faces: IntArray, t: int, starts: IntArray, items: IntArray, out: IntArray) -> None:
    """Merge the three sorted face rows at the corners of face t into `out`, without t.

    What a long row holds before the next of the others is copied at one go.
    """
    i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
    is_long = len(out) > _LONG_ROW
    if is_long and starts[j + 1] - starts[j] > starts[i + 1] - starts[i]:
        i, j = j, i
    if is_long and starts[k + 1] - starts[k] > starts[i + 1] - starts[i]:
        i, k = k, i
    a, b, c = starts[i], starts[j], starts[k]
    a_end, b_end, c_end = starts[i + 1], starts[j + 1], starts[k + 1]
    count = 0
    limit = np.int32(2**31 - 1)
    while a < a_end or b < b_end or c < c_end:
        head_a = items[a] if a < a_end else limit
        head_b = items[b] if b < b_end else limit
        head_c = items[c] if c < c_end else limit
        smallest = min(head_a, head_b, head_c)
        a += head_a == smallest
        b += head_b == smallest
        c += head_c == smallest
        if smallest != t:
            out[count] = smallest
            count += 1
        if is_long:
            next_b = items[b] if b < b_end else limit
            next_c = items[c] if c < c_end else limit
            while a < a_end and items[a] < min(next_b, next_c):
                if items[a] != t:
                    out[count] = items[a]
                    count += 1
                a += 1


@parallel_kernel
def face_ring(
    faces: IntArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
    edges_of_faces: IntArray,
    corner_starts: IntArray,
    corner_items: IntArray,
) -> tuple[IntArray, IntArray]:
    """Faces that share a vertex or an edge with each face from `first` on, up to `last`.

    Without the face itself (t*). `starts` and `items` are the faces of each vertex.
    """
    counts = np.zeros(last - first, np.int32)
    for i in prange(last - first):
        t = first + i
        counts[i] = _ring_length(faces, t, starts, edges_of_faces, corner_starts, corner_items)
    row_starts = running_sum(counts)
    row_items = np.empty(row_starts[-1], np.int32)
    for i in prange(last - first):
        row = row_items[row_starts[i] : row_starts[i + 1]]
        _merge_rows(faces, first + i, starts, items, row)
    return row_starts, row_items


@kernel
def _ring_length(
    faces: IntArray,
    t: int,
    starts: IntArray,
    edges_of_faces: IntArray,
    corner_starts: IntArray,
    corner_items: IntArray,
) -> int:
    """Length of the ring of face t, from the numbers of faces at its vertices and edges.

    The faces at its vertices count those with a common edge twice, which the faces at its edges
    put right; but a face with the same three corners is then counted three times and taken away
    three times.
    """
    total = 0
    for c in range(3):
        total += starts[faces[t, c] + 1] - starts[faces[t, c]]
        edge = edges_of_faces[t, c]
        total -= corner_starts[edge + 1] - corner_starts[edge]
    edge = edges_of_faces[t, 0]
    for corner in corner_items[corner_starts[edge] : corner_starts[edge + 1]]:
        twin = corner // 3 != t and faces[corner // 3, corner % 3] == faces[t, 2]
        total += twin
    return total
