"""Vertices that belong to no face."""

import numpy as np

from core.doctor.spec import (
    FindingSpec,
    Found,
    NoParams,
    Repaired,
    RepairSpec,
    kept,
    unchanged,
    vertices_text,
)
from core.mesh import TriangleMesh
from core.stepwise import at_once


@at_once
def _look(mesh: TriangleMesh) -> Found | None:
    isolated = np.flatnonzero(mesh.degrees == 0)
    if not len(isolated):
        return None
    belong = "belongs" if len(isolated) == 1 else "belong"
    return Found(len(isolated), f"{vertices_text(len(isolated))} {belong} to no face.", isolated)


@at_once
def remove_unreferenced_vertices(mesh: TriangleMesh, params: NoParams) -> Repaired:
    """Remove the vertices that belong to no face; the others keep their order."""
    used = np.flatnonzero(mesh.degrees > 0)
    removed = len(mesh.vertices) - len(used)
    if not removed:
        return unchanged(mesh)
    return kept(mesh, used, mesh.faces, f"Removed {vertices_text(removed)} without faces.")


UNREFERENCED = FindingSpec(
    id="unreferenced_vertices",
    title="Unreferenced vertices",
    meaning="They have no neighbours and stay where they are, in every method; but noise moves "
    "them, and the errors count them.",
    look=_look,
)

REPAIR = RepairSpec(
    id="unreferenced_vertices",
    title="Remove unreferenced vertices",
    summary="Removes vertices that belong to no face.",
    apply=remove_unreferenced_vertices,
    removes=(UNREFERENCED,),
)
