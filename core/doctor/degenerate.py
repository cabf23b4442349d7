"""Faces without area: two corners at one place, or three in a line."""

import numpy as np
import scipy

from core.arrays import BoolArray, FloatArray, IntArray, first_rows
from core.doctor.spec import (
    FindingSpec,
    Found,
    NoParams,
    Numbers,
    Repaired,
    RepairSpec,
    corners_of,
    counted,
    rebuilt,
    unchanged,
)
from core.kernels import parallel_kernel, prange
from core.mesh import TriangleMesh
from core.mesh.triangles import triangle_vector
from core.stepwise import Stepwise, at_once

# Height over the longest edge: below it a face is flat within the rounding of any file.
FLAT = 1e-10
# Shortest over longest edge: below it the short edge's ends are one place.
_SHORT = 1e-6
_ROUNDS = 100


def degenerate_faces(mesh: TriangleMesh) -> BoolArray:
    """Mask of the faces whose height is at most 1e-10 of their longest edge, (n,)."""
    mask: BoolArray = _flat_faces(mesh.vertices, mesh.faces)
    return mask


@parallel_kernel
def _flat_faces(vertices: FloatArray, faces: IntArray) -> BoolArray:
    mask = np.zeros(len(faces), np.bool_)
    for t in prange(len(faces)):
        x, y, z = triangle_vector(vertices, faces[t, 0], faces[t, 1], faces[t, 2])
        longest = 0.0
        for c in range(3):
            i, j = faces[t, c], faces[t, (c + 1) % 3]
            squared = 0.0
            for axis in range(3):
                squared += (vertices[i, axis] - vertices[j, axis]) ** 2
            longest = max(longest, squared)
        mask[t] = np.sqrt(x * x + y * y + z * z) <= FLAT * longest
    return mask


def _edge_lengths(mesh: TriangleMesh) -> FloatArray:
    corners = mesh.vertices[mesh.faces]
    lengths: FloatArray = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    return lengths


@at_once
def _look(mesh: TriangleMesh) -> Found | None:
    faces = np.flatnonzero(degenerate_faces(mesh))
    if not len(faces):
        return None
    text = f"{counted(len(faces), 'face')} without area: corners at one place or in a line."
    return Found(len(faces), text, corners_of(mesh, faces))


def remove_degenerate_faces(mesh: TriangleMesh, params: NoParams) -> Stepwise[Repaired]:
    """Remove faces without area and leave no crack where that is possible.

    A face with two corners at one place loses the edge between them. One whose corners lie in a
    line exchanges its longest edge with the face beyond it, so that the corner in the middle
    becomes a corner of both. What is left is dropped. No vertex moves.

    Raises
    ------
    RepairError
        If every face is without area.
    """
    before = int(degenerate_faces(mesh).sum())
    if not before:
        return unchanged(mesh)
    faces = _without_short_edges(mesh)
    faces, flipped = yield from _without_caps(mesh, faces)
    left = degenerate_faces(TriangleMesh(mesh.vertices, faces))
    turned = f", {counted(flipped, 'edge')} exchanged" if flipped else ""
    return rebuilt(mesh, faces[~left], f"Removed {counted(before, 'face')} without area{turned}.")


def _without_short_edges(mesh: TriangleMesh) -> Numbers:
    """Faces after the very short edges of flat faces are drawn together into one end."""
    lengths = _edge_lengths(mesh)
    flat = degenerate_faces(mesh)[:, None]
    short = flat & (lengths <= _SHORT * lengths.max(axis=1, initial=0)[:, None])
    ends = mesh.edges[np.unique(mesh.topology.face_edges[short])]
    number = joined(len(mesh.vertices), ends)
    return without_collapsed(number[mesh.faces])


