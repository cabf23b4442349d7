"""The loops of a graph beside the genus of its surface."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.mesh import TriangleMesh
from core.skeleton.graph import SkeletalGraph
from core.skeleton.surface import ComponentSurface, component_surfaces


@dataclass(frozen=True)
class LoopCheck:
    """The loops of one connected component of a surface, beside what its topology allows.

    Attributes
    ----------
    component : int
        Number of the component in ``mesh.topology.vertex_components``.
    loops : int
        Loops of the graph on this component, without the root.
    genus : int or None
        Genus, or None where it is not defined.
    bound : int
        Largest number of loops that an exact graph can have.
    reason : str
        Which bound this is.
    """

    component: int
    loops: int
    genus: int | None
    bound: int
    reason: str

    @property
    def holds(self) -> bool:
        """Whether the loops stay within the bound; with exact bands they always do."""
        return self.loops <= self.bound


def loop_checks(
    mesh: TriangleMesh,
    graph: SkeletalGraph,
    surfaces: Sequence[ComponentSurface] | None = None,
) -> tuple[LoopCheck, ...]:
    """Compare the loops of a graph with the genus of each component.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh of the graph.
    graph : SkeletalGraph
        A graph that was drawn, not read from a file.
    surfaces : sequence of ComponentSurface, optional
        The mesh's :func:`component_surfaces`, if they are there already: they do not change with
        the resolution.

    Returns
    -------
    tuple of LoopCheck
        One for each component of the mesh that has faces.

    Raises
    ------
    GraphError
        If the graph was read from a file.
    """
    pieces = graph.pieces_of(0)
    labels = mesh.topology.vertex_components
    of_node = np.full(len(graph.nodes), -1, np.int32)
    of_node[pieces.nodes] = labels[mesh.faces[pieces.faces, 0]]
    count = mesh.topology.component_count
    node_counts = np.bincount(of_node[of_node >= 0], minlength=count)
    arc_counts = np.bincount(of_node[graph.surface_arcs[:, 0]], minlength=count)
    # Printed bands may tear a component of the mesh into several of the graph.
    parts = np.unique(np.stack([of_node, graph.component], axis=1)[of_node >= 0], axis=0)
    part_counts = np.bincount(parts[:, 0], minlength=count)
    loops = arc_counts - node_counts + part_counts
    return tuple(
        LoopCheck(
            known.component, int(loops[known.component]), known.genus, known.bound, known.reason
        )
        for known in (component_surfaces(mesh) if surfaces is None else surfaces)
    )
