"""The thesis' visual error D, eq. (12): displacement plus change of a nonlinear Laplacian."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import (
    ONE,
    fused_kernel,
    fused_parallel_kernel,
    kernel,
    parallel_kernel,
    prange,
    unsigned,
)
from core.lanes import Lanes, Point, row, set_row, totals, xyz
from core.mesh import TriangleMesh
from core.mesh.gradient import CAUCHY_CONSTANT, inverse_roots
from core.metrics.spec import Evaluator, MetricSpec

Ring = tuple[IntArray, IntArray]
"""Starts and items of the neighbours of each vertex."""

# So many vertices are one piece of work for a thread.
_BLOCK = 1024


@fused_kernel
def _scaled(positions: FloatArray, origin: FloatArray, roots: FloatArray, i: int) -> Point:
    """(vᵢ − o)/√dᵢ in the unit of lengths; `roots` are the 1/√dᵢ times its scale."""
    (x, y, z), (ox, oy, oz), root = xyz(positions, i), xyz(origin, 0), roots[i]
    return root * (x - ox), root * (y - oy), root * (z - oz)


@fused_kernel
def _set_block_weights(
    positions: FloatArray,
    ring: Ring,
    origin: FloatArray,
    roots: FloatArray,
    first: int,
    last: int,
    weights: FloatArray,
) -> None:
    """Note the weight g(|∇vᵢ|) of the vertices from `first` to before `last`.

    g(|∇vᵢ|) = c²/(c² + |∇vᵢ|²) with |∇vᵢ|² = Σⱼ ‖(vᵢ − o)/√dᵢ − (vⱼ − o)/√dⱼ‖².
    """
    starts, items = ring
    for i in range(np.uint64(first), np.uint64(last)):
        x, y, z = _scaled(positions, origin, roots, i)
        squares = 0.0
        for k in range(starts[i], starts[i + ONE]):
            a, b, c = _scaled(positions, origin, roots, items[k])
            dx, dy, dz = x - a, y - b, z - c
            squares = squares + (dx * dx + dy * dy + dz * dz)
        set_row(weights, i, CAUCHY_CONSTANT**2 / (CAUCHY_CONSTANT**2 + squares))


@fused_kernel
def _diffusion(positions: FloatArray, weights: FloatArray, ring: Ring, i: int) -> Point:
    """𝒜(vᵢ) = (1/dᵢ) Σⱼ (vᵢ − vⱼ)(g(|∇vᵢ|) + g(|∇vⱼ|))."""
    starts, items = ring
    (x, y, z), g = xyz(positions, i), row(weights, i)
    ax = ay = az = 0.0
    for k in range(starts[i], starts[i + ONE]):
        (a, b, c), weight = xyz(positions, items[k]), g + row(weights, items[k])
        ax = ax + weight * (x - a)
        ay = ay + weight * (y - b)
        az = az + weight * (z - c)
    share = 1 / max(starts[i + ONE] - starts[i], ONE)
    return share * ax, share * ay, share * az


@kernel
def _block_squares(
    positions: FloatArray,
    weights: FloatArray,
    ring: Ring,
    original: FloatArray,
    operator: FloatArray,
    first: int,
    last: int,
) -> Lanes:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖² of the vertices from `first` to before `last`.

    Neither this nor its caller is fused: equal operators have to give zero.
    """
    squares = 0.0
    for i in range(np.uint64(first), np.uint64(last)):
        (x, y, z), (ox, oy, oz) = xyz(positions, i), xyz(original, i)
        (a, b, c), (oa, ob, oc) = _diffusion(positions, weights, ring, i), xyz(operator, i)
        x, y, z, a, b, c = x - ox, y - oy, z - oz, a - oa, b - ob, c - oc
        squares = squares + ((x * x + y * y + z * z) + (a * a + b * b + c * c))
    return squares


