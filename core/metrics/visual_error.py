"""The thesis' visual error D, eq. (12): displacement plus change of a nonlinear Laplacian."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import (
    fused_kernel,
    fused_parallel_kernel,
    kernel,
    parallel_kernel,
    prange,
    unsigned,
)
from core.lanes import Lanes, every, numbers, row, set_row, with_fourth, xyz
from core.mesh import TriangleMesh
from core.mesh.gradient import CAUCHY_CONSTANT, inverse_roots
from core.metrics.spec import MetricSpec

Ring = tuple[IntArray, IntArray]
"""Starts and items of the neighbours of each vertex."""

# So many vertices are one piece of work for a thread.
_BLOCK = 1024
_ONE = np.uint64(1)


@fused_kernel
def _set_weighted(
    vertices: FloatArray,
    ring: Ring,
    origin: FloatArray,
    roots: FloatArray,
    first: int,
    last: int,
    weighted: FloatArray,
) -> None:
    """Note vᵢ − o and the weight g(|∇vᵢ|) of the vertices from `first` to before `last`, (m, 4).

    g(|∇vᵢ|) = c²/(c² + |∇vᵢ|²) with |∇vᵢ|² = Σⱼ ‖(vᵢ − o)/√dᵢ − (vⱼ − o)/√dⱼ‖². `roots` are the
    1/√dᵢ, times the scale of the lengths.
    """
    starts, items = ring
    o = xyz(origin, 0)
    for i in range(np.uint64(first), np.uint64(last)):
        here = xyz(vertices, i) - o
        scaled = every(roots[i]) * here
        squares = every(0.0)
        for k in range(starts[i], starts[i + _ONE]):
            j = items[k]
            gradient = scaled - every(roots[j]) * (xyz(vertices, j) - o)
            squares = squares + gradient * gradient
        x, y, z, _ = numbers(squares)
        weight = CAUCHY_CONSTANT**2 / (CAUCHY_CONSTANT**2 + (x + y + z))
        set_row(weighted, i, with_fourth(here, weight))


@fused_kernel
def _diffusion(weighted: FloatArray, ring: Ring, i: int) -> Lanes:
    """𝒜(vᵢ) = (1/dᵢ) (g(|∇vᵢ|) Σⱼ (vᵢ − vⱼ) + Σⱼ g(|∇vⱼ|) (vᵢ − vⱼ)); its fourth has no meaning."""
    starts, items = ring
    here = row(weighted, i)
    plain = around = every(0.0)
    for k in range(starts[i], starts[i + _ONE]):
        there = row(weighted, items[k])
        away = here - there
        plain = plain + away
        around = around + every(numbers(there)[3]) * away
    d = max(starts[i + _ONE] - starts[i], _ONE)
    return every(1 / d) * (every(numbers(here)[3]) * plain + around)


@kernel
def _block_squares(
    weighted: FloatArray,
    ring: Ring,
    original: FloatArray,
    operator: FloatArray,
    first: int,
    last: int,
) -> float:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖² of the vertices from `first` to before `last`.

    Neither this nor its caller is fused: equal operators have to give zero.
    """
    squares = every(0.0)
    for i in range(np.uint64(first), np.uint64(last)):
        displacement = row(original, i) - row(weighted, i)
        change = row(operator, i) - _diffusion(weighted, ring, i)
        squares = squares + (displacement * displacement + change * change)
    x, y, z, _ = numbers(squares)
    return x + y + z


@fused_parallel_kernel
def _weighted_positions(
    vertices: FloatArray, ring: Ring, origin: FloatArray, roots: FloatArray
) -> FloatArray:
    """All positions from the origin on, with their weights, (m, 4)."""
    m = len(vertices)
    weighted = np.empty((m, 4))
    for block in prange((m + _BLOCK - 1) // _BLOCK):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, m)
        _set_weighted(vertices, ring, origin, roots, first, last, weighted)
    return weighted


@fused_kernel
def _diffusion_operator(weighted: FloatArray, ring: Ring) -> FloatArray:
    """𝒜 of all vertices, (m, 4)."""
    operator = np.empty_like(weighted)
    for i in range(np.uint64(len(weighted))):
        set_row(operator, i, _diffusion(weighted, ring, i))
    return operator


@parallel_kernel
def _total_squares(
    weighted: FloatArray, ring: Ring, original: FloatArray, operator: FloatArray
) -> float:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖² over all vertices."""
    m = len(weighted)
    total = 0.0
    for block in prange((m + _BLOCK - 1) // _BLOCK):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, m)
        total += _block_squares(weighted, ring, original, operator, first, last)
    return total


class VisualErrorEvaluator:
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
        self._weighted = self._weighted_positions(original.vertices)
        self._operator = _diffusion_operator(self._weighted, self._ring)

    def _weighted_positions(self, vertices: FloatArray) -> FloatArray:
        weighted: FloatArray = _weighted_positions(
            np.ascontiguousarray(vertices), self._ring, self._origin, self._roots
        )
        return weighted

    def value(self, vertices: FloatArray) -> float:
        """Return D(𝕄, 𝕄̂), the mean of `elements`."""
        weighted = self._weighted_positions(vertices)
        squares = _total_squares(weighted, self._ring, self._weighted, self._operator)
        return self._scale**2 * squares / (2 * max(len(vertices), 1))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return (‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖²)/2 of each vertex, (m,)."""
        weighted = self._weighted_positions(vertices)
        displacement = self._weighted - weighted
        change = self._operator - _diffusion_operator(weighted, self._ring)
        squares: FloatArray = (displacement**2 + change**2)[:, :3].sum(axis=1)
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
