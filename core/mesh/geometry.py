"""Lengths, areas, normals and centroids of a triangle mesh."""

from typing import TYPE_CHECKING, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange
from core.mesh.triangles import triangle_vector

if TYPE_CHECKING:
    from core.mesh.triangle_mesh import TriangleMesh

Weighting = Literal["uniform", "area", "angle"]
Coordinate = TypeVar("Coordinate", np.float32, np.float64)


@parallel_kernel
def face_vectors(vertices: FloatArray, faces: IntArray) -> FloatArray:
    """Twice the area times the unit normal of each face, (n, 3): (v₁ − v₀) × (v₂ − v₀)."""
    result = np.empty((len(faces), 3))
    for t in prange(len(faces)):
        i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
        result[t, 0], result[t, 1], result[t, 2] = triangle_vector(vertices, i, j, k)
    return result


def normalized(vectors: FloatArray) -> FloatArray:
    """Scale the rows to unit length; rows of length zero stay zero."""
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    unit = np.zeros_like(vectors)
    np.divide(vectors, lengths, out=unit, where=lengths > 0)
    return unit


def face_areas(mesh: "TriangleMesh") -> FloatArray:
    """Area A(t) of each face, (n,), in squared model units."""
    areas: FloatArray = np.linalg.norm(face_vectors(mesh.vertices, mesh.faces), axis=1) / 2
    return areas


def face_normals(mesh: "TriangleMesh") -> FloatArray:
    """Unit normal n(t) of each face, (n, 3); zero for a face without area."""
    return normalized(face_vectors(mesh.vertices, mesh.faces))


def face_centroids(mesh: "TriangleMesh") -> FloatArray:
    """Centroid of each face, (n, 3)."""
    centroids: FloatArray = mesh.vertices[mesh.faces].mean(axis=1)
    return centroids


def edge_lengths(mesh: "TriangleMesh") -> FloatArray:
    """Length of each edge, (e,), in model units."""
    lengths: FloatArray = _edge_lengths(mesh.vertices, mesh.edges)
    return lengths


@parallel_kernel
def _edge_lengths(vertices: FloatArray, edges: IntArray) -> FloatArray:
    lengths = np.empty(len(edges))
    for e in prange(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        x = vertices[j, 0] - vertices[i, 0]
        y = vertices[j, 1] - vertices[i, 1]
        z = vertices[j, 2] - vertices[i, 2]
        lengths[e] = np.sqrt(x * x + y * y + z * z)
    return lengths


def mean_edge_length(mesh: "TriangleMesh") -> float:
    """Mean edge length ℓ̄, thesis eq. (2), in model units; 0 for a mesh without edges."""
    return float(edge_lengths(mesh).mean()) if len(mesh.edges) else 0.0


def corner_angles(mesh: "TriangleMesh") -> FloatArray:
    """Angle at each corner of each face, (n, 3), in radians; 0 where an edge has no length."""
    corners = mesh.vertices[mesh.faces]
    to_next = np.roll(corners, -1, axis=1) - corners
    to_last = np.roll(corners, 1, axis=1) - corners
    crosses = np.linalg.norm(np.cross(to_next, to_last), axis=2)
    dots = np.einsum("tcx,tcx->tc", to_next, to_last)
    angles: FloatArray = np.arctan2(crosses, dots)
    return angles


def vertex_normals(mesh: "TriangleMesh", weighting: Weighting = "uniform") -> FloatArray:
    """Unit normal of each vertex from the normals of the faces around it.

    nᵢ = Σ ωᵢⱼ n(tⱼ) over tⱼ ∈ T(vᵢ*), scaled to unit length. Thesis eq. (1) is the uniform
    weighting before that scaling.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh; its winding gives the side the normals point to.
    weighting : {"uniform", "area", "angle"}
        Weight ωᵢⱼ of a face: 1, its area, or its angle at the vertex.

    Returns
    -------
    (m, 3) float64 ndarray
        Unit normals; zero where a vertex has no face with an area.

    Raises
    ------
    ValueError
        If `weighting` is not one of the three.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §1.2.1 and eq. (1).
    """
    corners = np.ones((len(mesh.faces), 3))
    if weighting == "area":
        corners *= face_areas(mesh)[:, None]
    elif weighting == "angle":
        corners = corner_angles(mesh)
    elif weighting != "uniform":
        raise ValueError(f"weighting={weighting!r} is not one of uniform, area, angle.")
    weighted = face_normals(mesh)[:, None, :] * corners[:, :, None]
    sums = [
        np.bincount(mesh.faces.ravel(), weighted[:, :, x].ravel(), len(mesh.vertices))
        for x in range(3)
    ]
    return normalized(np.stack(sums, axis=1))


@kernel
def shading_normals(vertices: FloatArray, faces: IntArray) -> FloatArray:
    """Area-weighted sum of the face normals at each vertex, (m, 3), as a renderer wants it.

    The lengths are not scaled; :func:`vertex_normals` is the function for mathematics.
    """
    sums = np.zeros_like(vertices)
    for t in range(np.uint64(len(faces))):
        i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
        x, y, z = triangle_vector(vertices, i, j, k)
        for corner in (i, j, k):
            sums[corner, 0] += x
            sums[corner, 1] += y
            sums[corner, 2] += z
    return sums


def bounding_box(vertices: NDArray[Coordinate]) -> tuple[NDArray[Coordinate], NDArray[Coordinate]]:
    """Smallest and largest corner of the axis-parallel box around the vertices, each (3,)."""
    # Along rows that lie in one piece this takes a tenth of the time.
    columns = np.ascontiguousarray(vertices.T)
    return columns.min(axis=1), columns.max(axis=1)


def volume(mesh: "TriangleMesh") -> float:
    """Signed volume enclosed by a closed, consistently wound mesh, in cubed model units."""
    corners = mesh.vertices[mesh.faces] - mesh.vertices.mean(axis=0)
    a, b, c = corners.transpose(1, 0, 2)
    return float(np.einsum("tx,tx->", np.cross(a, b), c) / 6)
