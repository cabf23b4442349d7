"""What a metric declares about itself, and the shape of its evaluator."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal, Protocol

from core.arrays import FloatArray
from core.lanes import side_by_side


class Evaluator(Protocol):
    """Compares meshes with one original whose own part is computed once."""

    def values(self, positions: FloatArray) -> FloatArray:
        """Return the errors of meshes with the original's faces, from :func:`side_by_side`.

        One number for one mesh, (4,) for more. They do not depend on what stands beside.
        """
        ...

    def value(self, vertices: FloatArray) -> float:
        """Return the error of a mesh with the original's faces and these positions."""
        return float(self.values(side_by_side([vertices])))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the error of each vertex or face, for colouring."""
        ...


@dataclass(frozen=True)
class MetricSpec:
    """A metric: its name, its unit and the evaluator for an original.

    Attributes
    ----------
    id : str
        Name in code, on the command line and in study files.
    title : str
        Name as a person reads it.
    unit : str
        Unit of `value` and `values`.
    elements_unit : str
        Unit of `elements`.
    elements_on : {"vertex", "face"}
        What `elements` belongs to.
    evaluator : callable
        ``evaluator(original)`` prepares the comparison with an original;
        ``evaluator(original, model_units=True)`` in the file's own units and origin, where
        `model_unit` says that it makes a difference.
    summary : str
        One sentence: what it measures; smaller is better.
    formula : str
        The metric in one line.
    reference : str
        Where it comes from.
    model_unit : str
        Unit in the file's own units; empty where the metric does not depend on them.
    elements_title : str
        Name of what `elements` shows, where it is not the metric's own.
    """

    id: str
    title: str
    unit: str
    elements_unit: str
    elements_on: Literal["vertex", "face"]
    evaluator: Callable[..., Evaluator]
    summary: str
    formula: str
    reference: str
    model_unit: str = ""
    elements_title: str = ""

    @property
    def heat_title(self) -> str:
        """Name of the heat map."""
        return self.elements_title or self.title

    def in_model_units(self) -> "MetricSpec":
        """Return the metric in the file's own units."""
        if not self.model_unit:
            return self
        evaluator = partial(self.evaluator, model_units=True)
        return replace(
            self, unit=self.model_unit, elements_unit=self.model_unit, evaluator=evaluator
        )
