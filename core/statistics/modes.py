"""Peaks of a histogram that stand out of their surroundings."""

import numpy as np

from core.arrays import FloatArray
from core.statistics.distributions import Histogram

_SMOOTHING = 1.5
_PROMINENCE = 0.02


def modes(histogram: Histogram) -> FloatArray:
    """Values at which the smoothed histogram has a peak, ascending.

    The shares are smoothed by a Gaussian of 1.5 bins. A peak counts if the way from it to any
    higher one goes down by 2 % of the highest.
    """
    shares = _smoothed(histogram.shares)
    limit = _PROMINENCE * shares.max(initial=0)
    places = [i for i in _summits(shares) if _prominence(shares, i) > limit]
    peaks: FloatArray = histogram.centres[places]
    return peaks


def _smoothed(shares: FloatArray) -> FloatArray:
    reach = np.arange(-6, 7)
    weights = np.exp(-0.5 * (reach / _SMOOTHING) ** 2)
    smoothed: FloatArray = np.convolve(shares, weights / weights.sum())[6:-6]
    return smoothed


def _summits(shares: FloatArray) -> list[int]:
    """Bins that are higher than the one before and not lower than the one behind."""
    walled = np.pad(shares, 1)
    rises, falls = walled[1:-1] > walled[:-2], walled[1:-1] >= walled[2:]
    return np.flatnonzero(rises & falls).tolist()


def _prominence(shares: FloatArray, place: int) -> float:
    """How far one must go down from a summit before one can go up to a higher one."""
    left, right = shares[:place][::-1], shares[place + 1 :]
    return float(shares[place] - max(_lowest_way(side, shares[place]) for side in (left, right)))


def _lowest_way(side: FloatArray, height: float) -> float:
    """Lowest share before a higher one comes; 0 if none comes, for the histogram ends there."""
    higher = np.flatnonzero(side > height)
    return float(side[: higher[0]].min(initial=height)) if len(higher) else 0.0
