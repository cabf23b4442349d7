"""Small holes, and patches for them.

A patch uses the vertices of its loop alone: of all ways to cut the loop into triangles it takes
the one of the least area, with short edges among equals, by dynamic programming over
the stretches of the loop [1]_.

.. [1] G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron*, Computer Aided
   Geometric Design 12(2), 1995.
"""

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

import numpy as np

from core.arrays import IntArray
from core.doctor.boundary import boundary_loops, loop_count, simple_loops
from core.doctor.degenerate import joined, without_collapsed
from core.doctor.duplicates import places
from core.doctor.patches import patch
from core.doctor.spec import (
    FindingSpec,
    Found,
    Numbers,
    Repaired,
    RepairSpec,
    counted,
    ends_of,
    rebuilt,
    unchanged,
)
from core.mesh import TriangleMesh
from core.mesh.geometry import face_areas
from core.parameters import Params, param

# A patch that would be larger than this share of its component closes an end, not a hole.
_LARGEST_SHARE = 0.25


Triple: TypeAlias = tuple[int, ...]


class FillParams(Params):
    """Which holes are small."""

    most_edges: int = param(
        30, low=3, high=200, step=1, help="Holes with at most this many edges are filled; more "
        "fills larger ones.",
    )  # fmt: skip


class Filling(NamedTuple):
    """How small holes are filled.

    Attributes
    ----------
    faces : (n, 3) int64 ndarray
        Faces of the mesh; where a loop comes back to a place, by the first vertex there.
    patches : list of (k, 3) int32 ndarray
        New faces, hole by hole.
    """

    faces: Numbers
    patches: list[IntArray]


def plan_filling(mesh: TriangleMesh, most_edges: int) -> Filling:
    """Find the patches for all holes of at most `most_edges` edges.

    A loop that comes back to a place is several holes that touch there. Its vertices there are
    joined, because the patches fill the gap between; where they do not, the vertices stay apart.
    """
    pairs = _returns(mesh)
    while True:
        number = joined(len(mesh.vertices), pairs)
        faces = without_collapsed(number[mesh.faces])
        patches = _patches(TriangleMesh(mesh.vertices, faces), most_edges)
        filled = TriangleMesh(mesh.vertices, np.concatenate([faces, *patches]))
        bad = filled.topology.pinched_vertices.copy()
        bad[ends_of(filled, filled.topology.nonmanifold_edges)] = True
        spoiled = bad[number[pairs[:, 0]]]
        if not spoiled.any():
            return Filling(faces, patches)
        pairs = pairs[~spoiled]


def _returns(mesh: TriangleMesh) -> Numbers:
    """Pairs of vertices of one loop at one place, (p, 2); the first of a place stands first."""
    where = places(mesh)
    pairs = [np.zeros((0, 2), np.int64)]
    for loop in boundary_loops(mesh):
        _, first, group = np.unique(where[loop], return_index=True, return_inverse=True)
        pair = np.stack([loop[first[group]], loop], axis=1)
        pairs.append(pair[pair[:, 0] != pair[:, 1]])
    return np.concatenate(pairs)


def _patches(mesh: TriangleMesh, most_edges: int) -> list[IntArray]:
    """Patches of all simple loops that can be filled."""
    owner = mesh.topology.vertex_components
    areas = np.bincount(owner[mesh.faces[:, 0]], face_areas(mesh), mesh.topology.component_count)
    taken: set[tuple[int, int]] = set()
    where, covered = places(mesh), _covered(mesh)
    patches = []
    for loop in simple_loops(mesh):
        folded = len(np.unique(where[loop])) < len(loop)
        if folded or not 3 <= len(loop) <= most_edges:
            continue
        made, area = _patch_of(mesh, loop)
        inner = set(_inner_edges(made, loop))
        small = len(made) and area <= _LARGEST_SHARE * areas[owner[loop[0]]]
        if small and not inner & taken and covered.isdisjoint(_triples(where[made])):
            taken |= inner
            covered.update(_triples(where[made]))
            patches.append(made)
    return patches


def _covered(mesh: TriangleMesh) -> set[Triple]:
    """Places of the faces at the boundary, on which no patch may lie."""
    where = places(mesh)
    near = np.zeros(len(mesh.vertices), np.bool_)
    near[where[mesh.topology.boundary_vertices]] = True
    faces = where[mesh.faces]
    return set(_triples(faces[near[faces].any(axis=1)]))


def _triples(faces: Numbers) -> Iterator[Triple]:
    yield from map(tuple, np.sort(faces, axis=1).tolist())


def _patch_of(mesh: TriangleMesh, loop: IntArray) -> tuple[IntArray, float]:
    ring = mesh.topology.vertex_ring
    faces: IntArray
    faces, area = patch(np.ascontiguousarray(mesh.vertices[loop]), loop, ring.starts, ring.items)
    return loop[faces], area


def _inner_edges(faces: IntArray, loop: IntArray) -> Iterator[tuple[int, int]]:
    """Edges of a patch that are not edges of its loop."""
    round_loop = {frozenset(pair) for pair in zip(loop, np.roll(loop, -1), strict=True)}
    for face in faces.tolist():
        for a, b in zip(face, face[1:] + face[:1], strict=True):
            if a < b and frozenset((a, b)) not in round_loop:
                yield a, b


def _look(mesh: TriangleMesh) -> Found | None:
    edges = mesh.topology.boundary_edges
    if not edges.any():
        return None
    loops, most = loop_count(mesh), FillParams().most_edges
    small = len(plan_filling(mesh, most).patches)
    text = f"{counted(loops, 'boundary loop')} with {counted(int(edges.sum()), 'edge')}; "
    text += f"{counted(small, 'small hole') if small else 'no small hole'} to fill."
    return Found(loops, text, ends_of(mesh, edges))


def fill_holes(mesh: TriangleMesh, params: FillParams) -> Repaired:
    """Fill the small holes with triangles between the vertices of their boundary.

    A loop is left open if it has more edges than the parameter says, runs along faces that are
    not wound consistently, would need an edge that is there already, or if its patch would be
    larger than a quarter of its component.
    """
    faces, patches = plan_filling(mesh, params.most_edges)
    if not patches:
        return unchanged(mesh)
    added = counted(sum(map(len, patches)), "face")
    change = f"Filled {counted(len(patches), 'hole')} with {added}."
    return rebuilt(mesh, np.concatenate([faces, *patches]), change)


BOUNDARY = FindingSpec(
    id="boundary",
    title="Open boundary",
    meaning="Vertices of a boundary have neighbours on one side only: smoothing draws them "
    "inwards, and the model has no genus.",
    look=_look,
    level="note",
)

REPAIR = RepairSpec(
    id="fill_holes",
    title="Fill small holes",
    summary="Closes boundary loops of few edges with flat triangles between their vertices.",
    apply=fill_holes,
    removes=(),
    eases=(BOUNDARY,),
    params=FillParams,
    keeps_shape=False,
)
