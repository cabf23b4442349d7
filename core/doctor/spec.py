"""What the mesh doctor says and does: findings, repairs, and how both are declared."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from core.arrays import BoolArray, IntArray
from core.mesh import TriangleMesh
from core.parameters import Params
from core.stepwise import Stepwise

Numbers = NDArray[np.int64]


class RepairError(ValueError):
    """Raised when a repair cannot be done; one sentence says why."""


class NoParams(Params):
    """Parameters of a repair that has none."""


@dataclass(frozen=True, eq=False)
class Found:
    """What a check found.

    Attributes
    ----------
    count : int
        How many there are.
    text : str
        The finding as a person reads it, with its numbers.
    vertices : (k,) ndarray of int
        Vertices at which it is, in ascending order.
    """

    count: int
    text: str
    vertices: Numbers


@dataclass(frozen=True)
class FindingSpec:
    """One thing that the doctor looks for.

    Attributes
    ----------
    id : str
        Name in code and in JSON.
    title : str
        Name as a person reads it.
    meaning : str
        What it means for the methods, in one or two sentences.
    look : callable
        ``look(mesh)`` returns, step by step, what is found; None where there is nothing.
    level : {"defect", "note"}
        A defect is wrong with the file; a note is worth knowing and may be meant.
    """

    id: str
    title: str
    meaning: str
    look: Callable[[TriangleMesh], Stepwise[Found | None]]
    level: Literal["defect", "note"] = "defect"


@dataclass(frozen=True, eq=False)
class Finding:
    """A finding of one mesh.

    Attributes
    ----------
    spec : FindingSpec
        What was looked for.
    found : Found
        What was found.
    repair : str
        Id of the repair that removes it; empty where there is none.
    """

    spec: FindingSpec
    found: Found
    repair: str

    @property
    def is_defect(self) -> bool:
        """Whether it is wrong with the file."""
        return self.spec.level == "defect"


@dataclass(frozen=True, eq=False)
class Repaired:
    """A mesh after a repair; its vertices are vertices of the mesh before, none is moved.

    Attributes
    ----------
    mesh : TriangleMesh
        The repaired mesh.
    sources : (m,) ndarray of int
        The vertex of the mesh before that each vertex comes from.
    changes : tuple of str
        What was changed, one sentence for each repair.
    """

    mesh: TriangleMesh
    sources: Numbers
    changes: tuple[str, ...] = ()

    def carry(self, mesh: TriangleMesh) -> TriangleMesh:
        """Repair another mesh with the vertices of the mesh before in the same way."""
        return self.mesh.with_vertices(mesh.vertices[self.sources])


@dataclass(frozen=True)
class RepairSpec:
    """A repair: its name, its parameters and what it does.

    Attributes
    ----------
    id : str
        Name in code, on the command line and in study files.
    title : str
        Name as a person reads it, a command.
    summary : str
        One sentence: what it does.
    apply : callable
        ``apply(mesh, params)`` returns, step by step, the repaired mesh; one that has no such
        defect comes back with "Nothing to change." and the same vertices and faces.
    removes : tuple of FindingSpec
        Findings that are gone afterwards.
    eases : tuple of FindingSpec
        Findings beside which it is offered too, though some of them may be left or be meant.
    params : type of Params
        Declaration of the parameters.
    keeps_shape : bool
        Whether the surface looks the same afterwards, so that it may be done with others at once.
    """

    id: str
    title: str
    summary: str
    apply: Callable[[TriangleMesh, Any], Stepwise[Repaired]]
    removes: tuple[FindingSpec, ...]
    eases: tuple[FindingSpec, ...] = ()
    params: type[Params] = field(default=NoParams)
    keeps_shape: bool = True


NOTHING = "Nothing to change."


def unchanged(mesh: TriangleMesh) -> Repaired:
    """Return a mesh to which nothing had to be done."""
    return Repaired(mesh, np.arange(len(mesh.vertices)), (NOTHING,))


def rebuilt(mesh: TriangleMesh, faces: NDArray[np.integer[Any]], change: str) -> Repaired:
    """Give a mesh other faces; vertices that lose their last one go, the others keep their order.

    Raises
    ------
    RepairError
        If no face would be left.
    """
    if not len(faces):
        raise RepairError("This repair would leave no face; the mesh stays as it is.")
    used = mesh.degrees == 0
    used[faces] = True
    return kept(mesh, np.flatnonzero(used), faces, change)


def kept(
    mesh: TriangleMesh, sources: Numbers, faces: NDArray[np.integer[Any]], change: str
) -> Repaired:
    """Leave only the vertices `sources` of a mesh, and faces that name no other."""
    number = np.zeros(len(mesh.vertices), np.int32)
    number[sources] = np.arange(len(sources))
    return Repaired(TriangleMesh(mesh.vertices[sources], number[faces]), sources, (change,))


def corners_of(mesh: TriangleMesh, faces: IntArray | Numbers) -> Numbers:
    """Vertices of some faces, each once, in ascending order."""
    return np.unique(mesh.faces[faces]).astype(np.int64)


def ends_of(mesh: TriangleMesh, edges: BoolArray | Numbers) -> Numbers:
    """Vertices of some edges, given by mask or number, each once, in ascending order."""
    return np.unique(mesh.edges[edges]).astype(np.int64)


def counted(number: int, singular: str, plural: str = "") -> str:
    """Return a number with its noun: ``counted(2, "face")`` is "2 faces"."""
    return f"{number:,} {singular if number == 1 else plural or singular + 's'}"


def vertices_text(number: int) -> str:
    """Return a number of vertices in words."""
    return counted(number, "vertex", "vertices")
