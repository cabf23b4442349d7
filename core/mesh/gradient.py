"""Vertex gradient magnitudes and the Cauchy weight, thesis eq. (8), (10) and (11)."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange

CAUCHY_CONSTANT = 2.3849
"""Tuning constant c with 95 % asymptotic efficiency on the Gaussian (thesis §2.4)."""


@parallel_kernel
def cauchy_weights(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    scale: float,
    c: float,
    printed: bool,
) -> FloatArray:
    """Weight g(|∇vᵢ|) = 1/(1 + |∇vᵢ|²/c²) of each vertex, (m,), with lengths times `scale`.

    Printed: |∇vᵢ|² = Σⱼ ‖vᵢ/√dᵢ − vⱼ/√dⱼ‖², eq. (10), which depends on the origin. Otherwise
    |∇vᵢ|² = Σⱼ ‖vⱼ − vᵢ‖²/dᵢ, which is the same where all degrees are equal.
    """
    weights = np.zeros(len(vertices))
    factor = (scale / c) ** 2
    for i in prange(len(vertices)):
        d = max(starts[i + 1] - starts[i], 1)
        total = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            ratio = np.sqrt(d / (starts[j + 1] - starts[j])) if printed else 1.0
            x = ratio * vertices[j, 0] - vertices[i, 0]
            y = ratio * vertices[j, 1] - vertices[i, 1]
            z = ratio * vertices[j, 2] - vertices[i, 2]
            total += x * x + y * y + z * z
        weights[i] = 1 / (1 + factor * total / d)
    return weights
