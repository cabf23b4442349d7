"""Root mean square distance between corresponding vertices."""

import numpy as np

from core.arrays import FloatArray
from core.kernels import parallel_kernel, prange
from core.mesh import TriangleMesh
from core.metrics.spec import MetricSpec


@parallel_kernel
def _square_distances(first: FloatArray, second: FloatArray) -> float:
    """Σᵢ ‖vᵢ − v̂ᵢ‖²."""
    total = 0.0
    for i in prange(len(first)):
        for x in range(3):
            total += (first[i, x] - second[i, x]) ** 2
    return total


class VertexRmsEvaluator:
    """√((1/m) Σᵢ ‖vᵢ − v̂ᵢ‖²) against one original, in units of its mean edge length ℓ̄.

    Parameters
    ----------
    original : TriangleMesh
        The mesh without noise.
    model_units : bool
        Report the file's own units instead of ℓ̄.
    """

    def __init__(self, original: TriangleMesh, *, model_units: bool = False) -> None:
        self._vertices = original.vertices
        self._unit = 1.0 if model_units else original.mean_edge_length or 1.0

    def value(self, vertices: FloatArray) -> float:
        """Return the root mean square of `elements`."""
        mean = _square_distances(vertices, self._vertices) / max(len(vertices), 1)
        return float(np.sqrt(mean) / self._unit)

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the distance ‖vᵢ − v̂ᵢ‖ of each vertex in ℓ̄, (m,)."""
        distances: FloatArray = np.linalg.norm(vertices - self._vertices, axis=1) / self._unit
        return distances


SPEC = MetricSpec(
    id="vertex_rms",
    title="Vertex RMS error",
    unit="ℓ̄",
    elements_unit="ℓ̄",
    elements_on="vertex",
    evaluator=VertexRmsEvaluator,
    summary="Root mean square distance of the vertices from where they were in the original.",
    formula="√( 1/m Σᵢ ‖vᵢ − v̂ᵢ‖² ) / ℓ̄",
    reference="Zhang et al., Pacific Graphics 2015, and others",
    model_unit="unit",
    elements_title="Distance to the original",
)
