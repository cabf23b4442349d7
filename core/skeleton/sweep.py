"""One sweep through the vertices that follows the level sets of a piecewise-linear field.

The level set just above a vertex is a graph whose nodes are the edges that it crosses and whose
arcs are the faces that it crosses. Its components are told apart by a label on every crossed
edge. At a regular vertex the labels pass on; where the lower or the upper link of a vertex
falls into several pieces, the pieces above it are searched in turn, one edge each, until all
have met or only one is left. The pieces that ran out of edges are components of their own and
get new labels, so every vertex costs no more than the smaller of the parts that it separates.

Nothing here assumes a surface: edges with one face or with many and pinched vertices are alike.
"""

from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, IntArray
from core.fields.critical import link_pieces
from core.kernels import kernel
from core.mesh import TriangleMesh


class _Surface(NamedTuple):
    """What the sweep needs to know of the mesh."""

    faces: IntArray
    face_edges: IntArray
    low: IntArray  # rank of the lower end of each edge
    high: IntArray  # rank of the upper end of each edge
    corner_starts: IntArray
    corner_items: IntArray


class _Search(NamedTuple):
    """Edges found by each piece: linked lists of the edges, with a cursor where it goes on."""

    owner: IntArray  # piece that found each edge, counted through the whole sweep
    following: IntArray
    head: IntArray
    cursor: IntArray
    tail: IntArray
    group: IntArray  # union-find over the pieces at this vertex


@kernel
def _root(parent: IntArray, x: int) -> int:
    while parent[x] != x:
        parent[x] = parent[parent[x]]
        x = parent[x]
    return x


@kernel
def _append(search: _Search, piece: int, first: int, edge: int) -> None:
    """Put an edge on a piece's list; `first` is the sweep's number of the vertex's piece 0."""
    search.owner[edge] = first + piece
    search.following[edge] = -1
    if search.head[piece] < 0:
        search.head[piece] = edge
        search.cursor[piece] = edge
    else:
        search.following[search.tail[piece]] = edge
        if search.cursor[piece] < 0:
            search.cursor[piece] = edge
    search.tail[piece] = edge


@kernel
def _visit(search: _Search, piece: int, first: int, edge: int) -> int:
    """Let a piece reach an edge; return 1 if it thereby meets another piece, else 0."""
    found = search.owner[edge] - first
    if found < 0:
        _append(search, piece, first, edge)
        return 0
    x, y = _root(search.group, found), _root(search.group, piece)
    search.group[x] = y
    return int(x != y)


@kernel
def _expand(surface: _Surface, search: _Search, piece: int, first: int, level: int) -> int:
    """Visit the edges next to a piece's cursor in the level set above `level`; count meetings."""
    edge = search.cursor[piece]
    met = 0
    for slot in range(surface.corner_starts[edge], surface.corner_starts[edge + 1]):
        t = surface.corner_items[slot] // 3
        for c in range(3):
            other = surface.face_edges[t, c]
            if other != edge and surface.low[other] <= level < surface.high[other]:
                met += _visit(search, piece, first, other)
    search.cursor[piece] = search.following[edge]
    return met


@kernel
def _start_pieces(
    surface: _Surface, search: _Search, first: int, level: int, edges: IntArray
) -> int:
    """Make a piece of each part of the upper link; return their number."""
    count = 0
    for edge in edges:
        if surface.low[edge] != level or search.owner[edge] >= first:
            continue
        search.head[count], search.cursor[count], search.group[count] = -1, -1, count
        _append(search, count, first, edge)
        walker = edge
        while walker >= 0:
            for slot in range(surface.corner_starts[walker], surface.corner_starts[walker + 1]):
                t = surface.corner_items[slot] // 3
                for c in range(3):
                    other = surface.face_edges[t, c]
                    # Only edges that start at this vertex belong to its upper star.
                    if surface.low[other] == level and search.owner[other] < first:
                        _append(search, count, first, other)
            walker = search.following[walker]
        search.cursor[count] = search.head[count]
        count += 1
    return count


