"""What a field declares about itself."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from core.arrays import FloatArray
from core.mesh import TriangleMesh
from core.parameters import Params


def _nothing(_mesh: TriangleMesh) -> tuple[str, ...]:
    return ()


@dataclass(frozen=True)
class FieldSpec:
    """One field: its name, parameters and formula.

    Attributes
    ----------
    id : str
        Name in the registry, on the command line and in a study file.
    title : str
        Name as a person reads it.
    params : type of Params
        Declared parameters.
    evaluate : callable
        ``evaluate(mesh, params)`` gives the raw values, (m,) float64.
    summary : str
        One sentence: what the field measures.
    formula : str
        The field in one line.
    reference : str
        Where it comes from.
    is_squared : bool
        Whether the values are squared distances, so that their root is a distance.
    notes : callable
        ``notes(mesh)`` gives sentences about what was done differently on this mesh.
    departure : str
        One sentence on where it leaves the printed thesis; empty where it does not.
    """

    id: str
    title: str
    params: type[Params]
    evaluate: Callable[[TriangleMesh, Any], FloatArray]
    summary: str
    formula: str
    reference: str
    is_squared: bool = True
    notes: Callable[[TriangleMesh], tuple[str, ...]] = _nothing
    departure: str = ""
