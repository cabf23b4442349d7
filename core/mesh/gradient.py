"""Vertex gradient magnitudes and the Cauchy weight, thesis eq. (8), (10) and (11)."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange

CAUCHY_CONSTANT = 2.3849
"""Tuning constant c with 95 % asymptotic efficiency on the Gaussian (thesis §2.4)."""


@parallel_kernel
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
        total = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            x = vertices[j, 0] - vertices[i, 0]
            y = vertices[j, 1] - vertices[i, 1]
            z = vertices[j, 2] - vertices[i, 2]
            total += x * x + y * y + z * z
        weights[i] = 1 / (1 + factor * total / max(starts[i + 1] - starts[i], 1))


@parallel_kernel
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
        ax, ay, az = roots[i] * vertices[i, 0], roots[i] * vertices[i, 1], roots[i] * vertices[i, 2]
        total = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            x = roots[j] * vertices[j, 0] - ax
            y = roots[j] * vertices[j, 1] - ay
            z = roots[j] * vertices[j, 2] - az
            total += x * x + y * y + z * z
        weights[i] = 1 / (1 + factor * total)
    return weights


def inverse_roots(degrees: IntArray) -> FloatArray:
    """Factor 1/√dᵢ of each vertex, (m,); 1 for a vertex without neighbours."""
    roots: FloatArray = 1 / np.sqrt(np.maximum(degrees, 1))
    return roots
