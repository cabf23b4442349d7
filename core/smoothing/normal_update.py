"""What the normal filters share: normals, and step 3, fitting the vertices to new ones, §2.3.1."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange
from core.mesh.triangles import triangle_vector


@parallel_kernel
def fit_vertices(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    areas: FloatArray,
    planes: FloatArray,
) -> FloatArray:
    """Move each vertex towards the planes of its faces, each turned to its filtered normal.

    vᵢ ← vᵢ + Σⱼ A(tⱼ) (⟨cⱼ, m(tⱼ)⟩ − ⟨vᵢ, m(tⱼ)⟩) m(tⱼ) / Σⱼ A(tⱼ) over T(vᵢ*), with the centroid
    cⱼ; `planes` holds m(tⱼ) and ⟨cⱼ, m(tⱼ)⟩ of each face, see :func:`set_plane`.
    """
    moved = np.empty_like(vertices)
    for i in prange(len(vertices)):
        x = y = z = total = 0.0
        for t in items[starts[i] : starts[i + 1]]:
            nx, ny, nz = planes[t, 0], planes[t, 1], planes[t, 2]
            height = planes[t, 3] - (
                vertices[i, 0] * nx + vertices[i, 1] * ny + vertices[i, 2] * nz
            )
            x += areas[t] * height * nx
            y += areas[t] * height * ny
            z += areas[t] * height * nz
            total += areas[t]
        share = 1 / total if total > 0 else 0.0
        moved[i, 0] = vertices[i, 0] + share * x
        moved[i, 1] = vertices[i, 1] + share * y
        moved[i, 2] = vertices[i, 2] + share * z
    return moved


@kernel
def set_plane(
    planes: FloatArray, t: int, vertices: FloatArray, faces: IntArray, x: float, y: float, z: float
) -> None:
    """Note the plane ⟨p, m⟩ = ⟨cₜ, m⟩ through the centroid of face t, with m = (x, y, z)."""
    i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
    planes[t, 0], planes[t, 1], planes[t, 2] = x, y, z
    planes[t, 3] = (
        x * (vertices[i, 0] + vertices[j, 0] + vertices[k, 0])
        + y * (vertices[i, 1] + vertices[j, 1] + vertices[k, 1])
        + z * (vertices[i, 2] + vertices[j, 2] + vertices[k, 2])
    ) / 3


@parallel_kernel
def set_areas_and_normals(
    vertices: FloatArray, faces: IntArray, areas: FloatArray, normals: FloatArray
) -> None:
    """Note area (n,) and unit normal (n, 3) of each face; both zero for a face without area."""
    for t in prange(len(faces)):
        x, y, z = triangle_vector(vertices, faces[t, 0], faces[t, 1], faces[t, 2])
        length = np.sqrt(x * x + y * y + z * z)
        factor = 1 / length if length > 0 else 0.0
        areas[t] = length / 2
        normals[t, 0], normals[t, 1], normals[t, 2] = factor * x, factor * y, factor * z
