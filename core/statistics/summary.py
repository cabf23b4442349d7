"""A mesh in one table: counts, topology, sizes, and what is awkward about it."""

from dataclasses import dataclass

import numpy as np
import scipy

from core.mesh import TriangleMesh, geometry
from core.mesh.topology import Topology

_DEGENERATE = 1e-12


@dataclass(frozen=True)
class Summary:
    """Counts and measures of a mesh.

    Attributes
    ----------
    vertices, edges, faces, components, boundary_loops : int
        Counts.
    euler_characteristic : int
        χ = m − e + n.
    genus : int or None
        Summed over the components; None where it is not defined.
    area : float
        In squared model units.
    volume : float or None
        In cubed model units, positive; None unless it is closed and consistently wound.
    mean_edge_length, edge_length_deviation, shortest_edge, longest_edge : float
        In model units.
    smallest_angle, largest_angle : float
        Of all corners of faces, in degrees.
    degenerate_faces : int
        Faces with no area beside their longest edge.
    nonmanifold_edges, nonmanifold_vertices : int
        Edges with more than two faces; vertices whose faces form more than one fan.
    average_degree : float
        d̄ = 2e/m, thesis ch. 3 eq. (1).
    """

    vertices: int
    edges: int
    faces: int
    components: int
    boundary_loops: int
    euler_characteristic: int
    genus: int | None
    area: float
    volume: float | None
    mean_edge_length: float
    edge_length_deviation: float
    shortest_edge: float
    longest_edge: float
    smallest_angle: float
    largest_angle: float
    degenerate_faces: int
    nonmanifold_edges: int
    nonmanifold_vertices: int
    average_degree: float


def summarise(mesh: TriangleMesh) -> Summary:
    """Count and measure a mesh."""
    topology = mesh.topology
    lengths = geometry.edge_lengths(mesh)
    angles = np.degrees(geometry.corner_angles(mesh))
    some = bool(len(lengths))
    return Summary(
        vertices=len(mesh.vertices),
        edges=len(mesh.edges),
        faces=len(mesh.faces),
        components=topology.component_count,
        boundary_loops=boundary_loop_count(topology),
        euler_characteristic=mesh.euler_characteristic,
        genus=mesh.genus,
        area=float(geometry.face_areas(mesh).sum()),
        volume=_volume(mesh),
        mean_edge_length=mesh.mean_edge_length,
        edge_length_deviation=float(lengths.std()) if some else 0.0,
        shortest_edge=float(lengths.min()) if some else 0.0,
        longest_edge=float(lengths.max()) if some else 0.0,
        smallest_angle=float(angles.min()) if some else 0.0,
        largest_angle=float(angles.max()) if some else 0.0,
        degenerate_faces=_degenerate_faces(mesh),
        nonmanifold_edges=int(topology.nonmanifold_edges.sum()),
        nonmanifold_vertices=int(topology.pinched_vertices.sum()),
        average_degree=2 * len(mesh.edges) / max(len(mesh.vertices), 1),
    )


def boundary_loop_count(topology: Topology) -> int:
    """Number of connected pieces of the boundary: holes and outer rims alike."""
    ends = topology.edges[topology.boundary_edges]
    corners, numbers = np.unique(ends, return_inverse=True)
    if not len(corners):
        return 0
    pairs = numbers.reshape(-1, 2)
    one, other = pairs.T
    graph = scipy.sparse.csr_array((np.ones(len(pairs)), (one, other)), shape=(len(corners),) * 2)
    return int(scipy.sparse.csgraph.connected_components(graph, directed=False)[0])


def _volume(mesh: TriangleMesh) -> float | None:
    topology = mesh.topology
    if not (topology.is_closed and topology.is_consistently_wound and len(mesh.faces)):
        return None
    return abs(geometry.volume(mesh))


def _degenerate_faces(mesh: TriangleMesh) -> int:
    """Faces whose area is nothing beside the square of their longest edge."""
    if not len(mesh.faces):
        return 0
    longest = geometry.edge_lengths(mesh)[mesh.topology.face_edges].max(axis=1)
    return int((geometry.face_areas(mesh) <= _DEGENERATE * longest**2).sum())
