"""Distances from some vertices to all others, by graph or along the surface itself."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import scipy

from core.apart import run_apart
from core.arrays import FloatArray, IntArray
from core.mesh import TriangleMesh
from core.statistics.errors import StatisticsError, refusals
from core.statistics.graphs import edge_graph, nearest_neighbour_graph
from core.statistics.heat import heat_distances

if TYPE_CHECKING:
    from scipy.sparse import csr_array

Chunks = Sequence[IntArray]
"""Source vertices, a few at a time."""
Rows = Iterator[FloatArray | None]
"""Distances (s, m) from each chunk, inf where there is no path; None while they are awaited."""

# A mesh of so few vertices is factorised in less time than it takes to start a process.
_SMALL = 3000


def along_neighbours(mesh: TriangleMesh, chunks: Chunks, neighbours: int) -> Rows:
    """Shortest paths in the graph of the k nearest neighbours, thesis §3.3.5."""
    return _shortest_paths(nearest_neighbour_graph(mesh.vertices, neighbours), chunks)


def along_edges(mesh: TriangleMesh, chunks: Chunks) -> Rows:
    """Shortest paths along the edges of the mesh."""
    return _shortest_paths(edge_graph(mesh), chunks)


def along_surface(mesh: TriangleMesh, chunks: Chunks) -> Rows:
    """Geodesics on the surface itself, by the heat method; on a large mesh in another process.

    Raises
    ------
    StatisticsError
        If the mesh has no faces or the equations of the heat method cannot be solved on it.
    """
    if not len(mesh.faces):
        raise StatisticsError("A mesh without faces has no geodesics along its surface.")
    arguments = mesh.vertices, mesh.faces, mesh.topology.vertex_components, chunks
    apart = len(mesh.vertices) > _SMALL
    with refusals():
        yield from run_apart(heat_distances, *arguments) if apart else heat_distances(*arguments)


def _shortest_paths(graph: "csr_array", chunks: Chunks) -> Rows:
    for chunk in chunks:
        # The graph is symmetric: taken as directed it need not be transposed at every call.
        yield scipy.sparse.csgraph.dijkstra(graph, directed=True, indices=chunk)
