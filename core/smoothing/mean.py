"""Mean filter of face normals, thesis §2.3.1 and eq. (5)."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.mesh.face_rings import FaceRings
from core.mesh.triangles import triangle_vector
from core.parameters import Params
from core.smoothing.normal_update import fit_vertices, set_plane
from core.smoothing.spec import MethodSpec

# Normals whose mean is no longer than this cancel; what is left of them is rounding.
_CANCELLED = 1e-9


class MeanParams(Params):
    """The mean filter has no parameters."""


@parallel_kernel
def set_area_vectors(
    vertices: FloatArray, faces: IntArray, areas: FloatArray, vectors: FloatArray
) -> None:
    """Note A(t), (n,), and A(t) n(t), (n, 3), of each face."""
    for t in prange(len(faces)):
        x, y, z = triangle_vector(vertices, faces[t, 0], faces[t, 1], faces[t, 2])
        areas[t] = np.sqrt(x * x + y * y + z * z) / 2
        vectors[t, 0], vectors[t, 1], vectors[t, 2] = x / 2, y / 2, z / 2


@parallel_kernel
def set_mean_planes(
    vertices: FloatArray,
    faces: IntArray,
    areas: FloatArray,
    vectors: FloatArray,
    first: int,
    starts: IntArray,
    items: IntArray,
    planes: FloatArray,
) -> None:
    """Note the planes of a part of the faces along the mean normals of their rings, (n, 4)."""
    for i in prange(len(starts) - 1):
        t = first + i
        x = y = z = total = 0.0
        for k in range(starts[i], starts[i + 1]):
            a, b, c = xyz(vectors, items[k])
            x, y, z, total = x + a, y + b, z + c, total + areas[items[k]]
        length = np.sqrt(x * x + y * y + z * z)
        if length <= _CANCELLED * total:
            (x, y, z), length = xyz(vectors, t), areas[t]
        factor = 1 / length if length > 0 else 0.0
        set_plane(planes, t, vertices, faces, factor * x, factor * y, factor * z)


def steps(mesh: TriangleMesh, params: MeanParams) -> Iterator[FloatArray | None]:
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
    (m, 3) float64 ndarray or None
        Positions; a vertex whose faces have no area stays where it is. None between the parts of
        an iteration where very many faces meet in one vertex.

    Notes
    -----
    tᵢ* leaves out tᵢ itself, as printed. A face whose ring cancels, ‖m(tᵢ)‖ ≤ 10⁻⁹ before step 2,
    keeps its own normal. A face without area counts as nothing. Areas and normals are those of
    the current positions. It commutes with moving, turning and scaling.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.3.1, eq. (5).
    Yagou, Ohtake, Belyaev, *Mesh smoothing via mean and median filtering applied to face
    normals*, GMP 2002.
    """
    (faces,) = unsigned(mesh.faces)
    rings = FaceRings(mesh.topology)
    vertex_faces = unsigned(*mesh.topology.vertex_faces)
    n = len(faces)
    areas, vectors, planes = np.empty(n), np.empty((n, 3)), np.empty((n, 4))
    vertices = mesh.vertices
    while True:
        set_area_vectors(vertices, faces, areas, vectors)
        for first, starts, items in rings.parts():
            if first > 0:
                yield None
            ring = unsigned(starts, items)
            set_mean_planes(vertices, faces, areas, vectors, first, *ring, planes)
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
