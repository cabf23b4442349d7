"""Selecting the k-th smallest of many numbers, in a time that grows with their count alone."""

from core.arrays import FloatArray
from core.kernels import kernel


@kernel
def select(values: FloatArray, place: int) -> float:
    """Return the number that would stand at a place if the values were in ascending order.

    Keeps the part that holds the place, of those before and after a middling value, and so on
    (Hoare's quickselect). That value is drawn by lot, the same way at every call: from fixed
    places, values that rise and fall again would give one near the end each time. The values end
    in another order; with a NaN among them the result means nothing.
    """
    low, high = 0, len(values)
    lot = 0
    while True:
        one, two = _drawn(lot), _drawn(_drawn(lot))
        lot = _drawn(two)
        pivot = _middling(
            values[_place(one, low, high)],
            values[_place(two, low, high)],
            values[_place(lot, low, high)],
        )
        end = _bring_forward(values, low, high, pivot, False)
        if place < end:
            high = end
            continue
        low, end = end, _bring_forward(values, end, high, pivot, True)
        if place < end or end == low:  # a NaN is not even equal to itself
            return pivot
        low = end


@kernel
def _drawn(lot: int) -> int:
    """Return the number after this one, of all those below 2³¹ in an order without pattern."""
    return (1103515245 * lot + 12345) % 2147483648


@kernel
def _place(lot: int, low: int, high: int) -> int:
    return low + (lot * (high - low) >> 31)


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
