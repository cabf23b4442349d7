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
from core.skeleton.elements import (
    crossing_arcs,
    crossing_starts,
    join_elements,
    number_roots,
)

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
