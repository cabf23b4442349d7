"""Compiled connectivity of edges: their numbers, and the corners opposite them."""

import numpy as np

from core.arrays import IntArray
from core.kernels import kernel, parallel_kernel, prange


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


@parallel_kernel
def winding_clashes(faces: IntArray, starts: IntArray, items: IntArray) -> int:
    """Number of edges whose two faces run along them in the same direction.

    `starts` and `items` are those of :func:`edge_corners`; edges with one face or more than two
    are left out.
    """
    clashes = 0
    for e in prange(len(starts) - 1):
        if starts[e + 1] - starts[e] == 2:
            one, other = items[starts[e]], items[starts[e] + 1]
            from_one = faces[one // 3, (one + 1) % 3]
            clashes += from_one == faces[other // 3, (other + 1) % 3]
    return clashes
