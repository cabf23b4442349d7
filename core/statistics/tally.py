"""A histogram that values are added to before their range is known."""

import numpy as np

from core.arrays import FloatArray
from core.statistics.distributions import Histogram

_FINE = 4096


class Tally:
    """Counts values ≥ 0 in many fine bins, whose range doubles when a larger value comes.

    Attributes
    ----------
    finite, infinite : int
        Number of values of either kind.
    longest : float
        Largest finite value.
    """

    def __init__(self) -> None:
        self._counts = np.zeros(_FINE, np.int64)
        self._top = 0.0
        self._sum = 0.0
        self.finite = 0
        self.infinite = 0
        self.longest = 0.0

    def add(self, values: FloatArray) -> None:
        """Count values; infinite ones are counted apart."""
        finite = values[np.isfinite(values)]
        self.infinite += len(values) - len(finite)
        self.finite += len(finite)
        if not len(finite):
            return
        self._sum += float(finite.sum())
        self.longest = max(self.longest, float(finite.max()))
        self._make_room()
        if self._top:
            places = (finite * (_FINE / self._top)).astype(np.int64)
            self._counts += np.bincount(np.minimum(places, _FINE - 1), minlength=_FINE)
        else:
            self._counts[0] += len(finite)

    @property
    def mean(self) -> float:
        """Mean of the finite values, 0 where there are none."""
        return self._sum / self.finite if self.finite else 0.0

    def histogram(self, bins: int) -> Histogram:
        """Return about this many bins, from 0 to the longest value."""
        width = self._top / _FINE
        used = int(np.ceil(self.longest / width)) if width else 1
        group = max(-(-used // bins), 1)
        starts = np.arange(0, min(max(used, 1), _FINE), group)
        counts = np.add.reduceat(self._counts, starts)
        edges = np.append(starts, starts[-1] + group) * (width or 1.0)
        return Histogram(edges, counts)

    def _make_room(self) -> None:
        if not self._top:
            self._top = 2 * self.longest
        while self.longest > self._top > 0:
            pairs = self._counts.reshape(-1, 2).sum(axis=1)
            self._counts = np.concatenate([pairs, np.zeros(_FINE // 2, np.int64)])
            self._top *= 2
