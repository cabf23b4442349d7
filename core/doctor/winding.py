"""The winding of faces: consistent, and outwards where that has a meaning."""

from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.doctor.remembering import remembered
from core.doctor.spec import (
    FindingSpec,
    Found,
    NoParams,
    Numbers,
    Repaired,
    RepairSpec,
    corners_of,
    counted,
    ends_of,
    unchanged,
)
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.stepwise import at_once

# Volume over the cube of the box's diagonal, below which a surface encloses nothing.
_NO_VOLUME = 1e-12


class Winding(NamedTuple):
    """How the faces are wound, sheet by sheet; a sheet hangs together across two-faced edges.

    Attributes
    ----------
    sheet : (n,) int32 ndarray
        Number of the sheet of each face.
    turned : (n,) bool ndarray
        Faces wound otherwise than the first face of their sheet.
    one_sided : (s,) bool ndarray
        Sheets that cannot be wound consistently.
    same_way : (e,) bool ndarray
        Edges along which two faces run the same way.
    """

    sheet: IntArray
    turned: BoolArray
    one_sided: BoolArray
    same_way: BoolArray


@remembered
def winding(mesh: TriangleMesh) -> Winding:
    """Walk over the faces and compare each with its neighbours; linear in their number."""
    topology = mesh.topology
    corners = topology.edge_corners
    sheet, turned, broken, same_way = _walk(
        mesh.faces, topology.face_edges, corners.starts, corners.items
    )
    one_sided = np.zeros(int(sheet.max(initial=-1)) + 1, np.bool_)
    one_sided[sheet[broken]] = True
    return Winding(sheet, turned, one_sided, same_way)


@kernel
def _walk(
    faces: IntArray, face_edges: IntArray, starts: IntArray, items: IntArray
) -> tuple[IntArray, BoolArray, BoolArray, BoolArray]:
    n = len(faces)
    sheet = np.full(n, -1, np.int32)
    turned, broken = np.zeros(n, np.bool_), np.zeros(n, np.bool_)
    same_way = np.zeros(len(starts) - 1, np.bool_)
    stack = np.zeros(max(n, 1), np.int32)
    number = -1
    for seed in range(n):
        if sheet[seed] >= 0:
            continue
        number += 1
        sheet[seed] = number
        stack[0], top = seed, 1
        while top > 0:
            top -= 1
            t = stack[top]
            for c in range(3):
                edge = face_edges[t, c]
                first = starts[edge]
                if starts[edge + 1] - first != 2:
                    continue
                corner = items[first + 1] if items[first] // 3 == t else items[first]
                other = corner // 3
                # Two sides of one surface run along their common edge in opposite directions.
                same = faces[t, c] == faces[other, (corner + 1) % 3]
                same_way[edge] = same
                if sheet[other] < 0:
                    sheet[other] = number
                    turned[other] = turned[t] != same
                    stack[top] = other
                    top += 1
                elif turned[other] != (turned[t] != same):
                    broken[t] = True
    return sheet, turned, broken, same_way


def faces_to_turn(mesh: TriangleMesh, state: Winding) -> BoolArray:
    """Mask of the faces to turn round so that every sheet is consistent, and outwards if closed.

    An open sheet, and a closed one inside the box of another (the wall of a hollow), follows the
    majority of its faces. A one-sided sheet stays as it is.
    """
    count = len(state.one_sided)
    sizes = np.bincount(state.sheet, minlength=count)
    turned = np.bincount(state.sheet, state.turned, count)
    follow = 2 * turned > sizes
    volume = _volumes(mesh, state)
    closed = _closed(mesh, state) & (volume != 0)
    flip = np.where(closed, volume < 0, follow)
    doubtful = np.flatnonzero(closed & (flip != follow))
    hollow = doubtful[_inside_another(mesh, state, doubtful, np.flatnonzero(closed))]
    flip[hollow] = follow[hollow]
    mask: BoolArray = (state.turned != flip[state.sheet]) & ~state.one_sided[state.sheet]
    return mask


def _closed(mesh: TriangleMesh, state: Winding) -> BoolArray:
    """Mask of the sheets that have a second face at every edge, (s,)."""
    two = mesh.topology.edge_corners.lengths == 2
    open_faces = ~two[mesh.topology.face_edges].all(axis=1)
    closed = ~state.one_sided
    closed[state.sheet[open_faces]] = False
    return closed


def _volumes(mesh: TriangleMesh, state: Winding) -> FloatArray:
    """Signed volume of each sheet wound like its first face, (s,); 0 where it is next to none."""
    corners = (mesh.vertices - mesh.vertices.mean(axis=0))[mesh.faces]
    size = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0))) or 1.0
    a, b, c = (corners / size).transpose(1, 0, 2)
    parts = np.einsum("tx,tx->t", np.cross(a, b), c) / 6
    signed = np.where(state.turned, -parts, parts)
    volumes = np.bincount(state.sheet, signed, len(state.one_sided))
    return np.where(np.abs(volumes) > _NO_VOLUME, volumes, 0.0)


