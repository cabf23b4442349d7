"""Angle-median filter of face normals, thesis §2.3.2."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.mesh.face_rings import FaceRings
from core.parameters import Params
from core.smoothing.median_faces import set_median_faces
from core.smoothing.normal_update import fit_vertices, set_areas_and_normals, set_plane
from core.smoothing.spec import MethodSpec


class MedianParams(Params):
    """The angle-median filter has no parameters."""


@parallel_kernel
def _set_turned_planes(
    vertices: FloatArray,
    faces: IntArray,
    normals: FloatArray,
    sources: IntArray,
    planes: FloatArray,
) -> None:
    """Note the plane of each face along the normal of the face `sources` names for it, (n, 4)."""
    for t in prange(len(faces)):
        x, y, z = xyz(normals, sources[t])
        set_plane(planes, t, vertices, faces, x, y, z)


def steps(mesh: TriangleMesh, params: MedianParams) -> Iterator[FloatArray | None]:
    """Yield the positions after each iteration of the angle-median filter.

    Replaces the normal of each face tᵢ by that of the face t̂ⱼ in tᵢ* where the angle
    θᵢⱼ = ∠(n(tᵢ), n(tⱼ)) takes its median, then moves the vertices as the mean filter does.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh, consistently wound.
    params : MedianParams
        None to set.

    Yields
    ------
    (m, 3) float64 ndarray or None
        Positions; a vertex whose faces have no area stays where it is. None between the parts of
        an iteration where very many faces meet in one vertex.

    Notes
    -----
    An even number of angles takes the lower median, so that it belongs to a real face; of faces
    with equal angles the first is taken, by the numbers of `mesh`, which a run along the surface
    (:meth:`TriangleMesh.along_surface`) has chosen itself. A face without area counts as nothing.
    It commutes with moving, turning and scaling, and with renumbering where no two angles are
    equal.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.3.2.
    Yagou, Ohtake, Belyaev, *Mesh smoothing via mean and median filtering applied to face
    normals*, GMP 2002.
    """
    (faces,) = unsigned(mesh.faces)
    rings = FaceRings(mesh.topology)
    vertex_faces = unsigned(*mesh.topology.vertex_faces)
    n = len(faces)
    areas, normals, planes = np.empty(n), np.empty((n, 3)), np.empty((n, 4))
    medians = np.empty(n, np.int32)
    vertices = mesh.vertices
    while True:
        set_areas_and_normals(vertices, faces, areas, normals)
        for first, starts, items in rings.parts():
            if first > 0:
                yield None
            ring = unsigned(starts, items)
            set_median_faces(normals, first, *ring, medians)
        _set_turned_planes(vertices, faces, normals, medians, planes)
        vertices = fit_vertices(vertices, *vertex_faces, areas, planes)
        yield vertices


SPEC = MethodSpec(
    id="median",
    title="Angle median filter",
    params=MedianParams,
    steps=steps,
    summary="Gives each face the normal at the median angle of its ring and fits the vertices.",
    formula="m(tᵢ) = n(t̂ⱼ) with ∠(n(tᵢ), n(t̂ⱼ)) = medianⱼ ∠(n(tᵢ), n(tⱼ)); then as the mean",
    reference="Thesis §2.3.2; Yagou, Ohtake, Belyaev, GMP 2002",
    departure="An even number of angles takes the lower median, which belongs to a real face.",
)
