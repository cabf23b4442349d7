"""What the normal filters share: normals, and step 3, fitting the vertices to new ones, §2.3.1."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_kernel, fused_parallel_kernel, kernel, parallel_kernel, prange
from core.lanes import xyz
from core.mesh.triangles import triangle_vector


@fused_parallel_kernel
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
        x, y, z = xyz(vertices, i)
        dx = dy = dz = total = 0.0
        for k in range(starts[i], starts[i + 1]):
            t = items[k]
            nx, ny, nz, area = planes[t, 0], planes[t, 1], planes[t, 2], areas[t]
            weight = area * (planes[t, 3] - (x * nx + y * ny + z * nz))
            dx += weight * nx
            dy += weight * ny
            dz += weight * nz
            total += area
        share = 1 / total if total > 0 else 0.0
        moved[i, 0], moved[i, 1], moved[i, 2] = x + share * dx, y + share * dy, z + share * dz
    return moved


@fused_kernel
def set_plane(
    planes: FloatArray, t: int, vertices: FloatArray, faces: IntArray, x: float, y: float, z: float
) -> None:
    """Note the plane ⟨p, m⟩ = ⟨cₜ, m⟩ through the centroid of face t, with m = (x, y, z)."""
    ax, ay, az = xyz(vertices, faces[t, 0])
    bx, by, bz = xyz(vertices, faces[t, 1])
    cx, cy, cz = xyz(vertices, faces[t, 2])
    planes[t, 0], planes[t, 1], planes[t, 2] = x, y, z
    planes[t, 3] = (x * (ax + bx + cx) + y * (ay + by + cy) + z * (az + bz + cz)) / 3


@kernel
def _set_normal(normals: FloatArray, t: int, vertices: FloatArray, faces: IntArray) -> float:
    """Note the unit normal of face t, zero where it has no area; returns its double area."""
    x, y, z = triangle_vector(vertices, faces[t, 0], faces[t, 1], faces[t, 2])
    length = np.sqrt(x * x + y * y + z * z)
    factor = 1 / length if length > 0 else 0.0
    normals[t, 0], normals[t, 1], normals[t, 2] = factor * x, factor * y, factor * z
    double_area: float = length
    return double_area


@parallel_kernel
def set_normals(vertices: FloatArray, faces: IntArray, normals: FloatArray) -> None:
    """Note the unit normal (n, 3) of each face, zero for a face without area."""
    for t in prange(len(faces)):
        _set_normal(normals, t, vertices, faces)


@parallel_kernel
def set_areas_and_normals(
    vertices: FloatArray, faces: IntArray, areas: FloatArray, normals: FloatArray
) -> None:
    """Note area (n,) and unit normal (n, 3) of each face; both zero for a face without area."""
    for t in prange(len(faces)):
        areas[t] = _set_normal(normals, t, vertices, faces) / 2