def _inside_another(
    mesh: TriangleMesh, state: Winding, sheets: Numbers, others: Numbers
) -> BoolArray:
    """Mask of the sheets whose box lies within the box of one of the others."""
    if not len(sheets):
        return np.zeros(0, np.bool_)
    low, high = np.full((2, len(state.one_sided), 3), np.inf)
    high = -high
    corners = mesh.vertices[mesh.faces]
    np.minimum.at(low, state.sheet, corners.min(axis=1))
    np.maximum.at(high, state.sheet, corners.max(axis=1))
    inside = np.zeros(len(sheets), np.bool_)
    for i, sheet in enumerate(sheets):
        around = (low[others] < low[sheet]) & (high[others] > high[sheet])
        inside[i] = around.all(axis=1).any()
    return inside


@at_once
def _look_for_turns(mesh: TriangleMesh) -> Found | None:
    state = winding(mesh)
    corners = mesh.topology.edge_corners
    sheet = state.sheet[corners.items[corners.starts[:-1]] // 3]
    edges = np.flatnonzero(state.same_way & ~state.one_sided[sheet])
    if not len(edges):
        return None
    faces = counted(int(faces_to_turn(mesh, state).sum()), "face")
    run = "runs between two faces" if len(edges) == 1 else "run between faces"
    text = f"{counted(len(edges), 'edge')} {run} wound opposite ways; {faces} to turn round."
    return Found(len(edges), text, ends_of(mesh, edges))


@at_once
def _look_for_inside_out(mesh: TriangleMesh) -> Found | None:
    state = winding(mesh)
    sizes = np.bincount(state.sheet)
    turns = np.bincount(state.sheet, faces_to_turn(mesh, state), len(sizes))
    mixed = np.bincount(state.sheet, state.turned, len(sizes)) > 0
    sheets = np.flatnonzero((turns == sizes) & ~mixed)
    if not len(sheets):
        return None
    faces = np.flatnonzero(np.isin(state.sheet, sheets))
    is_are = "surface is" if len(sheets) == 1 else "surfaces are"
    text = f"{len(sheets):,} closed {is_are} inside out, {counted(len(faces), 'face')} together."
    return Found(len(sheets), text, corners_of(mesh, faces))


@at_once
def _look_for_one_sided(mesh: TriangleMesh) -> Found | None:
    state = winding(mesh)
    sheets = np.flatnonzero(state.one_sided)
    if not len(sheets):
        return None
    faces = np.flatnonzero(state.one_sided[state.sheet])
    one = "One piece has" if len(sheets) == 1 else f"{len(sheets):,} pieces have"
    text = f"{one} only one side, like a Möbius strip."
    return Found(len(sheets), text, corners_of(mesh, faces))


@at_once
def orient(mesh: TriangleMesh, params: NoParams) -> Repaired:
    """Turn faces round so that neighbours agree and closed surfaces have their outside out.

    An open surface follows the majority of its faces. A closed one within the box of another
    may be the wall of a hollow: it follows its majority too. A one-sided piece stays as it is.
    """
    mask = faces_to_turn(mesh, winding(mesh))
    count = int(mask.sum())
    if not count:
        return unchanged(mesh)
    faces = mesh.faces.copy()
    faces[mask] = faces[mask][:, ::-1]
    sources = np.arange(len(mesh.vertices))
    change = f"Turned {counted(count, 'face')} round."
    return Repaired(TriangleMesh(mesh.vertices, faces), sources, (change,))


WINDING = FindingSpec(
    id="winding",
    title="Inconsistent winding",
    meaning="Normals jump to the other side there: the filters of face normals and the bilateral "
    "one take that for a fold. The other methods do not use normals.",
    look=_look_for_turns,
)

INSIDE_OUT = FindingSpec(
    id="inside_out",
    title="Inside out",
    meaning="Normals point inwards. No method's result depends on it; volumes are negative and "
    "printers and renderers may show the wrong side.",
    look=_look_for_inside_out,
)

ONE_SIDED = FindingSpec(
    id="one_sided",
    title="One-sided surface",
    meaning="It cannot be wound consistently and has no genus. Normals jump somewhere, whatever "
    "one does, so there is nothing to repair.",
    look=_look_for_one_sided,
    level="note",
)

REPAIR = RepairSpec(
    id="orient",
    title="Orient faces",
    summary="Turns faces round so that neighbours agree and closed surfaces face outwards.",
    apply=orient,
    removes=(WINDING, INSIDE_OUT),
)
