"""Which small holes can be filled, and with what."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.doctor.boundary import boundary_loops, simple_loops
from core.doctor.degenerate import joined, without_collapsed
from core.doctor.duplicates import places
from core.doctor.patches import patches_of
from core.doctor.spec import Numbers, ends_of
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.mesh.geometry import face_areas
from core.mesh.topology import Rows
from core.stepwise import Stepwise

# A patch that would be larger than this share of its component closes an end, not a hole.
_LARGEST_SHARE = 0.25
# Third powers of the lengths of loops that are handled at one go, in a fraction of a second.
_STEP = 1e8


class Filling(NamedTuple):
    """How small holes are filled.

    Attributes
    ----------
    faces : (n, 3) int64 ndarray
        Faces of the mesh; where a loop comes back to a place, by the first vertex there.
    patches : (k, 3) int32 ndarray
        New faces.
    holes : int
        Number of the holes that they fill.
    """

    faces: Numbers
    patches: IntArray
    holes: int


class _Patches(NamedTuple):
    """The best patch of each loop: corners in the loop, loop of each face, area of each patch."""

    corners: IntArray
    loop: Numbers
    areas: FloatArray


def filling_steps(mesh: TriangleMesh, most_edges: int) -> Stepwise[Filling]:
    """Find the patches for all holes of at most `most_edges` edges.

    A loop that comes back to a place is several holes that touch there. Its vertices there are
    joined, because the patches fill the gap between; where they do not, the vertices stay apart.
    """
    pairs = _returns(mesh)
    while True:
        number = joined(len(mesh.vertices), pairs)
        faces = without_collapsed(number[mesh.faces])
        patches, holes = yield from _patch_steps(TriangleMesh(mesh.vertices, faces), most_edges)
        filled = TriangleMesh(mesh.vertices, np.concatenate([faces, patches]))
        bad = filled.topology.pinched_vertices.copy()
        bad[ends_of(filled, filled.topology.nonmanifold_edges)] = True
        spoiled = bad[number[pairs[:, 0]]]
        if not spoiled.any():
            return Filling(faces, patches, holes)
        pairs = pairs[~spoiled]


def _returns(mesh: TriangleMesh) -> Numbers:
    """Pairs of vertices of one loop at one place, (p, 2); the first of a place stands first."""
    loops = boundary_loops(mesh)
    _, first, group = np.unique(_places_on(mesh, loops), return_index=True, return_inverse=True)
    pairs = np.stack([loops.items[first[group]], loops.items], axis=1)
    different: Numbers = pairs[pairs[:, 0] != pairs[:, 1]].astype(np.int64)
    return different


def _places_on(mesh: TriangleMesh, loops: Rows) -> Numbers:
    """Number for each entry: equal where one loop comes to one place."""
    numbers: Numbers = _loop_numbers(loops) * len(mesh.vertices) + places(mesh)[loops.items]
    return numbers


def _loop_numbers(loops: Rows) -> Numbers:
    return np.repeat(np.arange(len(loops.lengths)), loops.lengths)


def _patch_steps(mesh: TriangleMesh, most_edges: int) -> Stepwise[tuple[IntArray, int]]:
    """Patches of all simple loops that can be filled, and how many these are."""
    loops = _short_loops(mesh, most_edges)
    best = yield from _best_patches(mesh, loops)
    owner = mesh.topology.vertex_components
    areas = np.bincount(owner[mesh.faces[:, 0]], face_areas(mesh), mesh.topology.component_count)
    small = best.areas <= _LARGEST_SHARE * areas[owner[loops.items[loops.starts[:-1]]]]
    faces = loops.items[loops.starts[best.loop][:, None] + best.corners]
    covered, triples = _triples(mesh, faces)
    filled = _chosen(small, best.loop, triples, covered, _inner_edges(loops, best, faces))
    return faces[filled[best.loop]], int(filled.sum())


def _short_loops(mesh: TriangleMesh, most_edges: int) -> Rows:
    """Simple loops of few edges that come to no place twice."""
    loops = simple_loops(mesh)
    _, first = np.unique(_places_on(mesh, loops), return_index=True)
    different = np.bincount(_loop_numbers(loops)[first], minlength=len(loops.lengths))
    short = (loops.lengths >= 3) & (loops.lengths <= most_edges) & (different == loops.lengths)
    starts = np.concatenate([[0], np.cumsum(loops.lengths[short])]).astype(np.int32)
    return Rows(starts, loops.items[np.repeat(short, loops.lengths)])


def _best_patches(mesh: TriangleMesh, loops: Rows) -> Stepwise[_Patches]:
    """Find the best patch of each loop, some loops at a time."""
    corners, areas = [np.zeros((0, 3), np.int32)], [np.zeros(0)]
    work = np.cumsum(loops.lengths.astype(np.float64) ** 3)
    cuts = np.searchsorted(work, np.arange(_STEP, work[-1] if len(work) else 0, _STEP))
    bounds = np.unique([0, *cuts, len(work)])
    for first, last in pairwise(bounds):
        starts = loops.starts[first : last + 1]
        found, area = patches_of(mesh.vertices, starts, loops.items, *mesh.topology.vertex_ring)
        corners.append(found)
        areas.append(area)
        yield
    counts = loops.lengths - 2
    loop = np.repeat(np.arange(len(counts)), counts)
    return _Patches(np.concatenate(corners), loop, np.concatenate(areas))


def _triples(mesh: TriangleMesh, faces: IntArray) -> tuple[BoolArray, Numbers]:
    """Mask of the triples of places at which there are faces at the boundary; triple of each face.

    On the former no patch may lie.
    """
    where = places(mesh)
    near = np.zeros(len(mesh.vertices), np.bool_)
    near[where[mesh.topology.boundary_vertices]] = True
    there = where[mesh.faces]
    there = there[near[there].any(axis=1)]
    numbers = _row_numbers(np.sort(np.concatenate([there, where[faces]]), axis=1))
    covered = np.zeros(len(numbers), np.bool_)
    covered[numbers[: len(there)]] = True
    return covered, numbers[len(there) :]


def _inner_edges(loops: Rows, best: _Patches, faces: IntArray) -> Numbers:
    """Number of each edge of each face, (k, 3), equal where its ends are; −1 on the loop."""
    ends, corners = (
        np.stack([table, np.roll(table, -1, axis=1)], axis=2) for table in (faces, best.corners)
    )
    steps = np.abs(corners[:, :, 0] - corners[:, :, 1])
    on_loop = (steps == 1) | (steps == loops.lengths[best.loop][:, None] - 1)
    numbers = _row_numbers(np.sort(ends.reshape(-1, 2), axis=1)).reshape(-1, 3)
    return np.where(on_loop, -1, numbers)


def _row_numbers(rows: Numbers | IntArray) -> Numbers:
    """Number of each row, below their count, equal where the rows are."""
    order = np.lexsort(rows.T)
    ordered = rows[order]
    is_new = np.zeros(len(rows), np.int64)
    is_new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    numbers = np.empty(len(rows), np.int64)
    numbers[order] = np.cumsum(is_new)
    return numbers


@kernel
def _chosen(
    small: BoolArray, loop: Numbers, triples: Numbers, covered: BoolArray, edges: Numbers
) -> BoolArray:
    """Mask of the loops whose patches lie on no face, and have no inner edge in common.

    Of two patches that do the first is chosen; its faces are then `covered` too.
    """
    taken = np.zeros(edges.size, np.bool_)
    chosen = small.copy()
    first = 0
    for hole in range(len(small)):
        last = first
        while last < len(loop) and loop[last] == hole:
            chosen[hole] &= not covered[triples[last]]
            for edge in edges[last]:
                chosen[hole] &= edge < 0 or not taken[edge]
            last += 1
        if chosen[hole]:
            for face in range(first, last):
                covered[triples[face]] = True
                for edge in edges[face]:
                    if edge >= 0:
                        taken[edge] = True
        first = last
    return chosen
