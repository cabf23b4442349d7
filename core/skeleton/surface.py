"""What the topology of a surface says about the loops that its graph can have."""

from dataclasses import dataclass

import numpy as np

from core.arrays import BoolArray
from core.mesh import TriangleMesh
from core.skeleton.sheets import Sheet, SplitSurface, split_surface


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
    split = split_surface(mesh)
    on_surface = labels[mesh.topology.vertex_faces.lengths > 0]
    vertex_counts = np.bincount(on_surface, minlength=mesh.topology.component_count)
    branching = set(labels[mesh.edges[mesh.topology.nonmanifold_edges, 0]].tolist())
    sheets: dict[int, list[Sheet]] = {}
    for sheet in split.sheets:
        sheets.setdefault(sheet.component, []).append(sheet)
    return tuple(
        _by_betti_number(mesh, component, split)
        if component in branching
        else _by_sheets(component, sheets[component], int(vertex_counts[component]))
        for component in sorted(sheets)
    )


def _by_sheets(component: int, sheets: list[Sheet], vertex_count: int) -> ComponentSurface:
    bound = sum(sheet.bound for sheet in sheets)
    pinches = sum(sheet.fans for sheet in sheets) - vertex_count
    if pinches == 0:
        (sheet,) = sheets
        closed = sheet.is_orientable and not sheet.boundaries
        return ComponentSurface(component, sheet.genus if closed else None, bound, sheet.reason)
    cycles = pinches - len(sheets) + 1
    reason = f"pinched: at most {bound} of its sheets + {cycles} from sheet to sheet"
    return ComponentSurface(component, None, bound + cycles, reason)


def _by_betti_number(mesh: TriangleMesh, component: int, split: SplitSurface) -> ComponentSurface:
    labels = mesh.topology.vertex_components
    is_here = np.array([sheet.component == component for sheet in split.sheets])
    euler = (
        np.count_nonzero(labels == component)
        - np.count_nonzero(labels[mesh.edges[:, 0]] == component)
        + np.count_nonzero(is_here[split.sheet_of_face])
    )
    bound = int(1 - euler + _second_betti_number(mesh, split, is_here))
    reason = f"edges with more than two faces: at most the first Betti number, {bound}"
    return ComponentSurface(component, None, bound, reason)


def _second_betti_number(mesh: TriangleMesh, split: SplitSurface, is_here: BoolArray) -> int:
    """Independent closed surfaces, over the field of two elements, in one component.

    Such a surface is a set of sheets without boundary that meets every edge an even number of
    times. Each row of the equations is a set of sheets, written as the bits of a number.
    """
    closed = {
        number
        for number, sheet in enumerate(split.sheets)
        if is_here[number] and not sheet.boundaries
    }
    rank, pivots = 0, dict[int, int]()
    starts, corners = mesh.topology.edge_corners
    for edge in np.flatnonzero(mesh.topology.nonmanifold_edges):
        row = 0
        for sheet in split.sheet_of_face[corners[starts[edge] : starts[edge + 1]] // 3].tolist():
            row ^= (sheet in closed) << sheet
        while row and row.bit_length() in pivots:
            row ^= pivots[row.bit_length()]
        if row:
            pivots[row.bit_length()] = row
            rank += 1
    return len(closed) - rank
