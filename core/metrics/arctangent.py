"""The angle of a sine and a cosine, several times as quick as the library's."""

import numpy as np

from core.kernels import kernel

_STEPS = 64
_TABLE = np.arctan(np.arange(_STEPS + 1) / _STEPS)


@kernel
def angle_of(sine: float, cosine: float) -> float:
    """Angle in [0, π] of a multiple of its sine, at least 0, and of its cosine; 0 for 0, 0.

    The angle α in the first octant is turned back by that of the table with the nearest tangent
    τ, and of what is left, tan(α − arctan τ) = (sin α − τ cos α)/(cos α + τ sin α), the Taylor
    polynomial is taken. Unlike the arc cosine it is exact for nearly equal directions.
    """
    steep = sine > abs(cosine)
    low, high = (abs(cosine), sine) if steep else (sine, abs(cosine))
    if high == 0:
        return 0.0
    ratio: float = low / high
    if not ratio <= 1:
        return ratio
    k = np.uint32(_STEPS * ratio + 0.5)
    tau = k * (1 / _STEPS)
    rest = (low - tau * high) / (high + tau * low)
    square = rest * rest
    series = (1 - square * (1 / 3)) + square * square * (1 / 5 - square * (1 / 7))
    angle: float = _TABLE[k] + rest * series
    if steep:
        angle = np.pi / 2 - angle
    return angle if cosine >= 0 else np.pi - angle
