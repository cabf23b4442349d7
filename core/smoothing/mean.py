"""Mean filter of face normals, thesis §2.3.1 and eq. (5)."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange, unsigned
from core.mesh import TriangleMesh
from core.mesh.geometry import face_vectors
from core.parameters import Params
from core.smoothing.normal_update import fit_vertices, set_plane
from core.smoothing.spec import MethodSpec


class MeanParams(Params):
    """The mean filter has no parameters."""


@parallel_kernel
def mean_planes(
    vertices: FloatArray,
    faces: IntArray,
    vectors: FloatArray,
    starts: IntArray,
    items: IntArray,
) -> tuple[FloatArray, FloatArray]:
    """Area of each face, and its plane along the mean normal of its ring.

    `vectors` are 2 A(t) n(t), so that their sum is the area-weighted mean but for its length.
    """
    areas, planes = np.empty(len(faces)), np.empty((len(faces), 4))
    for t in prange(len(faces)):
        x = y = z = 0.0
        for other in items[starts[t] : starts[t + 1]]:
            x += vectors[other, 0]
            y += vectors[other, 1]
            z += vectors[other, 2]
        own = vectors[t]
        areas[t] = np.sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]) / 2
        if x == 0 and y == 0 and z == 0:
            x, y, z = own[0], own[1], own[2]
        set_plane(planes, t, vertices, faces, x, y, z)
    return areas, planes


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
    (faces,) = unsigned(mesh.faces)
    face_ring = unsigned(*mesh.topology.face_ring)
    vertex_faces = unsigned(*mesh.topology.vertex_faces)
    vertices = mesh.vertices
    while True:
        vectors = face_vectors(vertices, faces)
        areas, planes = mean_planes(vertices, faces, vectors, *face_ring)
        vertices = fit_vertices(vertices, *vertex_faces, areas, planes)
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
