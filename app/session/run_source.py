"""The worker's end of a run: its iterations as they are kept, and going on where it stopped."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.comparison import Comparison
from core.smoothing import DivergenceError
from core.study import MethodChoice


class Kept(NamedTuple):
    """What is kept of an iteration: its number, its errors, its time, its positions.

    Those are float32, in the order of the file and relative to the centroid of the original.
    """

    iteration: int
    errors: dict[str, float]
    seconds: float
    position: NDArray[np.float32]


def kept_iterations(
    comparison: Comparison, choice: MethodChoice, wanted: Callable[[], int]
) -> Iterator[Kept | None]:
    """Yield what is kept of iteration 1, 2, 3 …; None while there is none yet.

    Positions are brought into the order of the file here, beside the window, which gets many of
    them at once.

    Raises
    ------
    DivergenceError
        When the run diverges.
    """
    centre = centre_of(comparison)
    for snapshot in comparison.snapshots(choice, wanted):
        if snapshot is None:
            yield None
            continue
        position = (snapshot.along_surface - centre).astype(np.float32)
        errors, seconds = snapshot.errors, snapshot.seconds
        yield Kept(snapshot.iteration, errors, seconds, snapshot.numbering.outward(position))


def centre_of(comparison: Comparison) -> FloatArray:
    """Centroid of the original, (3,)."""
    centre: FloatArray = comparison.original.vertices.mean(axis=0)
    return centre


class Source:
    """The worker's end of a run: advances it, and goes on later where it stopped.

    `ended` says that no more will come, because the run diverged or failed.

    Parameters
    ----------
    begin : callable
        Gets a function that returns the iteration to be reached, and returns what
        :func:`kept_iterations` does.
    """

    def __init__(self, begin: Callable[[Callable[[], int]], Iterator[Kept | None]]) -> None:
        self._target: Callable[[], int] = lambda: 0
        self._iterations = begin(self._wanted)
        self._reached = 0
        self.ended = False

    def _wanted(self) -> int:
        return self._target()

    def advance(self, target: Callable[[], int]) -> Iterator[Kept | DivergenceError | None]:
        """Yield what is kept up to the iteration that `target` asks for, which may change.

        None while there is none yet.
        """
        self._target = target
        while not self.ended and self._reached < target():
            try:
                kept = next(self._iterations)
            except DivergenceError as error:
                self.ended = True
                yield error
                return
            except Exception:
                self.ended = True
                raise
            self._reached = kept.iteration if kept else self._reached
            yield kept
