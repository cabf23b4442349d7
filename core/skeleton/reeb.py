"""The Reeb graph of the field that is linear on each face, thesis §4.3.1."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray, frozen
from core.fields import ScalarField, vertex_ranks
from core.mesh import TriangleMesh
from core.skeleton.build import check_field
from core.skeleton.graph import label_components
from core.skeleton.simplify import simplified_arcs
from core.skeleton.sweep import reeb_arcs


@dataclass(frozen=True, eq=False)
class ReebGraph:
    """A Reeb graph: its nodes are vertices where components of the level set begin, end or meet.

    Attributes
    ----------
    vertices : (k,) int32 ndarray
        Mesh vertex of each node. Nodes are numbered from the lowest value to the highest.
    nodes : (k, 3) float64 ndarray
        Positions of those vertices, in model units.
    values : (k,) float64 ndarray
        Normalised field at each node.
    arcs : (a, 2) int32 ndarray
        Node pairs, the lower one first; two nodes may be joined by several arcs.
    """

    vertices: IntArray
    nodes: FloatArray
    values: FloatArray
    arcs: IntArray

    def __repr__(self) -> str:
        return (
            f"ReebGraph({len(self.nodes)} nodes, {len(self.arcs)} arcs, {self.loops} loops, "
            f"{self.components} components)"
        )

    @property
    def lengths(self) -> FloatArray:
        """Length of each arc in the field, (a,), as a share of the field's range."""
        lengths: FloatArray = self.values[self.arcs[:, 1]] - self.values[self.arcs[:, 0]]
        return lengths

    @cached_property
    def component(self) -> IntArray:
        """Connected component of each node, (k,)."""
        return label_components(len(self.nodes), self.arcs)

    @property
    def components(self) -> int:
        """Number of connected components: those of the surface."""
        return int(self.component.max(initial=-1)) + 1

    @property
    def loops(self) -> int:
        """Number of independent loops, arcs − nodes + components."""
        return len(self.arcs) - len(self.nodes) + self.components

    @cached_property
    def down_degrees(self) -> IntArray:
        """Number of arcs that end at each node from below, (k,)."""
        return np.bincount(self.arcs[:, 1], minlength=len(self.nodes)).astype(np.int32)

    @cached_property
    def up_degrees(self) -> IntArray:
        """Number of arcs that begin at each node, (k,)."""
        return np.bincount(self.arcs[:, 0], minlength=len(self.nodes)).astype(np.int32)

    @cached_property
    def kinds(self) -> NDArray[np.str_]:
        """Kind of each node, (k,): minimum, maximum, split, merge, or saddle (both at once)."""
        down, up = self.down_degrees, self.up_degrees
        conditions = [down == 0, up == 0, down == 1, up == 1]
        return np.select(conditions, ["minimum", "maximum", "split", "merge"], "saddle")

    def simplified(self, share: float) -> "ReebGraph":
        """Remove branches and loops that are not longer than a share of the field's range.

        A branch is an arc to a minimum or maximum whose other end has a second arc on the same
        side; a loop is a cycle, as long as its highest node is above its lowest. The shortest
        branch goes first. A loop is closed by sliding its two sides together level by level, so
        that whatever else hangs on it keeps its place.

        Parameters
        ----------
        share : float
            Length from 0 to 1; larger removes more. 0 removes what has no length at all, such as
            the traces of a plateau.

        Returns
        -------
        ReebGraph
            Of each component at least one arc remains.

        References
        ----------
        Pascucci, Scorzelli, Bremer, Mascarenhas, "Robust on-line computation of Reeb graphs",
        2007, §5.
        """
        arcs = simplified_arcs(self.values, self.arcs, share)
        kept = np.unique(arcs)
        number = np.zeros(len(self.nodes), np.int32)
        number[kept] = np.arange(len(kept), dtype=np.int32)
        return _frozen_graph(self.vertices[kept], self.nodes[kept], self.values[kept], number[arcs])

    def to_networkx(self) -> Any:
        """Return the graph as a ``networkx.MultiGraph``.

        Nodes carry vertex, x, y, z, value and kind; arcs carry length.
        """
        import networkx as nx

        graph = nx.MultiGraph()
        for node, (x, y, z) in enumerate(self.nodes.tolist()):
            graph.add_node(
                node,
                vertex=int(self.vertices[node]),
                x=x,
                y=y,
                z=z,
                value=float(self.values[node]),
                kind=str(self.kinds[node]),
            )
        for (low, high), length in zip(self.arcs.tolist(), self.lengths.tolist(), strict=True):
            graph.add_edge(low, high, length=length)
        return graph


def reeb_graph(mesh: TriangleMesh, field: ScalarField) -> ReebGraph:
    """Find the Reeb graph of a field that is linear on each face.

    Each point of the Reeb graph stands for one connected component of a level set.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh with faces.
    field : ScalarField
        A field on it. Equal values are ordered by vertex number, so a plateau may leave arcs of
        no length; ``simplified(0)`` removes them.

    Returns
    -------
    ReebGraph
        Its components are those of the surface. A closed, orientable, connected surface of genus
        g has exactly g loops, whatever the field.

    Raises
    ------
    MeshError
        If the mesh has no faces or the field belongs to another mesh.

    Notes
    -----
    A sweep over the sorted vertices, O(n log n) for the order, plus for each vertex whose link is
    split the size of the smaller part that it separates.

    References
    ----------
    Cole-McLaughlin, Edelsbrunner, Harer, Natarajan, Pascucci, "Loops in Reeb graphs of
    2-manifolds", Discrete & Computational Geometry 32, 2004.
    """
    check_field(mesh, field)
    ranks = vertex_ranks(field.values)
    ends = reeb_arcs(mesh, ranks)
    vertices = np.unique(ends)
    vertices = vertices[np.argsort(ranks[vertices])]
    number = np.zeros(len(mesh.vertices), np.int32)
    number[vertices] = np.arange(len(vertices), dtype=np.int32)
    return _frozen_graph(vertices, mesh.vertices[vertices], field.values[vertices], number[ends])


def _frozen_graph(
    vertices: IntArray, nodes: FloatArray, values: FloatArray, arcs: IntArray
) -> ReebGraph:
    for array in (vertices, nodes, values, arcs):
        frozen(array)
    return ReebGraph(vertices, nodes, values, arcs)
