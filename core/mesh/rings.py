"""Compiled connectivity: who touches whom, as compressed sparse rows (CSR).

A CSR table is a pair ``(starts, items)``; row i is ``items[starts[i]:starts[i + 1]]``.
All rows are in ascending order, so results never depend on the number of threads.
"""

import numpy as np

from core.arrays import IntArray
from core.kernels import kernel, parallel_kernel, prange


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
        for corner in faces[t]:
            items[free[corner]] = t
            free[corner] += 1
    return starts, items


@kernel
def sort_unique(values: IntArray) -> int:
    """Sort `values` in place, put the distinct ones first and return their number."""
    if len(values) > 32:
        values.sort()
    else:
        for a in range(1, len(values)):
            value = values[a]
            b = a - 1
            while b >= 0 and values[b] > value:
                values[b + 1] = values[b]
                b -= 1
            values[b + 1] = value
    count = 0
    for value in values:
        if count == 0 or values[count - 1] != value:
            values[count] = value
            count += 1
    return count


@parallel_kernel
def _gather_rings(
    faces: IntArray, face_starts: IntArray, face_items: IntArray
) -> tuple[IntArray, IntArray]:
    m = len(face_starts) - 1
    scratch = np.zeros(2 * len(face_items), np.int32)
    counts = np.zeros(m, np.int32)
    for i in prange(m):
        first = 2 * face_starts[i]
        last = first
        for t in face_items[face_starts[i] : face_starts[i + 1]]:
            for corner in faces[t]:
                if corner != i:
                    scratch[last] = corner
                    last += 1
        counts[i] = sort_unique(scratch[first:last])
    return scratch, counts


@kernel
def running_sum(counts: IntArray) -> IntArray:
    """Row starts from row lengths."""
    starts = np.zeros(len(counts) + 1, np.int32)
    for i in range(len(counts)):
        starts[i + 1] = starts[i] + counts[i]
    return starts


@kernel
def vertex_ring(
    faces: IntArray, face_starts: IntArray, face_items: IntArray
) -> tuple[IntArray, IntArray]:
    """Distinct neighbours of each vertex."""
    scratch, counts = _gather_rings(faces, face_starts, face_items)
    starts = running_sum(counts)
    items = np.zeros(starts[-1], np.int32)
    for i in range(len(counts)):
        first = 2 * face_starts[i]
        items[starts[i] : starts[i + 1]] = scratch[first : first + counts[i]]
    return starts, items


