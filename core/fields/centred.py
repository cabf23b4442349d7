"""Vertex positions relative to the centroid, the origin of every distance field."""

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.mesh import TriangleMesh


def surface_vertices(mesh: TriangleMesh) -> BoolArray:
    """Mask of the vertices that belong to a face, (m,); all of them if there is no face.

    Files often carry vertices that no face uses. They are not part of the surface, so they
    must move neither its centroid nor the range of its fields.
    """
    mask = mesh.topology.vertex_faces.lengths > 0
    return mask if mask.any() else np.ones(len(mesh.vertices), np.bool_)


def centred_vertices(mesh: TriangleMesh) -> FloatArray:
    """Positions p relative to the centroid c of the surface's vertices, (m, 3), in model units."""
    if not len(mesh.vertices):
        return np.zeros((0, 3))
    centred: FloatArray = mesh.vertices - mesh.vertices[surface_vertices(mesh)].mean(axis=0)
    return centred
