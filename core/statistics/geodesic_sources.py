"""Distances from one vertex to all others, by graph or along the surface itself."""

from collections.abc import Callable
from functools import partial

import numpy as np
from potpourri3d import MeshHeatMethodDistanceSolver
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from core.arrays import FloatArray, IntArray
from core.mesh import TriangleMesh
from core.statistics.errors import StatisticsError
from core.statistics.graphs import edge_graph, nearest_neighbour_graph

DistancesFrom = Callable[[IntArray], FloatArray]
"""Distances from sources (s,) to all vertices, (s, m), inf where there is no path."""


def along_neighbours(mesh: TriangleMesh, neighbours: int) -> DistancesFrom:
    """Shortest paths in the graph of the k nearest neighbours, thesis §3.3.5."""
    return partial(_shortest_paths, nearest_neighbour_graph(mesh.vertices, neighbours))


def along_edges(mesh: TriangleMesh) -> DistancesFrom:
    """Shortest paths along the edges of the mesh."""
    return partial(_shortest_paths, edge_graph(mesh))


def along_surface(mesh: TriangleMesh) -> DistancesFrom:
    """Geodesics on the surface itself, by the heat method.

    Raises
    ------
    StatisticsError
        If the mesh has no faces or the equations of the heat method cannot be solved on it.

    References
    ----------
    Crane, Weischedel and Wardetzky, *Geodesics in heat*, 2013, with the intrinsic Laplacian of
    Sharp and Crane, *A Laplacian for nonmanifold triangle meshes*, 2020.
    """
    used, numbers = np.unique(mesh.faces, return_inverse=True)
    if not len(used):
        raise StatisticsError("A mesh without faces has no geodesics along its surface.")
    try:
        solver = MeshHeatMethodDistanceSolver(mesh.vertices[used], numbers.reshape(-1, 3))
    except RuntimeError as error:
        raise StatisticsError("The heat method cannot be set up on this mesh.") from error
    return partial(_heat_distances, solver, used, mesh.topology.vertex_components)


def _shortest_paths(graph: csr_array, sources: IntArray) -> FloatArray:
    # The graph is symmetric: taken as directed it need not be transposed at every call.
    distances: FloatArray = dijkstra(graph, directed=True, indices=sources)
    return distances


def _heat_distances(
    solver: MeshHeatMethodDistanceSolver, used: IntArray, components: IntArray, sources: IntArray
) -> FloatArray:
    return np.stack([_heat_from(solver, used, components, int(source)) for source in sources])


def _heat_from(
    solver: MeshHeatMethodDistanceSolver, used: IntArray, components: IntArray, source: int
) -> FloatArray:
    """Distances from one vertex; heat does not reach other components."""
    distances = np.full(len(components), np.inf)
    place = int(np.searchsorted(used, source))
    if place < len(used) and used[place] == source:
        # Near the source the solution may fall below zero by its own error.
        distances[used] = np.maximum(_solved(solver, place), 0.0)
    distances[components != components[source]] = np.inf
    distances[source] = 0.0
    if np.isnan(distances).any():
        raise StatisticsError("The heat method finds no distances on this mesh.")
    return distances


def _solved(solver: MeshHeatMethodDistanceSolver, place: int) -> FloatArray:
    try:
        distances: FloatArray = solver.compute_distance(place)
    except RuntimeError as error:
        raise StatisticsError("The heat method finds no distances on this mesh.") from error
    return distances
