"""The surface cut along the levels, for lighting up a node's piece or colouring the bands."""

from dataclasses import dataclass

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.fields import ScalarField
from core.mesh import TriangleMesh
from core.skeleton.graph import GraphError, Pieces, SkeletalGraph
from core.skeleton.levels import vertex_bands
from core.skeleton.slices import piece_polygons


@dataclass(frozen=True, eq=False)
class CutSurface:
    """Pieces of a surface as triangles that share no points with each other's pieces.

    Attributes
    ----------
    points : (p, 3) float64 ndarray
        Corners of the pieces, in model units.
    triangles : (q, 3) int32 ndarray
        Point numbers of each triangle.
    nodes : (q,) int32 ndarray
        Node of each triangle; ``graph.band[nodes]`` is its band.
    """

    points: FloatArray
    triangles: IntArray
    nodes: IntArray


def cut_surface(
    mesh: TriangleMesh, field: ScalarField, graph: SkeletalGraph, node: int | None = None
) -> CutSurface:
    """Cut the surface along the levels of a graph.

    Parameters
    ----------
    mesh, field
        What the graph was drawn from.
    graph : SkeletalGraph
        A graph with exact bands.
    node : int, optional
        Return only the pieces of this node.

    Returns
    -------
    CutSurface
        Triangles; their areas sum to those of the nodes.

    Raises
    ------
    GraphError
        If the bands are not exact, there is no such node, or the graph was read from a file.
    """
    pieces = graph.pieces_of(0 if node is None else node)
    if graph.bands != "exact":
        raise GraphError(f"bands={graph.bands} do not cut the faces; use exact bands.")
    wanted = np.ones(len(pieces.nodes), np.bool_) if node is None else pieces.nodes == node
    return cut_pieces(mesh, field, pieces, wanted)


def cut_pieces(
    mesh: TriangleMesh, field: ScalarField, pieces: Pieces, wanted: BoolArray
) -> CutSurface:
    """Cut the wanted pieces, a mask (p,), out of the faces; each becomes a fan of triangles."""
    slots = np.flatnonzero(wanted)
    owners = pieces.faces[slots]
    bands = vertex_bands(field.values, pieces.levels)
    lowest = bands[mesh.faces[owners]].min(axis=1)
    piece_bands = (lowest + slots - pieces.starts[owners]).astype(np.int32)
    corners, counts = piece_polygons(
        mesh.vertices, mesh.faces, field.values, bands, pieces.levels, owners, piece_bands
    )
    used = np.arange(5) < counts[:, None]
    first = np.cumsum(counts) - counts
    piece, step = np.nonzero(np.arange(1, 4) < counts[:, None] - 1)
    fan = np.stack([first[piece], first[piece] + step + 1, first[piece] + step + 2], axis=1)
    return CutSurface(corners[used], fan.astype(np.int32), pieces.nodes[slots[piece]])
