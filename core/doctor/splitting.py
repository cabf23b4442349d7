"""Edges with more than two faces, and vertices at which a surface is pinched.

Both are cut apart in one go: at each vertex, the faces that hang together across edges with
exactly two faces form a fan, and every fan gets a vertex of its own [1]_.

.. [1] A. Guéziec, G. Taubin, F. Lazarus, B. Horn, *Cutting and stitching: converting sets of
   polygons to manifold surfaces*, IEEE TVCG 7(2), 2001.
"""

import numpy as np

from core.arrays import IntArray
from core.doctor.spec import (
    FindingSpec,
    Found,
    NoParams,
    Numbers,
    Repaired,
    RepairSpec,
    counted,
    ends_of,
    unchanged,
    vertices_text,
)
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.stepwise import at_once


def fans(mesh: TriangleMesh) -> Numbers:
    """Number of the fan of each corner, (3n,): its smallest corner 3·face + c."""
    edge_corners = mesh.topology.edge_corners
    labels: Numbers = _fans(mesh.faces, edge_corners.starts, edge_corners.items)
    return labels


@kernel
def _root(parent: Numbers, corner: int) -> int:
    while parent[corner] != corner:
        parent[corner] = parent[parent[corner]]
        corner = parent[corner]
    return corner


@kernel
def _fans(faces: IntArray, starts: IntArray, items: IntArray) -> Numbers:
    """Union-find over corners: those of two faces at one edge belong together at both ends."""
    parent = np.arange(faces.size)
    for e in range(len(starts) - 1):
        if starts[e + 1] - starts[e] != 2:
            continue
        first, second = items[starts[e]], items[starts[e] + 1]
        t, s = first // 3, second // 3
        for step in (1, 2):
            c = (first + step - 3 * t) % 3
            for k in range(3):
                if faces[s, k] == faces[t, c]:
                    a, b = _root(parent, 3 * t + c), _root(parent, 3 * s + k)
                    parent[max(a, b)] = min(a, b)
    for corner in range(len(parent)):
        parent[corner] = _root(parent, corner)
    return parent


def _extra_fans(mesh: TriangleMesh) -> tuple[Numbers, Numbers]:
    """Fans beyond the first of their vertex, and those vertices."""
    labels = np.unique(fans(mesh))
    vertices = mesh.faces.ravel()[labels].astype(np.int64)
    # The smallest corner of a vertex is in its first fan.
    first = np.zeros(len(labels), np.bool_)
    first[np.unique(vertices, return_index=True)[1]] = True
    return labels[~first], vertices[~first]


@at_once
def split_nonmanifold(mesh: TriangleMesh, params: NoParams) -> Repaired:
    """Give every fan of faces a vertex of its own; copies stand after all other vertices."""
    extra, vertices = _extra_fans(mesh)
    if not len(extra):
        return unchanged(mesh)
    m = len(mesh.vertices)
    number = mesh.faces.ravel().astype(np.int64)
    labels = fans(mesh)
    place = np.searchsorted(extra, labels)
    is_extra = extra[np.minimum(place, len(extra) - 1)] == labels
    number[is_extra] = m + place[is_extra]
    sources = np.concatenate([np.arange(m), vertices])
    count = len(np.unique(vertices))
    change = f"Split {vertices_text(count)} into {count + len(extra):,}."
    return Repaired(TriangleMesh(mesh.vertices[sources], number.reshape(-1, 3)), sources, (change,))


@at_once
def _look_at_edges(mesh: TriangleMesh) -> Found | None:
    mask = mesh.topology.nonmanifold_edges
    if not mask.any():
        return None
    count, ends = int(mask.sum()), ends_of(mesh, mask)
    belong = "belongs" if count == 1 else "belong"
    text = f"{counted(count, 'edge')} {belong} to more than two faces, at "
    return Found(count, f"{text}{vertices_text(len(ends))}.", ends)


@at_once
def _look_at_vertices(mesh: TriangleMesh) -> Found | None:
    pinched = np.flatnonzero(mesh.topology.pinched_vertices)
    if not len(pinched):
        return None
    join = "joins" if len(pinched) == 1 else "join"
    text = f"{vertices_text(len(pinched))} {join} pieces of surface that touch only there."
    return Found(len(pinched), text, pinched)


NONMANIFOLD_EDGES = FindingSpec(
    id="nonmanifold_edges",
    title="Non-manifold edges",
    meaning="Several sheets of surface meet there: the methods average over all of them, and the "
    "model has no genus.",
    look=_look_at_edges,
)

PINCHED = FindingSpec(
    id="pinched_vertices",
    title="Pinched vertices",
    meaning="The surface touches itself there: the methods average over both pieces, and the "
    "model has no genus.",
    look=_look_at_vertices,
)

REPAIR = RepairSpec(
    id="split",
    title="Split non-manifold places",
    summary="Cuts sheets apart along edges with more than two faces and at pinched vertices.",
    apply=split_nonmanifold,
    removes=(NONMANIFOLD_EDGES, PINCHED),
)
