"""Root mean square distance between corresponding vertices."""

import numpy as np

from core.arrays import FloatArray
from core.kernels import kernel, parallel_kernel, prange
from core.lanes import Lanes, set_row, totals, xyz
from core.mesh import TriangleMesh
from core.metrics.spec import Evaluator, MetricSpec

# So many vertices are one piece of work for a thread.
_BLOCK = 1024


@kernel
def _block_squares(positions: FloatArray, original: FloatArray, first: int, last: int) -> Lanes:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² of the vertices from `first` to before `last`."""
    squares = 0.0
    for i in range(np.uint64(first), np.uint64(last)):
        (x, y, z), (a, b, c) = xyz(positions, i), xyz(original, i)
        x, y, z = x - a, y - b, z - c
        squares = squares + (x * x + y * y + z * z)
    return squares


@parallel_kernel
def _squares(positions: FloatArray, original: FloatArray) -> FloatArray:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² over each block of vertices."""
    m = len(positions)
    blocks = (m + _BLOCK - 1) // _BLOCK
    squares = np.empty((blocks, *positions.shape[2:]))
    for block in prange(blocks):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, m)
        set_row(squares, block, _block_squares(positions, original, first, last))
    return squares


class VertexRmsEvaluator(Evaluator):
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

    def values(self, positions: FloatArray) -> FloatArray:
        """Return the root mean square of `elements` of each mesh."""
        squares = totals(_squares(positions, self._vertices))
        return np.sqrt(squares / max(len(positions), 1)) / self._unit

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
