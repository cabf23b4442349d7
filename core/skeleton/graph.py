"""The skeletal graph: a node for each component of a band, an arc where two of them touch."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray

Bands = Literal["exact", "vertices"]
"""Cut the faces at the levels, or collect the vertices of each band as printed in the thesis."""

ROOT_BAND = -1
"""Band and component number of the root, which is no piece of the surface."""


class GraphError(ValueError):
    """Raised when a graph cannot give what is asked; one sentence says why."""


class Pieces(NamedTuple):
    """Which node each part of the surface belongs to.

    Attributes
    ----------
    starts : (n + 1,) int32 ndarray
        Face t has its nodes in ``nodes[starts[t]:starts[t + 1]]``.
    nodes : (p,) int32 ndarray
        Node of each piece of a face, from its lowest band upwards, one for each band; with
        ``bands="vertices"`` the nodes of its corners.
    vertex_nodes : (m,) int32 ndarray
        Node of each vertex; −1 for a vertex without faces.
    levels : (R − 1,) float64 ndarray
        The levels between the bands.
    """

    starts: IntArray
    nodes: IntArray
    vertex_nodes: IntArray
    levels: FloatArray

    @property
    def faces(self) -> IntArray:
        """Face of each piece, (p,)."""
        return np.repeat(np.arange(len(self.starts) - 1, dtype=np.int32), np.diff(self.starts))


@dataclass(frozen=True, eq=False)
class SkeletalGraph:
    """A skeletal graph; all arrays are read-only.

    Attributes
    ----------
    nodes : (k, 3) float64 ndarray
        Node positions in model units: the area-weighted centroid of the component, with
        ``bands="vertices"`` the mean of its vertices. Ordered by band; the root comes last.
    arcs : (a, 2) int32 ndarray
        Node pairs in ascending order, the node of the lower band first; no pair occurs twice.
        The arcs of the root come last, each with the root first.
    band : (k,) int32 ndarray
        Band of each node, counted from 0; −1 for the root.
    area : (k,) float64 ndarray
        Area of each component in squared model units; nan where a file did not say.
    component : (k,) int32 ndarray
        Connected component of the graph without its root; −1 for the root.
    root : int or None
        Number of the root, the centroid of the surface's vertices, joined to all nodes of the
        first band.
    resolution : int
        Number of bands R.
    field : str
        Id of the field.
    bands : {"exact", "vertices"}
        How the bands were formed.
    pieces : Pieces or None
        The surface's pieces by node; None for a graph that was read from a file.
    """

    nodes: FloatArray
    arcs: IntArray
    band: IntArray
    area: FloatArray
    component: IntArray
    root: int | None = None
    resolution: int = 0
    field: str = ""
    bands: Bands = "exact"
    pieces: Pieces | None = None

    def __repr__(self) -> str:
        return (
            f"SkeletalGraph({len(self.nodes)} nodes, {len(self.arcs)} arcs, {self.loops} loops, "
            f"{self.components} components)"
        )

    @cached_property
    def components(self) -> int:
        """Number of connected components, without the root."""
        return int(self.component.max(initial=-1)) + 1

    @cached_property
    def loops(self) -> int:
        """Number of independent loops, arcs − nodes + components, without the root."""
        surface_nodes = int(np.count_nonzero(self.band != ROOT_BAND))
        return len(self.surface_arcs) - surface_nodes + self.components

    @property
    def surface_arcs(self) -> IntArray:
        """Arcs without those of the root, (a', 2)."""
        return self.arcs if self.root is None else self.arcs[~(self.arcs == self.root).any(axis=1)]

    @cached_property
    def degrees(self) -> IntArray:
        """Number of arcs at each node, (k,)."""
        return np.bincount(self.arcs.ravel(), minlength=len(self.nodes)).astype(np.int32)

    @cached_property
    def kinds(self) -> NDArray[np.str_]:
        """Kind of each node, (k,): end (at most one arc), regular (two) or branch (more)."""
        return np.array(["end", "end", "regular", "branch"])[np.minimum(self.degrees, 3)]

    def member_faces(self, node: int) -> IntArray:
        """Faces of which a node's component has a piece, in ascending order.

        With ``bands="vertices"`` these are the faces with a corner in the component.

        Raises
        ------
        GraphError
            If there is no such node, or the graph was read from a file.
        """
        pieces = self.pieces_of(node)
        return np.unique(pieces.faces[pieces.nodes == node])

    def member_vertices(self, node: int) -> IntArray:
        """Vertices in a node's component, in ascending order; a thin strip may have none.

        Raises
        ------
        GraphError
            If there is no such node, or the graph was read from a file.
        """
        pieces = self.pieces_of(node)
        return np.flatnonzero(pieces.vertex_nodes == node).astype(np.int32)

    def pieces_of(self, node: int) -> Pieces:
        """Return all pieces, having checked that the node exists and that they are known."""
        if not 0 <= node < len(self.nodes):
            raise GraphError(f"node {node} does not exist; allowed are 0 to {len(self.nodes) - 1}.")
        if self.pieces is None:
            raise GraphError("A graph read from a file does not know the surface of its nodes.")
        return self.pieces

    def to_networkx(self) -> Any:
        """Return the graph as a ``networkx.Graph``.

        Nodes carry x, y, z, band, area, component and kind; the graph carries field, bands,
        resolution and, where there is one, root.
        """
        import networkx as nx

        graph = nx.Graph(field=self.field, bands=self.bands, resolution=self.resolution)
        if self.root is not None:
            graph.graph["root"] = self.root
        for node, (x, y, z) in enumerate(self.nodes.tolist()):
            graph.add_node(
                node,
                x=x,
                y=y,
                z=z,
                band=int(self.band[node]),
                area=float(self.area[node]),
                component=int(self.component[node]),
                kind=str(self.kinds[node]),
            )
        graph.add_edges_from(self.arcs.tolist())
        return graph


def label_components(node_count: int, arcs: IntArray) -> IntArray:
    """Connected component of each node, (k,) int32, numbered in the order of first nodes."""
    ones = np.ones(len(arcs), np.int8)
    matrix = scipy.sparse.coo_array(
        (ones, (arcs[:, 0], arcs[:, 1])), shape=(node_count, node_count)
    )
    return scipy.sparse.csgraph.connected_components(matrix, directed=False)[1].astype(np.int32)
