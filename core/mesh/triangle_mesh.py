"""The triangle mesh: a frozen value of vertices and faces."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from core.arrays import FloatArray, IntArray, frozen
from core.mesh import geometry
from core.mesh.errors import MeshError
from core.mesh.topology import Topology


class TriangleMesh:
    """A triangle mesh 𝕄 = (𝒱, ℰ, 𝒯): read-only vertices and faces.

    Connectivity is computed on first use and shared by every mesh made with
    :meth:`with_vertices`, so a smoothing run never computes it twice.

    Parameters
    ----------
    vertices : (m, 3) array_like of float
        Positions, finite.
    faces : (n, 3) array_like of int
        Three distinct vertex numbers for each face, counted from 0.

    Raises
    ------
    MeshError
        If a shape is wrong, a coordinate is not finite, or a face names a vertex twice or one
        that does not exist.

    Examples
    --------
    >>> mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> mesh.degrees.tolist(), mesh.euler_characteristic
    ([2, 2, 2], 1)
    """

    def __init__(
        self,
        vertices: ArrayLike | Sequence[Sequence[float]],
        faces: ArrayLike | Sequence[Sequence[int]],
    ) -> None:
        positions = _vertex_array(vertices)
        self._vertices = positions
        self._topology = Topology(_face_array(faces, len(positions)), len(positions))

    def __repr__(self) -> str:
        return f"TriangleMesh({len(self.vertices)} vertices, {len(self.faces)} faces)"

    def with_vertices(self, vertices: ArrayLike) -> "TriangleMesh":
        """Return a mesh with the same faces and topology and other positions.

        Parameters
        ----------
        vertices : (m, 3) array_like of float
            The new positions, finite.

        Returns
        -------
        TriangleMesh
            Shares the faces and every derived connectivity with this one.

        Raises
        ------
        MeshError
            If the number of vertices differs or a coordinate is not finite.
        """
        positions = _vertex_array(vertices)
        if len(positions) != len(self._vertices):
            raise MeshError(f"{len(positions)} vertices given; the mesh has {len(self._vertices)}.")
        return self._on(self._topology, positions)

    @staticmethod
    def _on(topology: Topology, positions: FloatArray) -> "TriangleMesh":
        mesh = TriangleMesh.__new__(TriangleMesh)
        mesh._vertices = positions
        mesh._topology = topology
        return mesh

    def along_surface(self) -> "TriangleMesh":
        """Return this mesh in numbers that follow the surface, for long computations.

        ``mesh.topology.ordering`` brings values into these numbers and back. It is this mesh where
        the numbers already follow the surface.
        """
        along = self._topology.along_surface
        if along is self._topology:
            return self
        positions = self._topology.ordering.vertices.inward(self._vertices)
        frozen(positions)
        return self._on(along, positions)

    @property
    def vertices(self) -> FloatArray:
        """Positions, (m, 3) float64, read-only."""
        return self._vertices

    @property
    def topology(self) -> Topology:
        """Connectivity, shared between meshes with the same faces."""
        return self._topology

    @property
    def faces(self) -> IntArray:
        """Vertex numbers of each face, (n, 3) int32, read-only."""
        return self._topology.faces

    @property
    def edges(self) -> IntArray:
        """Edges as vertex pairs, (e, 2) int32, read-only."""
        return self._topology.edges

    @property
    def degrees(self) -> IntArray:
        """Number of neighbours dᵢ of each vertex, (m,)."""
        return self._topology.degrees

    @cached_property
    def mean_edge_length(self) -> float:
        """Mean edge length ℓ̄ in model units, thesis eq. (2)."""
        return geometry.mean_edge_length(self.along_surface())

    @property
    def euler_characteristic(self) -> int:
        """Euler characteristic χ = m − e + n."""
        return self._topology.euler_characteristic

    @property
    def genus(self) -> int | None:
        """Genus summed over the components, or None where it is not defined."""
        return self._topology.genus


def _vertex_array(vertices: ArrayLike | Sequence[Sequence[float]]) -> FloatArray:
    array = np.array(vertices, dtype=np.float64, order="C")
    if array.ndim != 2 or array.shape[1] != 3:
        raise MeshError(f"vertices have the shape {array.shape}; allowed is (m, 3).")
    if not np.isfinite(array).all():
        bad = np.flatnonzero(~np.isfinite(array).all(axis=1))[0]
        raise MeshError(f"vertex {bad} is {array[bad].tolist()}; coordinates must be finite.")
    frozen(array)
    return array


def _face_array(faces: ArrayLike | Sequence[Sequence[int]], vertex_count: int) -> IntArray:
    raw = np.asarray(faces)
    if raw.ndim != 2 or raw.shape[1] != 3:
        raise MeshError(f"faces have the shape {raw.shape}; allowed is (n, 3).")
    if not np.issubdtype(raw.dtype, np.integer):
        raise MeshError(f"faces are of type {raw.dtype}; vertex numbers must be integers.")
    if raw.size and (raw.min() < 0 or raw.max() >= vertex_count):
        outside = np.flatnonzero(((raw < 0) | (raw >= vertex_count)).any(axis=1))[0]
        raise MeshError(
            f"face {outside} names the vertices {raw[outside].tolist()}; "
            f"allowed are 0 to {vertex_count - 1}."
        )
    a, b, c = raw.T
    repeated = (a == b) | (b == c) | (c == a)
    if repeated.any():
        raise MeshError(f"face {np.flatnonzero(repeated)[0]} names a vertex twice.")
    array = np.array(raw, dtype=np.int32, order="C")
    frozen(array)
    return array
