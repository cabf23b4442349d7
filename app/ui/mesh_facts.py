"""What the model panel tells about a mesh; may be computed on a worker thread."""

from dataclasses import dataclass

import numpy as np

from core.mesh import Topology, TriangleMesh


@dataclass(frozen=True)
class MeshFacts:
    """Counts of a mesh, and why it has no genus where it has none."""

    vertices: int
    edges: int
    faces: int
    components: int
    genus: int | None
    genus_reason: str
    mean_edge_length: float
    boundary_edges: int


def mesh_facts(mesh: TriangleMesh) -> MeshFacts:
    """Gather the facts of a mesh."""
    topology = mesh.topology.along_surface
    return MeshFacts(
        vertices=len(mesh.vertices),
        edges=len(topology.edges),
        faces=len(mesh.faces),
        components=topology.component_count,
        genus=mesh.genus,
        genus_reason=_why_no_genus(topology) if mesh.genus is None else "",
        mean_edge_length=mesh.mean_edge_length,
        boundary_edges=int(topology.boundary_edges.sum()),
    )


def _why_no_genus(topology: Topology) -> str:
    reasons = (
        (topology.boundary_edges, "edges belong to one face only: the surface has a boundary"),
        (topology.nonmanifold_edges, "edges belong to more than two faces"),
        (topology.pinched_vertices, "vertices join pieces of surface that touch only there"),
        (topology.degrees == 0, "vertices belong to no face"),
    )
    for mask, reason in reasons:
        if count := int(np.count_nonzero(mask)):
            return f"No genus: {count:,} {reason}."
    return "No genus: the faces cannot be wound consistently, the surface has one side."
