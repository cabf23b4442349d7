"""Selecting the k-th smallest of many numbers, in a time that grows with their count alone."""

from core.arrays import FloatArray
from core.kernels import kernel


@kernel
def select(values: FloatArray, place: int) -> float:
    """Return the number that would stand at a place if the values were in ascending order.

    Keeps the part that holds the place, of those before and after a middling value, and so on
    (Hoare's quickselect). The values end in another order; with a NaN among them the result means
    nothing.
    """
    low, high = 0, len(values)
    while True:
        pivot = _middling(values[low], values[(low + high) // 2], values[high - 1])
        end = _bring_forward(values, low, high, pivot, False)
        if place < end:
            high = end
            continue
        low, end = end, _bring_forward(values, end, high, pivot, True)
        if place < end or end == low:  # a NaN is not even equal to itself
            return pivot
        low = end


@kernel
def _middling(a: float, b: float, c: float) -> float:
    return max(min(a, b), min(max(a, b), c))


@kernel
def _bring_forward(values: FloatArray, low: int, high: int, pivot: float, equal: bool) -> int:
    """Put those below the pivot first, or those that equal it; returns where they end.

    It swaps without branches: which way each would go cannot be foretold.
    """
    end = low
    for i in range(low, high):
        value = values[i]
        values[i] = values[end]
        values[end] = value
        end += value == pivot if equal else value < pivot
    return end
