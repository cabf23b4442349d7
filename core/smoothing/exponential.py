"""The exponential of numbers that are not positive, quicker than the library's."""

import numpy as np

from core.kernels import fused_kernel

# Below this the exponential is smaller than any normal number.
_LOWEST = -708.0
_DOUBLINGS = 1 / np.log(2)
# Added to a number, this leaves the nearest integer in its last bits.
_ROUNDING = 1.5 * 2.0**52
# ln 2 in two parts; the first has so few digits that its product with an integer is exact.
_LN2 = float(np.float32(np.log(2)))
_LN2_REST = -1.904654299957768e-9


@fused_kernel
def falling_exponential(x: float) -> float:
    """eˣ for x ≤ 0, but for the last two bits; 0 below −708 and for no number.

    eˣ = 2ᵏ eʳ with k the integer nearest to x/ln 2: the first factor by writing k into the
    exponent of a number, the second by its Taylor polynomial, where |r| ≤ ½ ln 2. It has no branch
    and no table, so a loop over it compiles to vector instructions.
    """
    shifted = x * _DOUBLINGS + _ROUNDING
    k = shifted - _ROUNDING
    r = (x - k * _LN2) - k * _LN2_REST
    r2 = r * r
    r4 = r2 * r2
    low = (1 + r) + r2 * (1 / 2 + r * (1 / 6))
    middle = (1 / 24 + r * (1 / 120)) + r2 * (1 / 720 + r * (1 / 5_040))
    high = (1 / 40_320 + r * (1 / 362_880)) + r2 * (1 / 3_628_800 + r * (1 / 39_916_800))
    exponential = low + r4 * (middle + r4 * (high + r4 * (1 / 479_001_600)))
    power = np.int64((np.float64(shifted).view(np.int64) + 1023) << 52).view(np.float64)
    value: float = exponential * power if x >= _LOWEST else 0.0
    return value