def joined(count: int, pairs: Numbers) -> Numbers:
    """For vertices joined in pairs, (p, 2): the first vertex of the group of each, (count,)."""
    ones = np.ones(len(pairs), np.int8)
    graph = scipy.sparse.coo_array((ones, (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    labels = scipy.sparse.csgraph.connected_components(graph, directed=False)[1]
    first = np.unique(labels, return_index=True)[1]
    groups: Numbers = first[labels]
    return groups


def without_collapsed(faces: Numbers) -> Numbers:
    """Faces that name three different vertices."""
    proper: Numbers = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    return proper


def _without_caps(mesh: TriangleMesh, faces: Numbers) -> Stepwise[tuple[Numbers, int]]:
    """Exchange the longest edges of flat faces, round by round; also returns how many."""
    count = 0
    for _ in range(_ROUNDS if len(faces) else 0):
        current = TriangleMesh(mesh.vertices, faces)
        old, new = _exchanges(current)
        if not len(old):
            break
        faces = np.delete(faces, old.ravel(), axis=0)
        faces = np.concatenate([faces, new.reshape(-1, 3)])
        count += len(old)
        yield
    return faces, count


def _exchanges(mesh: TriangleMesh) -> tuple[Numbers, Numbers]:
    """Pairs of faces, (k, 2), and the pairs that take their place, (k, 2, 3); no face twice."""
    flat = np.flatnonzero(degenerate_faces(mesh))
    corner = _edge_lengths(mesh)[flat].argmax(axis=1)
    edge = mesh.topology.face_edges[flat, corner]
    inner = mesh.topology.edge_corners.lengths[edge] == 2
    flat, corner, edge = flat[inner], corner[inner], edge[inner]
    starts, items = mesh.topology.edge_corners
    beyond = np.where(
        items[starts[edge]] // 3 == flat, items[starts[edge] + 1], items[starts[edge]]
    )
    old = np.stack([flat, beyond // 3], axis=1).astype(np.int64)
    a, b, p = (mesh.faces[flat, (corner + step) % 3] for step in range(3))
    d = mesh.faces[old[:, 1], beyond % 3]
    new = np.stack([np.stack([p, a, d], axis=1), np.stack([d, b, p], axis=1)], axis=1)
    # The face beyond must run along the edge the other way, as two sides of one surface do.
    fits = mesh.faces[old[:, 1], (beyond % 3 + 1) % 3] == b
    fits &= ~_are_edges(mesh, p, d) & (_have_area(mesh, new) | _is_shorter(mesh, p, d, a, b))
    return _apart(old[fits], new[fits].astype(np.int64), len(mesh.faces))


def _are_edges(mesh: TriangleMesh, p: Numbers, d: Numbers) -> BoolArray:
    known = mesh.edges[:, 0].astype(np.int64) * len(mesh.vertices) + mesh.edges[:, 1]
    asked = np.minimum(p, d).astype(np.int64) * len(mesh.vertices) + np.maximum(p, d)
    mask: BoolArray = np.isin(asked, known) | (p == d)
    return mask


def _have_area(mesh: TriangleMesh, pairs: Numbers) -> BoolArray:
    faces = pairs.reshape(-1, 3)
    distinct = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    good = np.zeros(len(faces), np.bool_)
    good[distinct] = ~degenerate_faces(TriangleMesh(mesh.vertices, faces[distinct]))
    pairs_good = good.reshape(-1, 2)
    both: BoolArray = pairs_good[:, 0] & pairs_good[:, 1]
    return both


def _is_shorter(mesh: TriangleMesh, p: Numbers, d: Numbers, a: Numbers, b: Numbers) -> BoolArray:
    """Mask of the pairs pd that are closer together than ab; each such exchange is progress."""
    vertices = mesh.vertices
    new = np.linalg.norm(vertices[p] - vertices[d], axis=1)
    mask: BoolArray = new < np.linalg.norm(vertices[a] - vertices[b], axis=1)
    return mask


def _apart(old: Numbers, new: Numbers, face_count: int) -> tuple[Numbers, Numbers]:
    """Keep exchanges that share no face and make no edge twice, the first of each."""
    rank = np.arange(len(old))
    owner = np.full(face_count, len(old))
    for side in range(2):
        np.minimum.at(owner, old[:, side], rank)
    first = (owner[old] == rank[:, None]).all(axis=1)
    made = np.sort(new[:, 0, [0, 2]], axis=1)
    once = np.zeros(len(old), np.bool_)
    once[first_rows(made)] = True
    return old[first & once], new[first & once]


DEGENERATE = FindingSpec(
    id="degenerate_faces",
    title="Faces without area",
    meaning="They have no area and no normal: the filters of normals and the weights by angle "
    "count them as nothing. Their edges still make neighbours of their vertices.",
    look=_look,
)

REPAIR = RepairSpec(
    id="degenerate_faces",
    title="Remove faces without area",
    summary="Draws edges without length together and exchanges the longest edge of faces whose "
    "corners lie in a line.",
    apply=remove_degenerate_faces,
    removes=(DEGENERATE,),
)
