"""What a smoothing method declares about itself."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from core.arrays import FloatArray
from core.mesh import TriangleMesh
from core.parameters import Params

Steps = Callable[[TriangleMesh, Any], Iterator[FloatArray | None]]


@dataclass(frozen=True)
class MethodSpec:
    """A smoothing method: its name, its parameters and its steps.

    Attributes
    ----------
    id : str
        Name in code, on the command line and in study files.
    title : str
        Name as a person reads it.
    params : type of Params
        Declaration of the parameters.
    steps : callable
        ``steps(mesh, params)`` yields the vertex positions after iteration 1, 2, 3 …, without
        end; each array is new, so whoever iterates may keep it. In between it may yield None,
        where an iteration takes so long that whoever iterates may want to stop.
    summary : str
        One sentence: what the method does.
    formula : str
        The update rule in one line.
    reference : str
        Where it comes from.
    departure : str
        One sentence on where it leaves the printed thesis; empty where it does not.
    """

    id: str
    title: str
    params: type[Params]
    steps: Steps
    summary: str
    formula: str
    reference: str
    departure: str = ""
