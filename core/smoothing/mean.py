"""Mean filter of face normals, thesis §2.3.1 and eq. (5)."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange
from core.mesh import TriangleMesh
from core.parameters import Params
from core.smoothing.normal_update import areas_and_normals, fit_vertices
from core.smoothing.spec import MethodSpec


class MeanParams(Params):
    """The mean filter has no parameters."""


@parallel_kernel
def _mean_normals(
    areas: FloatArray, normals: FloatArray, starts: IntArray, items: IntArray
) -> FloatArray:
    """Area-weighted mean normal over the ring of each face, scaled to unit length."""
    means = normals.copy()
    for t in prange(len(normals)):
        x = y = z = 0.0
        for other in items[starts[t] : starts[t + 1]]:
            x += areas[other] * normals[other, 0]
            y += areas[other] * normals[other, 1]
            z += areas[other] * normals[other, 2]
        length = np.sqrt(x * x + y * y + z * z)
        if length > 0:
            means[t, 0], means[t, 1], means[t, 2] = x / length, y / length, z / length
    return means


def steps(mesh: TriangleMesh, params: MeanParams) -> Iterator[FloatArray]:
    """Yield the positions after each iteration of the mean filter.

    1. m(tᵢ) = Σ A(tⱼ) n(tⱼ) / Σ A(tⱼ) over the faces tᵢ* that share a vertex or an edge with tᵢ.
    2. m(tᵢ) ← m(tᵢ)/‖m(tᵢ)‖.
    3. vᵢ ← vᵢ + Σ A(tⱼ) ⟨cⱼ − vᵢ, m(tⱼ)⟩ m(tⱼ) / Σ A(tⱼ) over T(vᵢ*), cⱼ the centroid of tⱼ.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh, consistently wound.
    params : MeanParams
        None to set.

    Yields
    ------
    (m, 3) float64 ndarray
        Positions; a vertex whose faces have no area stays where it is.

    Notes
    -----
    tᵢ* leaves out tᵢ itself, as printed. A face whose ring cancels keeps its own normal. Areas
    and normals are those of the current positions. It commutes with moving, turning and scaling.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.3.1, eq. (5).
    Yagou, Ohtake, Belyaev, *Mesh smoothing via mean and median filtering applied to face
    normals*, GMP 2002.
    """
    topology = mesh.topology
    vertices = mesh.vertices
    while True:
        areas, normals = areas_and_normals(vertices, mesh.faces)
        means = _mean_normals(areas, normals, *topology.face_ring)
        vertices = fit_vertices(vertices, mesh.faces, *topology.vertex_faces, areas, means)
        yield vertices


SPEC = MethodSpec(
    id="mean",
    title="Mean filter",
    params=MeanParams,
    steps=steps,
    summary="Averages the normals of neighbouring faces and fits the vertices to them.",
    formula="m(tᵢ) ∝ Σⱼ A(tⱼ) n(tⱼ);  vᵢ ← vᵢ + Σⱼ A(tⱼ) ⟨cⱼ − vᵢ, m(tⱼ)⟩ m(tⱼ) / Σⱼ A(tⱼ)",
    reference="Thesis §2.3.1, eq. (5); Yagou, Ohtake, Belyaev, GMP 2002",
)
