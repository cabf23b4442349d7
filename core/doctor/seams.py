"""Vertices at one place: seams along which a surface can be joined, and places where it touches.

Two vertices are joined only along a common edge: where exactly two boundary edges lie on one
another, their ends become one. Pieces of surface that touch in a single point stay apart, because
joining them would pinch the surface there.
"""

import numpy as np

from core.arrays import first_rows
from core.doctor.degenerate import joined, without_collapsed
from core.doctor.duplicates import places
from core.doctor.remembering import remembered
from core.doctor.spec import (
    FindingSpec,
    Found,
    NoParams,
    Numbers,
    Repaired,
    RepairSpec,
    rebuilt,
    unchanged,
    vertices_text,
)
from core.mesh import TriangleMesh
from core.stepwise import at_once


@remembered
def seam_partners(mesh: TriangleMesh) -> Numbers:
    """For each vertex the one that it would be joined to along seams, itself if none, (m,)."""
    where = places(mesh)
    edges = mesh.edges.astype(np.int64)
    # Each edge from the smaller place to the larger, so that equal columns are joined.
    edges = np.where((where[edges[:, 0]] > where[edges[:, 1]])[:, None], edges[:, ::-1], edges)
    ends = where[edges]
    pairs = _boundary_pairs(mesh, ends)
    corners = mesh.topology.edge_corners
    opposite = where[mesh.faces.ravel()[corners.items[corners.starts[pairs]]]]
    # Two sheets that lie on one another are not two sides of a seam.
    links = edges[pairs[opposite[:, 0] != opposite[:, 1]]]  # (pairs, 2 edges, 2 ends)
    return joined(len(mesh.vertices), links.transpose(0, 2, 1).reshape(-1, 2))


def _boundary_pairs(mesh: TriangleMesh, ends: Numbers) -> Numbers:
    """Edges, (p, 2), that are the only two between their places and have one face each."""
    proper = np.flatnonzero(ends[:, 0] != ends[:, 1])
    key = ends[proper, 0] * len(mesh.vertices) + ends[proper, 1]
    order = proper[np.argsort(key, kind="stable")]
    _, first, size = np.unique(np.sort(key), return_index=True, return_counts=True)
    first = first[size == 2]
    pairs = np.stack([order[first], order[first + 1]], axis=1)
    lone: Numbers = pairs[mesh.topology.boundary_edges[pairs].all(axis=1)]
    return lone


@at_once
def _look_for_seams(mesh: TriangleMesh) -> Found | None:
    partners = seam_partners(mesh)
    moved = np.flatnonzero(partners != np.arange(len(partners)))
    if not len(moved):
        return None
    repeat = "repeats" if len(moved) == 1 else "repeat"
    text = f"{vertices_text(len(moved))} {repeat} another one along a seam."
    return Found(len(moved), text, np.union1d(moved, partners[moved]))


@at_once
def _look_for_touches(mesh: TriangleMesh) -> Found | None:
    where, partners = places(mesh), seam_partners(mesh)
    pairs = np.stack([where, partners], axis=1)
    alone = where[first_rows(pairs)]
    touching = np.bincount(alone)[where] > 1
    if not touching.any():
        return None
    count = int(touching.sum())
    text = f"{vertices_text(count)} at the same places, but not along a common edge."
    return Found(count, text, np.flatnonzero(touching))


@at_once
def merge_duplicate_vertices(mesh: TriangleMesh, params: NoParams) -> Repaired:
    """Join the vertices on both sides of every seam; each keeps the smaller number.

    A seam is where exactly two boundary edges lie on one another. Vertices that only touch stay
    apart. In a separate noisy file the first of the joined vertices gives the position.
    """
    partners = seam_partners(mesh)
    gone = int((partners != np.arange(len(partners))).sum())
    if not gone:
        return unchanged(mesh)
    faces = without_collapsed(partners[mesh.faces])
    return rebuilt(mesh, faces, f"Merged {vertices_text(gone)} into others at the same place.")


DUPLICATE_VERTICES = FindingSpec(
    id="duplicate_vertices",
    title="Duplicate vertices",
    meaning="The surface is torn along a seam there: noise and smoothing move the two sides "
    "apart, and a crack opens.",
    look=_look_for_seams,
)

TOUCHING = FindingSpec(
    id="touching_vertices",
    title="Touching places",
    meaning="Pieces of surface touch there and are smoothed apart from each other. Joining them "
    "would pinch the surface, so there is nothing to repair.",
    look=_look_for_touches,
    level="note",
)

REPAIR = RepairSpec(
    id="duplicate_vertices",
    title="Merge duplicate vertices",
    summary="Joins the two sides of seams whose vertices lie at the same places.",
    apply=merge_duplicate_vertices,
    removes=(DUPLICATE_VERTICES,),
)
