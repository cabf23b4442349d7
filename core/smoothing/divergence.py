"""When a run has gone wrong: vertices far outside the model, or edges that grow and grow."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.mesh.geometry import bounding_box

# A vertex may move this many times the half extent of the model from its centre.
_REACH = 10.0
# Averaging shortens edges; where noise is amplified they grow within a few iterations, also when
# the method's own weights keep the vertices from running away to infinity.
_GROWTH = 3.0


class DivergenceError(ArithmeticError):
    """Raised when a method diverges; `iteration` says in which step, counted from 1."""

    def __init__(self, iteration: int) -> None:
        super().__init__(f"diverged at iteration {iteration}")
        self.iteration = iteration


@fused_parallel_kernel
def _total_length(vertices: FloatArray, edges: IntArray) -> float:
    total = 0.0
    for e in prange(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        (x, y, z), (a, b, c) = xyz(vertices, i), xyz(vertices, j)
        dx, dy, dz = a - x, b - y, c - z
        total += np.sqrt(dx * dx + dy * dy + dz * dz)
    return total


@fused_parallel_kernel
def _reach_and_growth(
    vertices: FloatArray,
    before: FloatArray,
    degrees: IntArray,
    centre: FloatArray,
    reach: float,
) -> tuple[int, float]:
    """Number of vertices outside the reach, and Σ dᵢ ‖vᵢ − before‖.

    An edge grows by no more than its two ends move, so the edges together grow by no more than
    that sum.
    """
    outside = 0
    growth = 0.0
    ox, oy, oz = centre[0], centre[1], centre[2]
    for i in prange(len(vertices)):
        (x, y, z), (a, b, c) = xyz(vertices, i), xyz(before, i)
        # No comparison with what is not a number holds.
        inside = (abs(x - ox) <= reach) & (abs(y - oy) <= reach) & (abs(z - oz) <= reach)
        outside += not inside
        dx, dy, dz = x - a, y - b, z - c
        growth += degrees[i] * np.sqrt(dx * dx + dy * dy + dz * dz)
    return outside, growth


class DivergenceGuard:
    """Tells whether positions can still be a smoothed version of a mesh.

    A run has diverged when a vertex is not finite or outside ten times the bounding box of the
    mesh, or when the edges are on average three times as long as at the start. The edges are
    measured only when the vertices have moved so far that this is possible.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh the run starts from.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        low, high = bounding_box(mesh.vertices)
        self._centre = (low + high) / 2
        self._reach = _REACH * float((high - low).max()) / 2
        self._before = mesh.vertices
        self._degrees = mesh.degrees
        (self._edges,) = unsigned(mesh.edges)
        self._length = _total_length(mesh.vertices, self._edges)

    def allows(self, vertices: FloatArray) -> bool:
        """Whether the run is still sound; a coordinate that is not a number is not."""
        outside, growth = _reach_and_growth(
            vertices, self._before, self._degrees, self._centre, self._reach
        )
        if outside:
            return False
        if growth <= (_GROWTH - 1) * self._length:
            return True
        return bool(_total_length(vertices, self._edges) <= _GROWTH * self._length)
