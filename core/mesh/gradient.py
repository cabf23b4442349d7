"""Vertex gradient magnitudes and the Cauchy weight, thesis eq. (8), (10) and (11)."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_parallel_kernel, prange
from core.lanes import xyz

CAUCHY_CONSTANT = 2.3849
"""Tuning constant c with 95 % asymptotic efficiency on the Gaussian (thesis §2.4)."""


@fused_parallel_kernel
def set_cauchy_weights(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    scale: float,
    c: float,
    weights: FloatArray,
) -> None:
    """Note the weight g(|∇vᵢ|) = 1/(1 + |∇vᵢ|²/c²) of each vertex, (m,), with lengths × `scale`.

    |∇vᵢ|² = Σⱼ ‖vⱼ − vᵢ‖²/dᵢ, which does not depend on the origin.
    """
    factor = (scale / c) ** 2
    for i in prange(len(vertices)):
        x, y, z = xyz(vertices, i)
        total = 0.0
        for k in range(starts[i], starts[i + 1]):
            a, b, c = xyz(vertices, items[k])
            dx, dy, dz = a - x, b - y, c - z
            total += dx * dx + dy * dy + dz * dz
        weights[i] = 1 / (1 + factor * total / max(starts[i + 1] - starts[i], 1))


@fused_parallel_kernel
def printed_cauchy_weights(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    roots: FloatArray,
    scale: float,
    c: float,
) -> FloatArray:
    """Weight g(|∇vᵢ|) as :func:`set_cauchy_weights`, with the gradient as printed in eq. (10).

    |∇vᵢ|² = Σⱼ ‖vᵢ/√dᵢ − vⱼ/√dⱼ‖², which depends on the origin where degrees differ; `roots` are
    the 1/√dᵢ. Both agree where all degrees are equal.
    """
    weights = np.empty(len(vertices))
    factor = (scale / c) ** 2
    for i in prange(len(vertices)):
        (x, y, z), root = xyz(vertices, i), roots[i]
        total = 0.0
        for k in range(starts[i], starts[i + 1]):
            (a, b, c), other = xyz(vertices, items[k]), roots[items[k]]
            dx, dy, dz = other * a - root * x, other * b - root * y, other * c - root * z
            total += dx * dx + dy * dy + dz * dz
        weights[i] = 1 / (1 + factor * total)
    return weights


def inverse_roots(degrees: IntArray) -> FloatArray:
    """Factor 1/√dᵢ of each vertex, (m,); 1 for a vertex without neighbours."""
    roots: FloatArray = 1 / np.sqrt(np.maximum(degrees, 1))
    return roots
