"""A mesh in parts of some thousand faces, each of which can be drawn by itself.

A window that draws a part a turn answers in between, however large the mesh is.
"""

from typing import NamedTuple

import numpy as np
import pyvista as pv
from vtkmodules.vtkCommonDataModel import vtkCellArray

from core.arrays import BoolArray, IntArray
from core.mesh.topology import Topology

# Software OpenGL draws so many faces in about 10 ms.
_FACES = 1 << 14
_MOST = 64


class Part(NamedTuple):
    """Some faces of a mesh.

    Attributes
    ----------
    vertices, faces : (k,), (f,) ndarray
        What the mesh calls its vertices and its faces.
    cells : vtkCellArray
        The faces, in numbers of these vertices.
    """

    vertices: IntArray
    faces: IntArray
    cells: vtkCellArray


def parts_of(topology: Topology) -> tuple[Part, ...]:
    """Cut a mesh along its surface, so that few vertices belong to several parts."""
    count = len(topology.faces)
    order = topology.ordering.faces.inward(np.arange(count, dtype=np.int32))
    size = max(_FACES, -(-count // _MOST))
    ranks = np.zeros(topology.vertex_count, np.int32)
    is_met = np.zeros(topology.vertex_count, np.bool_)
    return tuple(
        _part(topology.faces, order[k : k + size], ranks, is_met) for k in range(0, count, size)
    )


def _part(faces: IntArray, chosen: IntArray, ranks: IntArray, is_met: BoolArray) -> Part:
    """Make a part of chosen faces; two arrays are scratch, of which the second stays false."""
    corners = faces[chosen]
    is_met[corners] = True
    vertices = np.flatnonzero(is_met).astype(np.int32)
    is_met[vertices] = False
    ranks[vertices] = np.arange(len(vertices), dtype=np.int32)
    return Part(vertices, chosen, pv.CellArray.from_regular_cells(ranks[corners]))
