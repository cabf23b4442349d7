"""Results of smoothing runs, kept under what they were computed from."""

from collections import OrderedDict
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.comparison import Comparison, Snapshot
from core.smoothing import DivergenceError
from core.study import MethodChoice

RunKey = tuple[str, str]
"""What a run was computed from: the pair of meshes, and the method with its parameters."""


@dataclass(frozen=True, eq=False)
class Run:
    """What is known of one method on one pair of meshes.

    Attributes
    ----------
    centre : (3,) float64 ndarray
        Centroid of the original, which `positions` are relative to.
    positions : tuple of (m, 3) float32 ndarray
        Vertices after 0 (the noisy input), 1, 2 … iterations, relative to `centre`.
    errors : tuple of dict
        Each metric after 0, 1, 2 … iterations.
    seconds : tuple of float
        Time of each iteration.
    diverged : int or None
        The iteration at which the run diverged; there are no more snapshots from it on.
    """

    centre: FloatArray
    positions: tuple[NDArray[np.float32], ...]
    errors: tuple[dict[str, float], ...]
    seconds: tuple[float, ...] = ()
    diverged: int | None = None

    @classmethod
    def begin(cls, comparison: Comparison) -> "Run":
        """Begin a run with the noisy input."""
        centre = comparison.original.vertices.mean(axis=0)
        start = (comparison.noisy.vertices - centre).astype(np.float32)
        return cls(centre, (start,), (comparison.noisy_errors,))

    @property
    def computed(self) -> int:
        """Number of iterations that are there."""
        return len(self.seconds)

    @property
    def bytes(self) -> int:
        """Memory that the snapshots take."""
        return sum(position.nbytes for position in self.positions)

    @property
    def seconds_per_iteration(self) -> float | None:
        """Median time of an iteration, None before the first."""
        return float(np.median(self.seconds)) if self.seconds else None

    def vertices(self, iteration: int) -> FloatArray:
        """Return the positions after an iteration in model coordinates, (m, 3)."""
        return self.positions[iteration].astype(np.float64) + self.centre

    def values(self, metric: str) -> list[float]:
        """Return a metric after 0, 1, 2 … iterations."""
        return [errors[metric] for errors in self.errors]

    def best(self, metric: str) -> tuple[int, float]:
        """Return the iteration with the smallest error, and that error."""
        values = self.values(metric)
        iteration = int(np.argmin(values))
        return iteration, values[iteration]

    def extended(self, step: Snapshot | DivergenceError) -> "Run":
        """Return the run with one more iteration, or with the news that it diverged."""
        if isinstance(step, DivergenceError):
            return replace(self, diverged=step.iteration)
        position = (step.vertices - self.centre).astype(np.float32)
        return replace(
            self,
            positions=(*self.positions, position),
            errors=(*self.errors, step.errors),
            seconds=(*self.seconds, step.seconds),
        )


class Source:
    """The worker's end of a run: advances it, and goes on later where it stopped.

    `ended` says that no more will come, because the run diverged or failed.
    """

    def __init__(self, snapshots: Iterator[Snapshot]) -> None:
        self._snapshots = snapshots
        self._reached = 0
        self.ended = False

    def advance(self, target: Callable[[], int]) -> Iterator[Snapshot | DivergenceError]:
        """Yield snapshots until the iteration that `target` asks for, which may change."""
        while not self.ended and self._reached < target():
            try:
                snapshot = next(self._snapshots)
            except DivergenceError as error:
                self.ended = True
                yield error
                return
            except Exception:
                self.ended = True
                raise
            self._reached = snapshot.iteration
            yield snapshot


class RunStore:
    """Runs by key, the least recently used dropped first when memory runs short.

    Parameters
    ----------
    budget : int
        Memory for snapshots in bytes; runs in use are kept whatever they take.
    """

    def __init__(self, budget: int) -> None:
        self.budget = budget
        self._entries: OrderedDict[RunKey, tuple[Run, Source]] = OrderedDict()

    def get(self, key: RunKey) -> Run | None:
        """Return a run, or None where there is none."""
        entry = self._entries.get(key)
        return entry[0] if entry else None

    def begin(
        self, key: RunKey, comparison: Comparison, choice: MethodChoice
    ) -> tuple[Run, Source]:
        """Return a run and its source, begun anew where there is none; marks it as used."""
        if key not in self._entries:
            self._entries[key] = Run.begin(comparison), Source(comparison.snapshots(choice))
        self._entries.move_to_end(key)
        return self._entries[key]

    def put(self, key: RunKey, run: Run, in_use: Collection[RunKey]) -> None:
        """Replace a run by a longer one; drop the oldest that are not in use for lack of memory."""
        if key not in self._entries:
            return
        self._entries[key] = run, self._entries[key][1]
        self._entries.move_to_end(key)
        self.trim({key, *in_use})

    def trim(self, in_use: Collection[RunKey]) -> None:
        """Drop the least recently used runs that are not in use until the rest fits the budget."""
        total = sum(run.bytes for run, _ in self._entries.values())
        for key in [key for key in self._entries if key not in in_use]:
            if total <= self.budget:
                return
            total -= self._entries.pop(key)[0].bytes
