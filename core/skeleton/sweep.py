"""One sweep through the vertices that follows the level sets of a piecewise-linear field.

Every edge that the level set just above a vertex crosses carries the label of its component.
At a regular vertex the labels pass on. Where the lower or the upper link of a vertex falls into
several pieces, :mod:`core.skeleton.level_search` finds out which of them hang together above
it; each part that has come off gets a new label. Where components have come together, end,
begin or part, the Reeb graph has a node.
"""

from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, IntArray
from core.fields.critical import link_pieces
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.skeleton.level_search import (
    Search,
    Surface,
    find_root,
    new_search,
    search_above,
    start_pieces,
)


class _Labels(NamedTuple):
    """Component labels of the level set, joined by union-find, and the arcs they stand for.

    Attributes
    ----------
    of_edge : (e,) int32 ndarray
        Label of each edge.
    parent : (l,) int32 ndarray
        Union-find over the labels.
    arc : (l,) int32 ndarray
        Arc that each label stands for.
    ends : (l, 2) int32 ndarray
        Lower and upper vertex of each arc.
    used : (3,) int32 ndarray
        Number of labels, of arcs and of search pieces so far.
    """

    of_edge: IntArray
    parent: IntArray
    arc: IntArray
    ends: IntArray
    used: IntArray


@kernel
def _labels_below(
    surface: Surface, labels: _Labels, level: int, edges: IntArray, below: IntArray
) -> int:
    """Collect the distinct labels of the edges that end at a vertex; return their number."""
    count = 0
    for edge in edges:
        if surface.high[edge] == level:
            label = find_root(labels.parent, labels.of_edge[edge])
            if label not in below[:count]:
                below[count] = label
                count += 1
    return count


@kernel
def _count_groups(search: Search, count: int) -> int:
    groups = 0
    for piece in range(count):
        groups += find_root(search.group, piece) == piece
    return groups


@kernel
def _relabel(search: Search, labels: _Labels, count: int, group: int, label: int) -> None:
    """Give one label to every edge that the pieces of a group have found."""
    for piece in range(count):
        if find_root(search.group, piece) == group:
            edge = search.head[piece]
            while edge >= 0:
                labels.of_edge[edge] = label
                edge = search.following[edge]


@kernel
def _new_label(labels: _Labels) -> int:
    label: int = labels.used[0]
    labels.used[0] += 1
    return label


@kernel
def _begin_arc(labels: _Labels, label: int, v: int) -> None:
    labels.arc[label] = labels.used[1]
    labels.ends[labels.used[1], 0] = v
    labels.used[1] += 1


@kernel
def _cross_vertex(
    surface: Surface,
    search: Search,
    labels: _Labels,
    v: int,
    level: int,
    edges: IntArray,
    below: IntArray,
) -> None:
    """Carry the labels across a vertex at which components may end, begin, meet or part."""
    below_count = _labels_below(surface, labels, level, edges, below)
    first = labels.used[2]
    count = start_pieces(surface, search, first, level, edges)
    labels.used[2] += count
    kept = (
        find_root(search.group, search_above(surface, search, first, level, count)) if count else -1
    )
    is_node = below_count != 1 or _count_groups(search, count) != 1
    for label in below[:below_count]:
        if is_node:
            labels.ends[labels.arc[label], 1] = v
        labels.parent[label] = below[0]
    for group in range(count):
        if find_root(search.group, group) != group:
            continue
        label = below[0] if group == kept and below_count > 0 else _new_label(labels)
        _relabel(search, labels, count, group, label)
        if is_node:
            _begin_arc(labels, label, v)


@kernel
def _pass_on(surface: Surface, labels: _Labels, level: int, edges: IntArray) -> None:
    """Hand the label of the edges that end at a regular vertex to those that begin there."""
    label = -1
    for edge in edges:
        if surface.high[edge] == level:
            label = labels.of_edge[edge]
    for edge in edges:
        if surface.low[edge] == level:
            labels.of_edge[edge] = label


@kernel
def _sweep(
    order: IntArray,
    is_regular: BoolArray,
    ring_starts: IntArray,
    ring_edges: IntArray,
    surface: Surface,
) -> IntArray:
    size = len(surface.low) + 1
    widest = 0
    for v in order:
        widest = max(widest, ring_starts[v + 1] - ring_starts[v])
    search = new_search(size, widest)
    labels = _Labels(
        np.full(size, -1, np.int32),
        np.arange(size).astype(np.int32),
        np.full(size, -1, np.int32),
        np.full((size, 2), -1, np.int32),
        np.zeros(3, np.int32),
    )
    below = np.zeros(widest, np.int32)
    for level in range(len(order)):
        v = order[level]
        edges = ring_edges[ring_starts[v] : ring_starts[v + 1]]
        if is_regular[v]:
            _pass_on(surface, labels, level, edges)
        elif len(edges) > 0:
            _cross_vertex(surface, search, labels, v, level, edges, below)
    return labels.ends[: labels.used[1]]


def reeb_arcs(mesh: TriangleMesh, ranks: IntArray) -> IntArray:
    """Arcs of the Reeb graph as pairs of vertices, the lower one first, (a, 2).

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh.
    ranks : (m,) int32 ndarray
        Position of each vertex in the order of the field, all different.

    Returns
    -------
    (a, 2) int32 ndarray
        Two vertices may be joined by several arcs.
    """
    topology = mesh.topology
    lower, upper, _ = link_pieces(
        ranks, mesh.faces, *topology.vertex_ring, *topology.vertex_faces
    ).T
    ends = np.sort(ranks[mesh.edges], axis=1)
    surface = Surface(
        topology.face_edges,
        ends[:, 0].copy(),
        ends[:, 1].copy(),
        *topology.edge_corners,
    )
    order = np.argsort(ranks).astype(np.int32)
    starts = topology.vertex_ring.starts
    arcs: IntArray = _sweep(
        order, (lower == 1) & (upper == 1), starts, topology.ring_edges, surface
    )
    return arcs
