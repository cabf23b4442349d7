"""The box that clipping ranges are made for."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from core.arrays import FloatArray

_MARGIN = 0.1
_ROOM = 1.5


class SteadyBox:
    """A box around all meshes, kept as long as it holds them and is not much too large.

    With another clipping range the depths of pixels that are already drawn would mean something
    else, so that all views were to be drawn anew whenever one mesh changes a little.
    """

    def __init__(self) -> None:
        self._low, self._high = np.zeros(3), np.zeros(3)

    def around(self, boxes: Sequence[ArrayLike]) -> FloatArray:
        """Return a box around others; each is x, y, z from their least to their largest."""
        ends = np.asarray(boxes).reshape(-1, 3, 2)
        low, high = ends[..., 0].min(axis=0), ends[..., 1].max(axis=0)
        size = float((high - low).max())
        outside = (low < self._low).any() or (high > self._high).any()
        if outside or (self._high - self._low).max() > _ROOM * size:
            self._low, self._high = low - _MARGIN * size, high + _MARGIN * size
        return np.stack([self._low, self._high], axis=1).ravel()
