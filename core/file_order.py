"""Metrics for meshes in the order of a file, computed in an order that follows the surface."""

from dataclasses import dataclass

from core.arrays import FloatArray
from core.mesh import TriangleMesh
from core.mesh.ordering import Numbering
from core.metrics import Evaluator, MetricSpec


@dataclass(frozen=True, eq=False)
class FileOrderEvaluator:
    """Evaluator that takes positions, and gives elements, in the order of the original's file.

    Attributes
    ----------
    along_surface : Evaluator
        The one that computes, in numbers that follow the surface.
    vertices : Numbering
        Of the vertices.
    elements_on : Numbering
        Of what the metric's elements belong to.
    """

    along_surface: Evaluator
    vertices: Numbering
    elements_on: Numbering

    def value(self, vertices: FloatArray) -> float:
        """Return the error of a mesh with these positions."""
        return self.along_surface.value(self.vertices.inward(vertices))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the error of each vertex or face, for colouring."""
        return self.elements_on.outward(self.along_surface.elements(self.vertices.inward(vertices)))


def file_order_evaluator(spec: MetricSpec, original: TriangleMesh) -> FileOrderEvaluator:
    """Prepare a metric for an original in the order of its file."""
    order = original.topology.ordering
    elements_on = order.faces if spec.elements_on == "face" else order.vertices
    evaluator = spec.evaluator(original.along_surface())
    return FileOrderEvaluator(evaluator, order.vertices, elements_on)
