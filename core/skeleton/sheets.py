"""Taking a mesh apart into sheets, surfaces in the strict sense.

A sheet is a set of faces connected across edges with two faces. A vertex at which several fans
of faces meet is split, one copy for each fan, so that every sheet has an Euler characteristic, a
number of boundary loops, and is orientable or not.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy

from core.arrays import BoolArray, IntArray
from core.mesh import TriangleMesh


@dataclass(frozen=True)
class Sheet:
    """A surface of one piece.

    Attributes
    ----------
    component : int
        Connected component of the mesh.
    fans : int
        Number of vertices after splitting.
    euler : int
        Euler characteristic after splitting.
    boundaries : int
        Number of boundary loops.
    is_orientable : bool
        Whether its faces can be wound consistently.
    """

    component: int
    fans: int
    euler: int
    boundaries: int
    is_orientable: bool

    @property
    def genus(self) -> int:
        """Number of handles; for a sheet that cannot be oriented, of crosscaps."""
        missing = 2 - self.euler - self.boundaries
        return missing // 2 if self.is_orientable else missing

    @property
    def bound(self) -> int:
        """Bound of Cole-McLaughlin and others on the loops of a Reeb graph."""
        if self.boundaries:
            return 1 - self.euler
        return self.genus if self.is_orientable else self.genus // 2

    @property
    def reason(self) -> str:
        """Which bound this is, in words."""
        if not self.is_orientable:
            kind = f"not orientable, {self.genus} crosscaps"
            if not self.boundaries:
                return f"{kind}: at most half the crosscaps"
            return f"{kind}, {self.boundaries} boundary loops: at most crosscaps + boundaries − 1"
        if not self.boundaries:
            return f"closed, orientable, genus {self.genus}: at most the genus"
        kind = f"orientable, genus {self.genus}, {self.boundaries} boundary loops"
        return f"{kind}: at most 2·genus + boundaries − 1"


class SplitSurface(NamedTuple):
    """All sheets of a mesh, and the sheet of each face, (n,)."""

    sheets: tuple[Sheet, ...]
    sheet_of_face: IntArray


class _Joints(NamedTuple):
    """The edges with two faces: their faces, and the corners that meet at their two ends."""

    faces: IntArray  # (j, 2)
    corners: IntArray  # (2j, 2), numbered 3·face + corner
    is_consistent: BoolArray  # (j,), whether the two faces are wound alike


def split_surface(mesh: TriangleMesh) -> SplitSurface:
    """Take a mesh apart into sheets.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh.

    Returns
    -------
    SplitSurface
        Edges with more than two faces count as boundaries of the sheets that meet there, but
        are not counted as boundary loops.
    """
    joints = _joints(mesh)
    n = len(mesh.faces)
    sheet_of = _labels(n, joints.faces)
    fan_of = _labels(3 * n, joints.corners)
    count = int(sheet_of.max(initial=-1)) + 1
    # The first corner of each fan tells the sheet it belongs to.
    fans = np.bincount(sheet_of[np.unique(fan_of, return_index=True)[1] // 3], minlength=count)
    starts, corners = mesh.topology.edge_corners
    edges = np.bincount(sheet_of[corners[starts[:-1]] // 3], minlength=count)
    boundaries = _boundary_loops(mesh, fan_of, sheet_of, count)
    orientable = _orientable(sheet_of, joints, count)
    faces = np.bincount(sheet_of, minlength=count)
    components = mesh.topology.vertex_components[
        mesh.faces[np.unique(sheet_of, return_index=True)[1], 0]
    ]
    columns = (components, fans, fans - edges + faces, boundaries, orientable)
    sheets = zip(*(column.tolist() for column in columns), strict=True)
    return SplitSurface(tuple(Sheet(*row) for row in sheets), sheet_of)


def _labels(count: int, pairs: IntArray) -> IntArray:
    ones = np.ones(len(pairs), np.int8)
    matrix = scipy.sparse.coo_array((ones, (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return scipy.sparse.csgraph.connected_components(matrix, directed=False)[1].astype(np.int32)


def _edge_ends(opposite: IntArray) -> IntArray:
    """Corners at the two ends of the edge opposite each corner, in the face's order."""
    face, corner = np.divmod(opposite, 3)
    return np.stack([3 * face + (corner + 1) % 3, 3 * face + (corner + 2) % 3], axis=-1)


def _joints(mesh: TriangleMesh) -> _Joints:
    starts, corners = mesh.topology.edge_corners
    two = np.flatnonzero(mesh.topology.edge_corners.lengths == 2)
    opposite = np.stack([corners[starts[two]], corners[starts[two] + 1]], axis=1)
    here, there = _edge_ends(opposite).transpose(1, 0, 2)
    vertices = mesh.faces.ravel()
    # Two faces that are wound alike run along their edge in opposite directions.
    consistent = vertices[here[:, 0]] != vertices[there[:, 0]]
    matched = np.where(consistent[:, None], there[:, ::-1], there)
    return _Joints(opposite // 3, np.stack([here.ravel(), matched.ravel()], axis=1), consistent)


def _boundary_loops(
    mesh: TriangleMesh, fan_of: IntArray, sheet_of: IntArray, count: int
) -> IntArray:
    starts, corners = mesh.topology.edge_corners
    opposite = corners[starts[:-1][mesh.topology.boundary_edges]]
    if not len(opposite):
        return np.zeros(count, np.int32)
    fans = fan_of[_edge_ends(opposite)]
    loop_of = _labels(int(fan_of.max()) + 1, fans)[fans[:, 0]]
    first = np.unique(loop_of, return_index=True)[1]
    return np.bincount(sheet_of[opposite[first] // 3], minlength=count).astype(np.int32)


def _orientable(sheet_of: IntArray, joints: _Joints, count: int) -> BoolArray:
    """Whether each sheet's double cover, one copy of each face for either side, falls in two."""
    n = len(sheet_of)
    first, second = joints.faces.T
    other = np.where(joints.is_consistent, second, second + n)
    links = np.stack([np.append(first, first + n), np.append(other, (other + n) % (2 * n))], axis=1)
    side = _labels(2 * n, links)
    result = np.ones(count, np.bool_)
    result[sheet_of[side[:n] == side[n:]]] = False
    return result
