"""Compiled loops over the elements of bands: joining, numbering and walking along them.

What an element is stands in :mod:`core.skeleton.bands`.
"""

import numpy as np

from core.arrays import BoolArray, IntArray
from core.kernels import kernel


@kernel
def crossing_starts(bands: IntArray, edges: IntArray) -> IntArray:
    """First element of each edge among the elements that are no vertices, (e + 1,)."""
    starts = np.zeros(len(edges) + 1, np.int32)
    for e in range(len(edges)):
        steps = abs(bands[edges[e, 0]] - bands[edges[e, 1]])
        starts[e + 1] = starts[e] + max(steps - 1, 0)
    return starts


@kernel
def _union(parent: IntArray, x: int, y: int) -> None:
    """Join two elements; the smaller number becomes the root, so parents never follow children."""
    while parent[x] != x:
        parent[x] = parent[parent[x]]
        x = parent[x]
    while parent[y] != y:
        parent[y] = parent[parent[y]]
        y = parent[y]
    if x < y:
        parent[y] = x
    else:
        parent[x] = y


@kernel
def _element(i: int, low: int, j: int, high: int, first: int, band: int) -> int:
    """Element in a band of the edge from vertex i in band `low` to vertex j in band `high`."""
    if band == low:
        return i
    if band == high:
        return j
    return first + band - low - 1


@kernel
def _join_within_face(
    parent: IntArray, bands: IntArray, face: IntArray, sides: IntArray, starts: IntArray
) -> None:
    """Join what the longest edge of a face has in each band to what the other edges have there."""
    m = len(bands)
    c = 0
    while bands[face[c]] > min(bands[face[(c + 1) % 3]], bands[face[(c + 2) % 3]]):
        c += 1
    i, left, right = face[c], face[(c + 1) % 3], face[(c + 2) % 3]
    long, short = sides[c], sides[(c + 2) % 3]
    if bands[left] < bands[right]:
        left, right, long, short = right, left, short, long
    low, middle, high = bands[i], bands[right], bands[left]
    for band in range(low + 1, high):
        x = _element(i, low, left, high, m + starts[long], band)
        if band <= middle:
            _union(parent, x, _element(i, low, right, middle, m + starts[short], band))
        if band >= middle:
            far = m + starts[sides[(c + 1) % 3]]
            _union(parent, x, _element(right, middle, left, high, far, band))


@kernel
def join_elements(
    bands: IntArray, edges: IntArray, faces: IntArray, face_edges: IntArray, starts: IntArray
) -> IntArray:
    """Join the elements that lie in one band of an edge or of a face; return their parents."""
    parent = np.arange(len(bands) + starts[-1]).astype(np.int32)
    for e in range(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        if bands[i] == bands[j]:
            _union(parent, i, j)
    for t in range(len(faces)):
        a, b, c = bands[faces[t, 0]], bands[faces[t, 1]], bands[faces[t, 2]]
        # A face over one or two bands has a vertex in each; its edges have joined what belongs.
        if max(a, b, c) - min(a, b, c) >= 2:
            _join_within_face(parent, bands, faces[t], face_edges[t], starts)
    return parent


@kernel
def number_roots(parent: IntArray, is_node: BoolArray) -> tuple[IntArray, IntArray]:
    """Number the roots in ascending order; return each element's number and the roots.

    A root without a mark in `is_node` (a vertex that is on no face) gets −1.
    """
    labels = np.zeros(len(parent), np.int32)
    roots = np.zeros(len(parent), np.int32)
    count = 0
    for x in range(len(parent)):
        if parent[x] != x:
            labels[x] = labels[parent[x]]
        elif x < len(is_node) and not is_node[x]:
            labels[x] = -1
        else:
            labels[x] = count
            roots[count] = x
            count += 1
    return labels, roots[:count]


@kernel
def crossing_arcs(bands: IntArray, edges: IntArray, starts: IntArray, labels: IntArray) -> IntArray:
    """Node pairs (lower, upper) met along the edges from band to band, with repetitions, (c, 2)."""
    count = 0
    for e in range(len(edges)):
        count += abs(bands[edges[e, 0]] - bands[edges[e, 1]])
    pairs = np.zeros((count, 2), np.int32)
    slot = 0
    for e in range(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        if bands[i] == bands[j]:
            continue
        if bands[i] > bands[j]:
            i, j = j, i
        pairs[slot, 0] = labels[i]
        for x in range(len(bands) + starts[e], len(bands) + starts[e + 1]):
            pairs[slot, 1] = labels[x]
            pairs[slot + 1, 0] = labels[x]
            slot += 1
        pairs[slot, 1] = labels[j]
        slot += 1
    return pairs


@kernel
def face_pieces(
    bands: IntArray,
    edges: IntArray,
    faces: IntArray,
    face_edges: IntArray,
    starts: IntArray,
    labels: IntArray,
) -> tuple[IntArray, IntArray]:
    """Nodes of each face from its lowest band upwards, as CSR starts and items."""
    n = len(faces)
    piece_starts = np.zeros(n + 1, np.int32)
    for t in range(n):
        a, b, c = bands[faces[t, 0]], bands[faces[t, 1]], bands[faces[t, 2]]
        piece_starts[t + 1] = piece_starts[t] + max(a, b, c) - min(a, b, c) + 1
    nodes = np.zeros(piece_starts[-1], np.int32)
    for t in range(n):
        low, last = piece_starts[t], piece_starts[t + 1] - 1
        for c in range(3):
            i, j = faces[t, c], faces[t, (c + 1) % 3]
            # The edge from the lowest to the highest band passes through all of them.
            if abs(bands[j] - bands[i]) == last - low:
                e = face_edges[t, c]
                nodes[low] = labels[i if bands[i] < bands[j] else j]
                nodes[last] = labels[j if bands[i] < bands[j] else i]
                for slot in range(low + 1, last):
                    nodes[slot] = labels[len(bands) + starts[e] + slot - low - 1]
                break
    return piece_starts, nodes
