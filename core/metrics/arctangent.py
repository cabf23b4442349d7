"""The angle of a sine and a cosine, several times as quick as the library's."""

import numpy as np

from core.kernels import fused_kernel

_QUARTER_TURN, _THIRTY_DEGREES = np.pi / 2, np.pi / 6
_TAN_15, _TAN_30 = 2 - np.sqrt(3), 1 / np.sqrt(3)
# arctan(x)/x = 1 − x²/3 + x⁴/5 − …, highest power first. For x ≤ tan 15° the next one, x²⁶/27,
# is below the last bit.
_SERIES = tuple((-1) ** k / (2 * k + 1) for k in range(12, -1, -1))


@fused_kernel
def angle_of(sine: float, cosine: float) -> float:
    """Angle in [0, π] of a multiple of its sine, at least 0, and of its cosine; 0 for 0, 0.

    It is folded into the first octant and there, from 15° on, turned back by 30°:
    tan(α − 30°) = (sin α − τ cos α)/(cos α + τ sin α) with τ = tan 30°. Of the 15° that are left
    at most, the Taylor polynomial is taken. Unlike the arc cosine it is exact for nearly equal
    directions. It has one division, no table and no branch, so a loop over it compiles to vector
    instructions.
    """
    across = abs(cosine)
    steep = sine > across
    low = across if steep else sine
    high = sine if steep else across
    far = low > _TAN_15 * high
    rise = low - _TAN_30 * high if far else low
    run = high + _TAN_30 * low if far else high
    x = rise / (run if run != 0 else 1.0)
    square = x * x
    ratio = 0.0
    for coefficient in _SERIES:
        ratio = ratio * square + coefficient
    octant = x * ratio + (_THIRTY_DEGREES if far else 0.0)
    quarter = _QUARTER_TURN - octant if steep else octant
    angle: float = np.pi - quarter if cosine < 0 else quarter
    return angle