@kernel
def _search_above(
    surface: _Surface, search: _Search, first: int, level: int, count: int
) -> int:
    """Search from all pieces in turn until at most one group has edges left to follow.

    Returns the piece whose group stays unsearched, or 0 if all ran out.
    """
    groups = count
    while groups > 1:
        alive, last = 0, -1
        for piece in range(count):
            if search.cursor[piece] >= 0:
                groups -= _expand(surface, search, piece, first, level)
            if search.cursor[piece] >= 0:
                root = _root(search.group, piece)
                alive += last < 0 or root != _root(search.group, last)
                last = piece
        if alive <= 1:
            return max(last, 0)
    return 0


class _Labels(NamedTuple):
    """Component labels of the level set, joined by union-find, and the arcs they stand for."""

    of_edge: IntArray
    parent: IntArray
    arc: IntArray
    ends: IntArray  # lower and upper vertex of each arc
    used: IntArray  # number of labels, arcs and search pieces so far


@kernel
def _labels_below(
    surface: _Surface, labels: _Labels, level: int, edges: IntArray, below: IntArray
) -> int:
    """Collect the distinct labels of the edges that end at a vertex; return their number."""
    count = 0
    for edge in edges:
        if surface.high[edge] == level:
            label = _root(labels.parent, labels.of_edge[edge])
            if label not in below[:count]:
                below[count] = label
                count += 1
    return count


@kernel
def _count_groups(search: _Search, count: int) -> int:
    groups = 0
    for piece in range(count):
        groups += _root(search.group, piece) == piece
    return groups


@kernel
def _relabel(search: _Search, labels: _Labels, count: int, group: int, label: int) -> None:
    """Give one label to every edge that the pieces of a group have found."""
    for piece in range(count):
        if _root(search.group, piece) == group:
            edge = search.head[piece]
            while edge >= 0:
                labels.of_edge[edge] = label
                edge = search.following[edge]


@kernel
def _new_label(labels: _Labels) -> int:
    labels.used[0] += 1
    return labels.used[0] - 1


@kernel
def _begin_arc(labels: _Labels, label: int, v: int) -> None:
    labels.arc[label] = labels.used[1]
    labels.ends[labels.used[1], 0] = v
    labels.used[1] += 1


@kernel
def _cross_vertex(
    surface: _Surface,
    search: _Search,
    labels: _Labels,
    v: int,
    level: int,
    edges: IntArray,
    below: IntArray,
) -> None:
    """Carry the labels across a vertex at which components may end, begin, meet or part."""
    below_count = _labels_below(surface, labels, level, edges, below)
    first = labels.used[2]
    count = _start_pieces(surface, search, first, level, edges)
    labels.used[2] += count
    kept = _root(search.group, _search_above(surface, search, first, level, count)) if count else -1
    is_node = below_count != 1 or _count_groups(search, count) != 1
    for label in below[:below_count]:
        if is_node:
            labels.ends[labels.arc[label], 1] = v
        labels.parent[label] = below[0]
    for group in range(count):
        if _root(search.group, group) != group:
            continue
        label = below[0] if group == kept and below_count > 0 else _new_label(labels)
        _relabel(search, labels, count, group, label)
        if is_node:
            _begin_arc(labels, label, v)


@kernel
def _pass_on(surface: _Surface, labels: _Labels, level: int, edges: IntArray) -> None:
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
    order: IntArray, is_regular: BoolArray, ring_starts: IntArray, ring_edges: IntArray, surface: _Surface
) -> IntArray:
    size = len(surface.low) + 1
    widest = 0
    for v in order:
        widest = max(widest, ring_starts[v + 1] - ring_starts[v])
    search = _Search(
        np.full(size, -1, np.int32),
        np.full(size, -1, np.int32),
        np.zeros(widest, np.int32),
        np.zeros(widest, np.int32),
        np.zeros(widest, np.int32),
        np.zeros(widest, np.int32),
    )
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
    surface = _Surface(
        mesh.faces,
        topology.face_edges,
        ends[:, 0].copy(),
        ends[:, 1].copy(),
        *topology.edge_corners,
    )
    order = np.argsort(ranks).astype(np.int32)
    starts = topology.vertex_ring.starts
    arcs: IntArray = _sweep(order, (lower == 1) & (upper == 1), starts, topology.ring_edges, surface)
    return arcs
