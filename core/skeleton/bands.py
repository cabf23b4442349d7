"""Connected pieces of the surface between two levels, and which of them touch.

The levels cut the faces. Band k is half open: a vertex exactly on a level belongs to the band
above it, which is the same as lowering every level by an amount too small to matter. So no
level ever runs through a vertex, plateaus stay whole, and the bands follow from the vertices'
bands alone, in whole numbers.

Every component of a band contains a vertex or crosses an edge between its ends. The *elements*
are therefore the vertices, numbered first, and one for each band that an edge crosses strictly
between the bands of its ends.
"""

from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, IntArray, frozen
from core.kernels import kernel

NO_FACES: IntArray = np.zeros((0, 3), np.int32)
"""The faces of a graph that is cut into bands by itself, without a surface."""
frozen(NO_FACES)


class BandComponents(NamedTuple):
    """The components of all bands, numbered by band and within a band by first element.

    Attributes
    ----------
    nodes : (x,) int32 ndarray
        Component of each element, vertices first; −1 for a vertex that is in none.
    bands : (k,) int32 ndarray
        Band of each component.
    arcs : (a, 2) int32 ndarray
        Pairs of components in successive bands that touch, the lower one first, no pair twice.
    starts : (e + 1,) int32 ndarray
        First element of each edge among the elements that are no vertices.
    """

    nodes: IntArray
    bands: IntArray
    arcs: IntArray
    starts: IntArray


def band_components(
    bands: IntArray,
    edges: IntArray,
    faces: IntArray,
    face_edges: IntArray,
    is_node: BoolArray | None = None,
) -> BandComponents:
    """Find the components of all bands and which of them touch.

    Parameters
    ----------
    bands : (m,) int32 ndarray
        Band of each vertex.
    edges : (e, 2) int32 ndarray
        Vertex pairs.
    faces, face_edges : (n, 3) int32 ndarray
        Vertices of each face, and the edges from corner c to corner c + 1. No faces at all make
        the components of a graph drawn along a line.
    is_node : (m,) bool ndarray, optional
        False for vertices that are no part of the surface.

    Returns
    -------
    BandComponents
        At most as many independent loops as the Reeb graph of the field has.
    """
    starts = crossing_starts(bands, edges)
    parent = join_elements(bands, edges, faces, face_edges, starts)
    mask = np.ones(len(bands), np.bool_) if is_node is None else is_node
    labels, roots = number_roots(parent, mask)
    root_bands = _bands_of(roots, bands, edges, starts)
    order = np.argsort(root_bands, kind="stable")
    # One more entry at the end, for the vertices labelled −1.
    place = np.full(len(roots) + 1, -1, np.int32)
    place[order] = np.arange(len(roots), dtype=np.int32)
    nodes = place[labels]
    arcs = distinct_pairs(crossing_arcs(bands, edges, starts, nodes), len(roots))
    return BandComponents(nodes, root_bands[order], arcs, starts)


def distinct_pairs(pairs: IntArray, count: int) -> IntArray:
    """Distinct rows of an (a, 2) table of numbers below `count`, in ascending order."""
    keys = np.unique(pairs[:, 0] * np.int64(count) + pairs[:, 1])
    return np.stack(np.divmod(keys, max(count, 1)), axis=1).astype(np.int32)


def _bands_of(elements: IntArray, bands: IntArray, edges: IntArray, starts: IntArray) -> IntArray:
    result = np.zeros(len(elements), np.int32)
    is_vertex = elements < len(bands)
    result[is_vertex] = bands[elements[is_vertex]]
    crossings = elements[~is_vertex] - len(bands)
    owners = np.searchsorted(starts, crossings, side="right") - 1
    result[~is_vertex] = bands[edges[owners]].min(axis=1) + 1 + crossings - starts[owners]
    return result


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
def number_roots(parent: IntArray, is_node: IntArray) -> tuple[IntArray, IntArray]:
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
def crossing_arcs(
    bands: IntArray, edges: IntArray, starts: IntArray, labels: IntArray
) -> IntArray:
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
