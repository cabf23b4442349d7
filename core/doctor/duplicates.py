"""Faces that lie exactly on one another."""

import numpy as np

from core.arrays import BoolArray, first_rows
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
    rebuilt,
    unchanged,
)
from core.io.merging import merge_equal
from core.mesh import TriangleMesh
from core.stepwise import at_once


@remembered
def places(mesh: TriangleMesh) -> Numbers:
    """Number of the place of each vertex, (m,): equal where two vertices have one position."""
    return merge_equal(mesh.vertices)[1]


def repeated_faces(mesh: TriangleMesh) -> BoolArray:
    """Mask of the faces whose three corners lie where those of an earlier face lie, (n,)."""
    where = places(mesh)[mesh.faces]
    proper = (where != np.roll(where, 1, axis=1)).all(axis=1)
    corners = np.sort(where, axis=1)
    repeated = np.ones(len(where), np.bool_)
    repeated[first_rows(corners)] = False
    mask: BoolArray = repeated & proper
    return mask


@at_once
def _look(mesh: TriangleMesh) -> Found | None:
    faces = np.flatnonzero(repeated_faces(mesh))
    if not len(faces):
        return None
    lie = "lies" if len(faces) == 1 else "lie"
    text = f"{counted(len(faces), 'face')} {lie} exactly on an earlier one."
    return Found(len(faces), text, corners_of(mesh, faces))


@at_once
def remove_duplicate_faces(mesh: TriangleMesh, params: NoParams) -> Repaired:
    """Keep the first of all faces whose corners lie at the same three places.

    Neither the numbers of the vertices nor the winding make a difference.
    """
    repeated = repeated_faces(mesh)
    if not repeated.any():
        return unchanged(mesh)
    removed = counted(int(repeated.sum()), "face")
    return rebuilt(mesh, mesh.faces[~repeated], f"Removed {removed} that lay on others.")


DUPLICATE_FACES = FindingSpec(
    id="duplicate_faces",
    title="Duplicate faces",
    meaning="They count twice in areas, normals and weights, and cancel out where the two are "
    "wound opposite ways; every result stays finite.",
    look=_look,
)

REPAIR = RepairSpec(
    id="duplicate_faces",
    title="Remove duplicate faces",
    summary="Keeps one of the faces that lie exactly on one another.",
    apply=remove_duplicate_faces,
    removes=(DUPLICATE_FACES,),
)
