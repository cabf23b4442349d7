"""Step 3 of the normal filters: fit the vertices to filtered face normals, thesis §2.3.1."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange
from core.mesh.triangles import triangle_vector


@parallel_kernel
def fit_vertices(
    vertices: FloatArray,
    faces: IntArray,
    starts: IntArray,
    items: IntArray,
    areas: FloatArray,
    normals: FloatArray,
) -> FloatArray:
    """Move each vertex towards the planes of its faces, each turned to its filtered normal.

    vᵢ ← vᵢ + Σⱼ A(tⱼ) ⟨cⱼ − vᵢ, m(tⱼ)⟩ m(tⱼ) / Σⱼ A(tⱼ) over T(vᵢ*), with the centroid cⱼ.
    """
    moved = vertices.copy()
    for i in prange(len(vertices)):
        x = y = z = total = 0.0
        for t in items[starts[i] : starts[i + 1]]:
            a, b, c = faces[t]
            nx, ny, nz = normals[t, 0], normals[t, 1], normals[t, 2]
            height = (
                ((vertices[a, 0] + vertices[b, 0] + vertices[c, 0]) / 3 - vertices[i, 0]) * nx
                + ((vertices[a, 1] + vertices[b, 1] + vertices[c, 1]) / 3 - vertices[i, 1]) * ny
                + ((vertices[a, 2] + vertices[b, 2] + vertices[c, 2]) / 3 - vertices[i, 2]) * nz
            )
            x += areas[t] * height * nx
            y += areas[t] * height * ny
            z += areas[t] * height * nz
            total += areas[t]
        if total > 0:
            moved[i, 0] += x / total
            moved[i, 1] += y / total
            moved[i, 2] += z / total
    return moved


@parallel_kernel
def areas_and_normals(vertices: FloatArray, faces: IntArray) -> tuple[FloatArray, FloatArray]:
    """Area (n,) and unit normal (n, 3) of each face; both zero for a face without area."""
    areas = np.zeros(len(faces))
    normals = np.zeros((len(faces), 3))
    for t in prange(len(faces)):
        i, j, k = faces[t]
        x, y, z = triangle_vector(vertices, i, j, k)
        length = np.sqrt(x * x + y * y + z * z)
        if length > 0:
            areas[t] = length / 2
            normals[t, 0], normals[t, 1], normals[t, 2] = x / length, y / length, z / length
    return areas, normals
