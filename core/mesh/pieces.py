"""How a surface hangs together: components, sides, and fans of faces around a vertex."""

import numpy as np

from core.arrays import BoolArray, IntArray
from core.kernels import kernel, parallel_kernel, prange

# Vertices a thread handles with one buffer.
_BLOCK = 4096


@kernel
def vertex_components(starts: IntArray, items: IntArray) -> IntArray:
    """Number of the connected component of each vertex, in the order of their first vertices."""
    m = len(starts) - 1
    component = np.full(m, -1, np.int32)
    stack = np.zeros(m, np.int32)
    number = -1
    for seed in range(m):
        if component[seed] >= 0:
            continue
        number += 1
        component[seed] = number
        stack[0] = seed
        top = 1
        while top > 0:
            top -= 1
            i = stack[top]
            for j in items[starts[i] : starts[i + 1]]:
                if component[j] < 0:
                    component[j] = number
                    stack[top] = j
                    top += 1
    return component


@kernel
def is_orientable(
    faces: IntArray, edges_of_faces: IntArray, corner_starts: IntArray, corner_items: IntArray
) -> bool:
    """Whether the faces can be wound consistently across every edge with two faces.

    Walks over the surface and notes which faces would have to be turned round.
    """
    n = len(faces)
    seen = np.zeros(n, np.bool_)
    flipped = np.zeros(n, np.bool_)
    stack = np.zeros(max(n, 1), np.int32)
    for seed in range(n):
        if seen[seed]:
            continue
        seen[seed] = True
        stack[0] = seed
        top = 1
        while top > 0:
            top -= 1
            t = stack[top]
            for c in range(3):
                edge = edges_of_faces[t, c]
                start = corner_starts[edge]
                if corner_starts[edge + 1] - start != 2:
                    continue
                first, second = corner_items[start], corner_items[start + 1]
                corner = second if first // 3 == t else first
                other = corner // 3
                # Two consistently wound faces run along their common edge in opposite directions.
                turned = flipped[t] != (faces[t, c] == faces[other, (corner + 1) % 3])
                if not seen[other]:
                    seen[other] = True
                    flipped[other] = turned
                    stack[top] = other
                    top += 1
                elif flipped[other] != turned:
                    return False
    return True


@parallel_kernel
def pinched_vertices(
    faces: IntArray,
    face_starts: IntArray,
    face_items: IntArray,
    starts: IntArray,
    items: IntArray,
    longest: int,
) -> BoolArray:
    """Mask of the vertices whose faces form more than one fan (faces joined by edges), (m,).

    `longest` is the length of the longest vertex ring.
    """
    m = len(starts) - 1
    pinched = np.zeros(m, np.bool_)
    for block in prange((m + _BLOCK - 1) // _BLOCK):
        parent = np.zeros(longest, np.int32)
        for i in range(block * _BLOCK, min((block + 1) * _BLOCK, m)):
            around = face_items[face_starts[i] : face_starts[i + 1]]
            pinched[i] = _fans(faces, around, i, items[starts[i] : starts[i + 1]], parent) > 1
    return pinched


@kernel
def _fans(faces: IntArray, around: IntArray, i: int, ring: IntArray, parent: IntArray) -> int:
    """Count the connected pieces of the link of vertex i, by union-find over its edges."""
    for slot in range(len(ring)):
        parent[slot] = slot
    pieces = len(ring)
    for t in around:
        a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
        x = _root(parent, np.searchsorted(ring, b if a == i else a))
        y = _root(parent, np.searchsorted(ring, b if c == i else c))
        pieces -= x != y
        parent[x] = y
    return pieces


@kernel
def _root(parent: IntArray, slot: int) -> int:
    """Name of the piece that an entry belongs to; shortens the way for the next time."""
    while parent[slot] != slot:
        parent[slot] = parent[parent[slot]]
        slot = parent[slot]
    return slot
