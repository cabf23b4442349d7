"""Which parts of the level set just above a vertex hang together.

The level set is a graph whose nodes are the edges that it crosses and whose arcs are the faces
that it crosses. The pieces of the vertex's upper link are searched in turn, one edge each,
until all have met or only one is left with edges to follow. Those that ran out are components
of their own, so a vertex costs about as much as the smaller of the parts that it separates,
however large the rest of the level set is.

Nothing here assumes a surface: edges with one face or with many and pinched vertices are alike.
"""

from typing import NamedTuple

import numpy as np

from core.arrays import IntArray
from core.kernels import kernel


class Surface(NamedTuple):
    """What the sweep needs to know of the mesh.

    Attributes
    ----------
    face_edges : (n, 3) int32 ndarray
        Edges of each face.
    low, high : (e,) int32 ndarray
        Ranks of the lower and the upper end of each edge.
    corner_starts, corner_items : int32 ndarray
        Corners 3·face + corner opposite each edge, as CSR.
    """

    face_edges: IntArray
    low: IntArray
    high: IntArray
    corner_starts: IntArray
    corner_items: IntArray


class Search(NamedTuple):
    """Edges found by each piece of a vertex, as linked lists.

    Attributes
    ----------
    owner : (e,) int32 ndarray
        Piece that found each edge last, counted through the whole sweep.
    following : (e,) int32 ndarray
        Next edge on the same list, or −1.
    head, cursor, tail : (d,) int32 ndarray
        First edge of each piece, the edge to go on from (−1: none left), and the last edge.
    group : (d,) int32 ndarray
        Union-find over the pieces: those that have met have one root.
    """

    owner: IntArray
    following: IntArray
    head: IntArray
    cursor: IntArray
    tail: IntArray
    group: IntArray


@kernel
def new_search(edge_count: int, widest: int) -> Search:
    """Make an empty search over so many edges, for vertices of at most `widest` edges."""
    return Search(
        np.full(edge_count, -1, np.int32),
        np.full(edge_count, -1, np.int32),
        np.zeros(widest, np.int32),
        np.zeros(widest, np.int32),
        np.zeros(widest, np.int32),
        np.zeros(widest, np.int32),
    )


@kernel
def find_root(parent: IntArray, x: int) -> int:
    """Root of x in a union-find forest."""
    while parent[x] != x:
        parent[x] = parent[parent[x]]
        x = parent[x]
    return x


@kernel
def _append(search: Search, piece: int, first: int, edge: int) -> None:
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
def _visit(search: Search, piece: int, first: int, edge: int) -> int:
    """Let a piece reach an edge; return 1 if it thereby meets another piece, else 0."""
    found = search.owner[edge] - first
    if found < 0:
        _append(search, piece, first, edge)
        return 0
    x, y = find_root(search.group, found), find_root(search.group, piece)
    search.group[x] = y
    return int(x != y)


@kernel
def _expand(surface: Surface, search: Search, piece: int, first: int, level: int) -> int:
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
def start_pieces(surface: Surface, search: Search, first: int, level: int, edges: IntArray) -> int:
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
def search_above(surface: Surface, search: Search, first: int, level: int, count: int) -> int:
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
                root = find_root(search.group, piece)
                alive += last < 0 or root != find_root(search.group, last)
                last = piece
        if alive <= 1:
            return max(last, 0)
    return 0
