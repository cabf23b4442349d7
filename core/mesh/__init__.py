"""Triangle meshes: vertices, faces, topology and geometry."""

from core.mesh.errors import MeshError
from core.mesh.topology import Topology
from core.mesh.triangle_mesh import TriangleMesh

__all__ = ["MeshError", "Topology", "TriangleMesh"]