@kernel
def number_edges(starts: IntArray, items: IntArray) -> tuple[IntArray, IntArray]:
    """Edges (i < j) in lexicographic order, and the edge number of every ring entry."""
    m = len(starts) - 1
    edges = np.zeros((len(items) // 2, 2), np.int32)
    ring_edges = np.zeros(len(items), np.int32)
    seen = starts[:-1].copy()
    count = 0
    for i in range(m):
        for slot in range(starts[i], starts[i + 1]):
            j = items[slot]
            if j < i:
                continue
            edges[count, 0] = i
            edges[count, 1] = j
            ring_edges[slot] = count
            # Row j meets its smaller neighbours in ascending order, so its next free slot is i's.
            ring_edges[seen[j]] = count
            seen[j] += 1
            count += 1
    return edges, ring_edges


@parallel_kernel
def face_edges(
    faces: IntArray, starts: IntArray, items: IntArray, ring_edges: IntArray
) -> IntArray:
    """Edge numbers of each face; entry c is the edge from corner c to corner c + 1."""
    result = np.zeros((len(faces), 3), np.int32)
    for t in prange(len(faces)):
        for c in range(3):
            i = faces[t, c]
            j = faces[t, (c + 1) % 3]
            row = items[starts[i] : starts[i + 1]]
            result[t, c] = ring_edges[starts[i] + np.searchsorted(row, j)]
    return result


@kernel
def edge_corners(edges_of_faces: IntArray, edge_count: int) -> tuple[IntArray, IntArray]:
    """Corners (3·face + corner) opposite each edge, one for each face at the edge."""
    starts = np.zeros(edge_count + 1, np.int32)
    for edge in edges_of_faces.ravel():
        starts[edge + 1] += 1
    for e in range(edge_count):
        starts[e + 1] += starts[e]
    items = np.zeros(edges_of_faces.size, np.int32)
    free = starts[:-1].copy()
    for t in range(len(edges_of_faces)):
        for c in range(3):
            edge = edges_of_faces[t, c]
            items[free[edge]] = 3 * t + (c + 2) % 3
            free[edge] += 1
    return starts, items


@kernel
def _merge_rows(faces: IntArray, t: int, starts: IntArray, items: IntArray, out: IntArray) -> int:
    """Merge the three sorted face rows at the corners of face t, without t; return the count."""
    a, b, c = starts[faces[t, 0]], starts[faces[t, 1]], starts[faces[t, 2]]
    a_end, b_end, c_end = (
        starts[faces[t, 0] + 1],
        starts[faces[t, 1] + 1],
        starts[faces[t, 2] + 1],
    )
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
            if len(out) > 0:
                out[count] = smallest
            count += 1
    return count


@parallel_kernel
def face_ring(faces: IntArray, starts: IntArray, items: IntArray) -> tuple[IntArray, IntArray]:
    """Faces that share a vertex or an edge with each face, without the face itself (t*)."""
    n = len(faces)
    counts = np.zeros(n, np.int32)
    nothing = np.zeros(0, np.int32)
    for t in prange(n):
        counts[t] = _merge_rows(faces, t, starts, items, nothing)
    row_starts = running_sum(counts)
    row_items = np.zeros(max(row_starts[-1], 1), np.int32)[: row_starts[-1]]
    for t in prange(n):
        _merge_rows(faces, t, starts, items, row_items[row_starts[t] : row_starts[t + 1]])
    return row_starts, row_items


@kernel
def orientation(
    faces: IntArray,
    edges_of_faces: IntArray,
    corner_starts: IntArray,
    corner_items: IntArray,
) -> tuple[IntArray, bool, bool]:
    """Component number of each face across edges with two faces, and the state of its winding.

    Returns the component numbers, whether the faces can be wound consistently (the surface is
    orientable) and whether they are.
    """
    n = len(faces)
    component = np.full(n, -1, np.int32)
    flipped = np.zeros(n, np.bool_)
    stack = np.zeros(max(n, 1), np.int32)
    orientable, consistent = True, True
    number = -1
    for seed in range(n):
        if component[seed] >= 0:
            continue
        number += 1
        component[seed] = number
        stack[0] = seed
        top = 1
        while top > 0:
            top -= 1
            t = stack[top]
            for c in range(3):
                edge = edges_of_faces[t, c]
                if corner_starts[edge + 1] - corner_starts[edge] != 2:
                    continue
                first, second = (
                    corner_items[corner_starts[edge]],
                    corner_items[corner_starts[edge] + 1],
                )
                corner = second if first // 3 == t else first
                other = corner // 3
                # Two consistently wound faces run along their common edge in opposite directions.
                same_way = faces[t, c] == faces[other, (corner + 1) % 3]
                consistent = consistent and not same_way
                if component[other] < 0:
                    component[other] = number
                    flipped[other] = flipped[t] != same_way
                    stack[top] = other
                    top += 1
                elif flipped[other] != (flipped[t] != same_way):
                    orientable = False
    return component, orientable, consistent


@parallel_kernel
def fan_counts(faces: IntArray, starts: IntArray, items: IntArray) -> IntArray:
    """Number of fans (faces joined by edges) around each vertex; a manifold has one."""
    m = len(starts) - 1
    fans = np.zeros(m, np.int32)
    for i in prange(m):
        row = items[starts[i] : starts[i + 1]]
        fans[i] = _count_fans(faces, row, i)
    return fans


@kernel
def _count_fans(faces: IntArray, row: IntArray, i: int) -> int:
    """Count the connected pieces of the link of vertex i, by union-find over its edges."""
    d = len(row)
    ends = np.zeros(2 * d, np.int32)
    for a in range(d):
        slot = 2 * a
        for corner in faces[row[a]]:
            if corner != i:
                ends[slot] = corner
                slot += 1
    names = ends.copy()
    count = sort_unique(names)
    parent = np.arange(count)
    pieces = count
    for a in range(d):
        x = np.searchsorted(names[:count], ends[2 * a])
        y = np.searchsorted(names[:count], ends[2 * a + 1])
        while parent[x] != x:
            parent[x] = parent[parent[x]]
            x = parent[x]
        while parent[y] != y:
            parent[y] = parent[parent[y]]
            y = parent[y]
        if x != y:
            parent[x] = y
            pieces -= 1
    return pieces
