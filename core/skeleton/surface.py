"""What the topology of a surface says about the loops that its graph can have.

The components of the mesh are taken apart into *sheets*: faces connected across edges with two
faces. Where a vertex joins several fans of faces it is split, so that a sheet is a surface in
the strict sense, with a genus and a number of boundary loops.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from core.arrays import BoolArray, IntArray
from core.mesh import TriangleMesh


@dataclass(frozen=True)
class ComponentSurface:
    """One connected component of a mesh, as far as its graph is concerned.

    Attributes
    ----------
    component : int
        Number of the component in ``mesh.topology.vertex_components``.
    genus : int or None
        Genus, where the component is a closed orientable surface, else None.
    bound : int
        Largest number of loops that a Reeb graph or an exact skeletal graph of it can have.
    reason : str
        Which bound this is.
    """

    component: int
    genus: int | None
    bound: int
    reason: str


@dataclass(frozen=True)
class _Sheet:
    """A surface of one piece: its Euler characteristic, boundary loops and orientability."""

    component: int
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
        if not self.is_orientable:
            kind = f"not orientable, {self.genus} crosscaps"
            if not self.boundaries:
                return f"{kind}: at most half the crosscaps"
            return f"{kind}, {self.boundaries} boundary loops: at most crosscaps + boundaries − 1"
        if not self.boundaries:
            return f"closed, orientable, genus {self.genus}: at most the genus"
        kind = f"orientable, genus {self.genus}, {self.boundaries} boundary loops"
        return f"{kind}: at most 2·genus + boundaries − 1"


def component_surfaces(mesh: TriangleMesh) -> tuple[ComponentSurface, ...]:
    """Find the genus of each component and the bound on the loops of its graph.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh.

    Returns
    -------
    tuple of ComponentSurface
        One for each component that has faces, in ascending order.

    Notes
    -----
    The bounds on the loops of a Reeb graph, which an exact skeletal graph never exceeds:

    - closed and orientable: the genus g, and the full Reeb graph has exactly g;
    - orientable with b > 0 boundary loops: 2g + b − 1;
    - closed and not orientable, k crosscaps: k/2, rounded down;
    - not orientable with b > 0 boundary loops: k + b − 1;
    - sheets that touch in pinched vertices: the sum of their bounds and the number of
      independent cycles from sheet to sheet through such vertices, since the fundamental group
      is the free product of theirs and a free group;
    - with edges of three or more faces: the first Betti number b₁ = 1 − χ + b₂ over the field of
      two elements, which no quotient with connected fibres can exceed.

    References
    ----------
    Cole-McLaughlin, Edelsbrunner, Harer, Natarajan, Pascucci, "Loops in Reeb graphs of
    2-manifolds", Discrete & Computational Geometry 32, 2004.
    """
    labels = mesh.topology.vertex_components
    faces = labels[mesh.faces[:, 0]] if len(mesh.faces) else np.zeros(0, np.int32)
    sheet_of, sheets = _sheets(mesh)
    branching = set(labels[mesh.edges[mesh.topology.nonmanifold_edges, 0]].tolist())
    by_component: dict[int, list[_Sheet]] = {}
    for sheet in sheets:
        by_component.setdefault(sheet.component, []).append(sheet)
    ...
