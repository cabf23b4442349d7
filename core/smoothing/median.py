"""Angle-median filter of face normals, thesis §2.3.2."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange
from core.mesh import TriangleMesh
from core.parameters import Params
from core.smoothing.normal_update import areas_and_normals, fit_vertices
from core.smoothing.spec import MethodSpec

# Faces a thread handles before it needs a new buffer: enough to make the buffer free, few enough
# to share the work evenly.
_BLOCK = 2048
_SHORT_ROW = 64


class MedianParams(Params):
    """The angle-median filter has no parameters."""


@kernel
def _at_rank(values: FloatArray, rank: int) -> int:
    """Index of the value at `rank` (from 0) of the descending order, the first of equal ones.

    Counts for each value the larger ones: for a dozen values that is quicker than any sorting,
    because the inner loop has no branches.
    """
    for a in range(len(values)):
        larger = equal = 0
        for b in range(len(values)):
            larger += values[b] > values[a]
            equal += values[b] == values[a]
        if larger <= rank < larger + equal:
            return a
    return 0


@kernel
def _first_at_rank(values: FloatArray, rank: int) -> int:
    """Index of the value at `rank` as :func:`_at_rank`, for long rows: by sorting."""
    sought = np.sort(values)[len(values) - 1 - rank]
    for a in range(len(values)):
        if values[a] == sought:
            return a
    return 0


@kernel
def _median_face(normals: FloatArray, t: int, ring: IntArray, cosines: FloatArray) -> int:
    """Face of the ring whose normal makes the lower median angle with that of t."""
    for slot in range(len(ring)):
        other = ring[slot]
        cosines[slot] = (
            normals[t, 0] * normals[other, 0]
            + normals[t, 1] * normals[other, 1]
            + normals[t, 2] * normals[other, 2]
        )
    # Ascending angles are descending cosines.
    rank = (len(ring) - 1) // 2
    short = len(ring) <= _SHORT_ROW
    face: int = ring[_at_rank(cosines, rank) if short else _first_at_rank(cosines, rank)]
    return face


@parallel_kernel
def _median_normals(
    normals: FloatArray, starts: IntArray, items: IntArray, longest: int
) -> FloatArray:
    medians = normals.copy()
    for block in prange((len(normals) + _BLOCK - 1) // _BLOCK):
        cosines = np.zeros(longest)
        for t in range(block * _BLOCK, min((block + 1) * _BLOCK, len(normals))):
            ring = items[starts[t] : starts[t + 1]]
            if len(ring) == 0:
                continue
            face = _median_face(normals, t, ring, cosines[: len(ring)])
            for x in range(3):
                medians[t, x] = normals[face, x]
    return medians


def steps(mesh: TriangleMesh, params: MedianParams) -> Iterator[FloatArray]:
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
    (m, 3) float64 ndarray
        Positions; a vertex whose faces have no area stays where it is.

    Notes
    -----
    An even number of angles takes the lower median, so that it belongs to a real face; of faces
    with equal angles the one with the smallest number is taken. It commutes with moving, turning
    and scaling, and with renumbering where no two angles are equal.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.3.2.
    Yagou, Ohtake, Belyaev, *Mesh smoothing via mean and median filtering applied to face
    normals*, GMP 2002.
    """
    topology = mesh.topology
    longest = int(topology.face_ring.lengths.max(initial=1))
    vertices = mesh.vertices
    while True:
        areas, normals = areas_and_normals(vertices, mesh.faces)
        medians = _median_normals(normals, *topology.face_ring, longest)
        vertices = fit_vertices(vertices, mesh.faces, *topology.vertex_faces, areas, medians)
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
