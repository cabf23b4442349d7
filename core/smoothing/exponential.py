"""The exponential of numbers that are not positive, quicker than the library's."""

import numpy as np

from core.kernels import kernel

_STEPS = 64
# Below this the exponential is smaller than any normal number.
_LOWEST = -708.0
_TABLE = np.exp(-np.arange(1 - _STEPS * _LOWEST) / _STEPS)


@kernel
def falling_exponential(x: float) -> float:
    """eˣ for x ≤ 0, but for the last two bits; 0 below −708 and for no number.

    eˣ = e^(−k/64) eʳ with k = ⌊−64x⌋: the first factor from a table, the second by its Taylor
    polynomial, where −1/64 < r ≤ 0. Its terms are taken in pairs, which need not wait for each
    other.
    """
    if not x >= _LOWEST:
        return 0.0
    k = np.uint32(-_STEPS * x)
    r = x + k * (1 / _STEPS)
    low = (1 + r) + r * r * (1 / 2 + r * (1 / 6))
    high = (1 / 24 + r * (1 / 120)) + r * r * (1 / 720)
    value: float = _TABLE[k] * (low + (r * r) * (r * r) * high)
    return value