@fused_parallel_kernel
def _set_weights(
    positions: FloatArray, ring: Ring, origin: FloatArray, roots: FloatArray, weights: FloatArray
) -> None:
    """Note g(|∇vᵢ|) of all vertices, (m,) or (m, 8)."""
    m = len(positions)
    for block in prange((m + _BLOCK - 1) // _BLOCK):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, m)
        _set_block_weights(positions, ring, origin, roots, first, last, weights)


@fused_kernel
def _diffusion_operator(vertices: FloatArray, weights: FloatArray, ring: Ring) -> FloatArray:
    """𝒜 of all vertices of one mesh, (m, 3)."""
    operator = np.empty_like(vertices)
    for i in range(np.uint64(len(vertices))):
        operator[i, 0], operator[i, 1], operator[i, 2] = _diffusion(vertices, weights, ring, i)
    return operator


@parallel_kernel
def _squares(
    positions: FloatArray,
    weights: FloatArray,
    ring: Ring,
    original: FloatArray,
    operator: FloatArray,
) -> FloatArray:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖² over each block of vertices."""
    m = len(positions)
    blocks = (m + _BLOCK - 1) // _BLOCK
    squares = np.empty((blocks, *positions.shape[2:]))
    for block in prange(blocks):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, m)
        sum_ = _block_squares(positions, weights, ring, original, operator, first, last)
        set_row(squares, block, sum_)
    return squares


class VisualErrorEvaluator(Evaluator):
    """Visual error against one original, whose operator 𝒜 is computed once.

    Parameters
    ----------
    original : TriangleMesh
        The mesh without noise.
    model_units : bool
        Evaluate in the file's own units and origin instead of the original's frame.
    """

    def __init__(self, original: TriangleMesh, *, model_units: bool = False) -> None:
        self._ring = unsigned(*original.topology.vertex_ring)
        self._origin = np.zeros((1, 3)) if model_units else original.vertices.mean(axis=0)[None]
        self._scale = 1.0 if model_units else 1.0 / (original.mean_edge_length or 1.0)
        self._roots = self._scale * inverse_roots(original.degrees)
        self._vertices = original.vertices
        self._operator = self._diffusion_operator(original.vertices)

    def _weights(self, positions: FloatArray) -> FloatArray:
        # numpy's memory of a large array comes in large pages, a kernel's in small ones.
        weights = np.empty((len(positions), *positions.shape[2:]))
        _set_weights(positions, self._ring, self._origin, self._roots, weights)
        return weights

    def _diffusion_operator(self, vertices: FloatArray) -> FloatArray:
        operator: FloatArray = _diffusion_operator(vertices, self._weights(vertices), self._ring)
        return operator

    def values(self, positions: FloatArray) -> FloatArray:
        """Return D(𝕄, 𝕄̂), the mean of `elements`, of each mesh."""
        weights = self._weights(positions)
        squares = _squares(positions, weights, self._ring, self._vertices, self._operator)
        return self._scale**2 * totals(squares) / (2 * max(len(positions), 1))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return (‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖²)/2 of each vertex, (m,)."""
        vertices = np.ascontiguousarray(vertices)
        displacement = vertices - self._vertices
        change = self._diffusion_operator(vertices) - self._operator
        squares: FloatArray = (displacement**2 + change**2).sum(axis=1)
        return self._scale**2 * squares / 2


def visual_error(original: TriangleMesh, mesh: TriangleMesh, *, model_units: bool = False) -> float:
    """Visual error D between an original and a mesh with the same faces, thesis eq. (12).

    D = (1/2m) Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖² with
    𝒜(vᵢ) = (1/dᵢ) Σⱼ (vᵢ − vⱼ)(g(|∇vᵢ|) + g(|∇vⱼ|)), g(x) = 1/(1 + x²/c²), c = 2.3849 and the
    printed gradient |∇vᵢ|² = Σⱼ ‖vᵢ/√dᵢ − vⱼ/√dⱼ‖².

    Parameters
    ----------
    original, mesh : TriangleMesh
        Meshes with the same number of vertices in the same order.
    model_units : bool
        False: both are moved and scaled into the original's frame, centroid at the origin and
        ℓ̄ = 1, and D is in ℓ̄². True: the file's own origin and units, as printed.

    Returns
    -------
    float
        The error, 0 for equal meshes; smaller is better.

    Raises
    ------
    ValueError
        If the numbers of vertices differ.

    Notes
    -----
    Departure from the thesis: g depends on units and on the origin, so the printed D of the same
    pair changes when both are scaled or moved; the frame of the original removes that.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.5, eq. (12).
    """
    if mesh.vertices.shape != original.vertices.shape:
        raise ValueError(
            f"{len(mesh.vertices)} vertices cannot be compared with the original's "
            f"{len(original.vertices)}."
        )
    return VisualErrorEvaluator(original, model_units=model_units).value(mesh.vertices)


SPEC = MetricSpec(
    id="visual_error",
    title="Visual error",
    unit="ℓ̄²",
    elements_unit="ℓ̄²",
    elements_on="vertex",
    evaluator=VisualErrorEvaluator,
    summary="The thesis' D: displacement of the vertices plus change of a nonlinear Laplacian.",
    formula="D = 1/(2m) Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖²",
    reference="Thesis eq. (12)",
    model_unit="unit²",
)
