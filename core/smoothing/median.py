"""Angle-median filter of face normals, thesis §2.3.2."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange, unsigned
from core.mesh import TriangleMesh
from core.parameters import Params
from core.smoothing.normal_update import fit_vertices, set_areas_and_normals, set_plane
from core.smoothing.selection import select
from core.smoothing.spec import MethodSpec

# Faces a thread handles before it needs new tables: enough to make the tables free, few enough to
# share the work evenly.
_BLOCK = 2048
# Faces whose rings are sorted side by side: enough for the inner loop to be vector instructions.
_COLUMNS = 64
# Longest ring that is sorted, which takes the square of its length; of longer ones the median is
# selected, which takes its length: all faces around one vertex are each other's rings.
_LONGEST_SORTED = 64
# A cosine of no angle, which fills the columns of shorter rings.
_BELOW_ALL = -2.0


class MedianParams(Params):
    """The angle-median filter has no parameters."""


@kernel
def _longest_row(starts: IntArray, first: int, last: int) -> int:
    length = 0
    for t in range(first, last):
        length = max(length, len(range(starts[t], starts[t + 1])))
    return length


@kernel
def _fill_columns(
    columns: FloatArray,
    counts: IntArray,
    normals: FloatArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
) -> None:
    """Note the cosines of the angles between each face and its ring, a column a face.

    A face without a normal makes no angle, so it does not count.
    """
    columns[:] = _BELOW_ALL
    for t in range(first, last):
        column = t - first
        count = 0
        for slot, other in enumerate(items[starts[t] : starts[t + 1]]):
            cosine = (
                normals[t, 0] * normals[other, 0]
                + normals[t, 1] * normals[other, 1]
                + normals[t, 2] * normals[other, 2]
            )
            if cosine != 0 or normals[other].any():
                columns[slot, column] = cosine
                count += 1
        counts[column] = count


@kernel
def _sort_upper_half(columns: FloatArray, height: int) -> None:
    """Bring the larger half of each column to its top, in descending order.

    A selection sort that swaps without branches, on all columns at once.
    """
    for top in range((height + 1) // 2):
        for slot in range(top + 1, height):
            for column in range(columns.shape[1]):
                upper, lower = columns[top, column], columns[slot, column]
                columns[top, column] = upper if upper > lower else lower
                columns[slot, column] = lower if upper > lower else upper


@kernel
def _find_medians(
    cosines: FloatArray, columns: FloatArray, counts: IntArray, height: int, slots: FloatArray
) -> None:
    """Note the first slot of each column that holds its lower median, from the sorted columns."""
    slots[:] = 0
    medians = np.empty(_COLUMNS)
    for column in range(_COLUMNS):
        medians[column] = columns[max(counts[column] - 1, 0) // 2, column]
    for slot in range(height - 1, -1, -1):
        _note_equal(cosines[slot], medians, slot, slots)


@kernel
def _note_equal(row: FloatArray, medians: FloatArray, slot: float, slots: FloatArray) -> None:
    """Note a slot, as wide as a cosine, without branches, so that vector instructions do it."""
    for column in range(len(row)):
        slots[column] = slot if row[column] == medians[column] else slots[column]


@kernel
def _set_by_sorting(
    normals: FloatArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
    cosines: FloatArray,
    columns: FloatArray,
    counts: IntArray,
    slots: FloatArray,
    medians: IntArray,
) -> None:
    """Note the median faces of some faces with short rings; four tables are scratch."""
    height = len(cosines)
    _fill_columns(cosines, counts, normals, first, last, starts, items)
    columns[:] = cosines
    _sort_upper_half(columns, height)
    _find_medians(cosines, columns, counts, height, slots)
    for t in range(first, last):
        slot = np.uint32(slots[t - first])
        medians[t] = items[starts[t] + slot] if counts[t - first] > 0 else t


@kernel
def _set_by_selecting(
    normals: FloatArray,
    first: int,
    last: int,
    starts: IntArray,
    items: IntArray,
    cosines: FloatArray,
    spare: FloatArray,
    counts: IntArray,
    medians: IntArray,
) -> None:
    """Note the median faces of some faces with rings of any length; three tables are scratch."""
    for t in range(first, last):
        medians[t] = t
        ring = items[starts[t] : starts[t + 1]]
        row = cosines[: len(ring)]
        _fill_columns(row, counts, normals, t, t + 1, starts, items)
        if counts[0] == 0:
            continue
        spare[: len(ring)] = row[:, 0]
        median = select(spare[: len(ring)], len(ring) - 1 - (counts[0] - 1) // 2)
        for slot, other in enumerate(ring):
            if row[slot, 0] == median:
                medians[t] = other
                break


@parallel_kernel
def set_median_faces(
    normals: FloatArray, starts: IntArray, items: IntArray, longest: int, medians: IntArray
) -> None:
    """Note the face of each ring whose normal makes the lower median angle with its face's, (n,).

    A face without a ring is its own. Ascending angles are descending cosines.
    """
    n = len(normals)
    for block in prange((n + _BLOCK - 1) // _BLOCK):
        cosines = np.empty((_LONGEST_SORTED, _COLUMNS))
        columns = np.empty((_LONGEST_SORTED, _COLUMNS))
        row, spare = np.empty((longest, 1)), np.empty(longest)
        counts, slots = np.zeros(_COLUMNS, np.int32), np.zeros(_COLUMNS)
        for first in range(block * _BLOCK, min((block + 1) * _BLOCK, n), _COLUMNS):
            last = min(first + _COLUMNS, n)
            height = _longest_row(starts, first, last)
            if height > _LONGEST_SORTED:
                _set_by_selecting(normals, first, last, starts, items, row, spare, counts, medians)
            else:
                tables = cosines[:height], columns[:height], counts, slots
                _set_by_sorting(normals, first, last, starts, items, *tables, medians)


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
        source = sources[t]
        x, y, z = normals[source, 0], normals[source, 1], normals[source, 2]
        set_plane(planes, t, vertices, faces, x, y, z)


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
    face_ring = unsigned(*mesh.topology.face_ring)
    vertex_faces = unsigned(*mesh.topology.vertex_faces)
    longest = int(mesh.topology.face_ring.lengths.max(initial=1))
    n = len(faces)
    areas, normals, planes = np.empty(n), np.empty((n, 3)), np.empty((n, 4))
    medians = np.empty(n, np.int32)
    vertices = mesh.vertices
    while True:
        set_areas_and_normals(vertices, faces, areas, normals)
        set_median_faces(normals, *face_ring, longest, medians)
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
