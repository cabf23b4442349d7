"""Geodesic distances by the heat method.

This file imports nothing of the project: :mod:`core.apart` loads it in a process of its own,
because potpourri3d keeps the interpreter lock while it factorises and solves.
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from potpourri3d import MeshHeatMethodDistanceSolver


def heat_distances(
    vertices: NDArray[np.float64],
    faces: NDArray[np.int32],
    components: NDArray[np.int32],
    chunks: Sequence[NDArray[np.int32]],
) -> Iterator[NDArray[np.float64]]:
    """Yield the distances (s, m) from each chunk of sources to all vertices, in model units.

    Raises
    ------
    ValueError
        If the equations of the heat method cannot be solved on this mesh.

    References
    ----------
    Crane, Weischedel and Wardetzky, *Geodesics in heat*, 2013, with the intrinsic Laplacian of
    Sharp and Crane, *A Laplacian for nonmanifold triangle meshes*, 2020.
    """
    from potpourri3d import MeshHeatMethodDistanceSolver  # noqa: PLC0415 - takes as long as scipy

    used, numbers = np.unique(faces, return_inverse=True)
    try:
        solver = MeshHeatMethodDistanceSolver(vertices[used], numbers.reshape(-1, 3))
    except RuntimeError as error:
        raise ValueError("The heat method cannot be set up on this mesh.") from error
    for chunk in chunks:
        yield np.stack([_from_vertex(solver, used, components, int(source)) for source in chunk])


def _from_vertex(
    solver: "MeshHeatMethodDistanceSolver",
    used: NDArray[np.signedinteger],
    components: NDArray[np.int32],
    source: int,
) -> NDArray[np.float64]:
    """Distances from one vertex; heat does not reach other components."""
    distances = np.full(len(components), np.inf)
    place = int(np.searchsorted(used, source))
    if place < len(used) and used[place] == source:
        # Near the source the solution may fall below zero by its own error.
        distances[used] = np.maximum(_solved(solver, place), 0.0)
    distances[components != components[source]] = np.inf
    distances[source] = 0.0
    if np.isnan(distances).any():
        raise ValueError("The heat method finds no distances on this mesh.")
    return distances


def _solved(solver: "MeshHeatMethodDistanceSolver", place: int) -> NDArray[np.float64]:
    try:
        distances: NDArray[np.float64] = solver.compute_distance(place)
    except RuntimeError as error:
        raise ValueError("The heat method finds no distances on this mesh.") from error
    return distances
