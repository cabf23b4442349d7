"""The thesis' visual error D, eq. (12): displacement plus change of a nonlinear Laplacian."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_parallel_kernel, prange, unsigned
from core.mesh import TriangleMesh
from core.mesh.gradient import CAUCHY_CONSTANT, inverse_roots
from core.metrics.spec import MetricSpec


@fused_parallel_kernel
def _cauchy_weights(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    origin: FloatArray,
    roots: FloatArray,
    c: float,
) -> FloatArray:
    """g(|∇vᵢ|) = 1/(1 + |∇vᵢ|²/c²) with |∇vᵢ|² = Σⱼ ‖(vᵢ − o)/√dᵢ − (vⱼ − o)/√dⱼ‖², (m,).

    `roots` are the 1/√dᵢ, times the scale of the lengths.
    """
    weights = np.empty(len(vertices))
    for i in prange(len(vertices)):
        ax = roots[i] * (vertices[i, 0] - origin[0])
        ay = roots[i] * (vertices[i, 1] - origin[1])
        az = roots[i] * (vertices[i, 2] - origin[2])
        total = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            x = ax - roots[j] * (vertices[j, 0] - origin[0])
            y = ay - roots[j] * (vertices[j, 1] - origin[1])
            z = az - roots[j] * (vertices[j, 2] - origin[2])
            total += x * x + y * y + z * z
        weights[i] = 1 / (1 + total / c**2)
    return weights


@fused_parallel_kernel
def _diffusion_operator(
    vertices: FloatArray, starts: IntArray, items: IntArray, weights: FloatArray
) -> FloatArray:
    """𝒜(vᵢ) = (1/dᵢ) Σⱼ (vᵢ − vⱼ)(g(|∇vᵢ|) + g(|∇vⱼ|)), (m, 3)."""
    result = np.empty_like(vertices)
    for i in prange(len(vertices)):
        x = y = z = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            weight = weights[i] + weights[j]
            x += weight * (vertices[i, 0] - vertices[j, 0])
            y += weight * (vertices[i, 1] - vertices[j, 1])
            z += weight * (vertices[i, 2] - vertices[j, 2])
        d = max(starts[i + 1] - starts[i], 1)
        result[i, 0], result[i, 1], result[i, 2] = x / d, y / d, z / d
    return result


@fused_parallel_kernel
def _total_squares(
    original: FloatArray,
    operator: FloatArray,
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    weights: FloatArray,
) -> float:
    """Σᵢ ‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖², in one pass over the rings."""
    total = 0.0
    for i in prange(len(vertices)):
        x = y = z = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            weight = weights[i] + weights[j]
            x += weight * (vertices[i, 0] - vertices[j, 0])
            y += weight * (vertices[i, 1] - vertices[j, 1])
            z += weight * (vertices[i, 2] - vertices[j, 2])
        d = max(starts[i + 1] - starts[i], 1)
        square = (operator[i, 0] - x / d) ** 2
        square += (operator[i, 1] - y / d) ** 2
        square += (operator[i, 2] - z / d) ** 2
        for axis in range(3):
            square += (original[i, axis] - vertices[i, axis]) ** 2
        total += square
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
        self._origin = np.zeros(3) if model_units else original.vertices.mean(axis=0)
        self._scale = 1.0 if model_units else 1.0 / (original.mean_edge_length or 1.0)
        self._roots = self._scale * inverse_roots(original.degrees)
        self._vertices = original.vertices
        self._operator = self._diffusion_operator(self._vertices)

    def _weights(self, vertices: FloatArray) -> FloatArray:
        weights: FloatArray = _cauchy_weights(
            vertices, *self._ring, self._origin, self._roots, CAUCHY_CONSTANT
        )
        return weights

    def _diffusion_operator(self, vertices: FloatArray) -> FloatArray:
        operator: FloatArray = _diffusion_operator(vertices, *self._ring, self._weights(vertices))
        return operator

    def value(self, vertices: FloatArray) -> float:
        """Return D(𝕄, 𝕄̂), the mean of `elements`."""
        squares = _total_squares(
            self._vertices, self._operator, vertices, *self._ring, self._weights(vertices)
        )
        return self._scale**2 * squares / (2 * max(len(vertices), 1))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return (‖vᵢ − v̂ᵢ‖² + ‖𝒜(vᵢ) − 𝒜(v̂ᵢ)‖²)/2 of each vertex, (m,)."""
        displacement = self._vertices - vertices
        change = self._operator - self._diffusion_operator(vertices)
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
