"""Results of smoothing runs, kept under what they were computed from."""

from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from app.session.run_source import Kept, Source, centre_of, kept_iterations
from core.arrays import FloatArray
from core.comparison import Comparison
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
    positions : tuple of (m, 3) float32 ndarray or None
        Vertices after 0 (the noisy input), 1, 2 … iterations, relative to `centre`; None where
        memory ran short. The first and the last are always there.
    errors : tuple of dict
        Each metric after 0, 1, 2 … iterations.
    seconds : tuple of float
        Time of each iteration.
    diverged : int or None
        The iteration at which the run diverged; there are no more snapshots from it on.
    """

    centre: FloatArray
    positions: tuple[NDArray[np.float32] | None, ...]
    errors: tuple[dict[str, float], ...]
    seconds: tuple[float, ...] = ()
    diverged: int | None = None

    @classmethod
    def begin(cls, comparison: Comparison) -> "Run":
        """Begin a run with the noisy input."""
        centre = centre_of(comparison)
        start = (comparison.noisy.vertices - centre).astype(np.float32)
        return cls(centre, (start,), (comparison.noisy_errors,))

    @property
    def computed(self) -> int:
        """Number of iterations that are there."""
        return len(self.seconds)

    @property
    def bytes(self) -> int:
        """Memory that the snapshots take."""
        return sum(position.nbytes for position in self.positions if position is not None)

    @property
    def seconds_per_iteration(self) -> float | None:
        """Median time of an iteration, None before the first."""
        return float(np.median(self.seconds)) if self.seconds else None

    def holds(self, iteration: int) -> bool:
        """Whether the snapshot after an iteration is there."""
        return self.positions[iteration] is not None

    def nearest(self, iteration: int) -> int:
        """Return the last iteration up to a given one whose snapshot is there."""
        reached = min(iteration, self.computed)
        return next(k for k in range(reached, -1, -1) if self.holds(k))

    def snapshot(self, iteration: int) -> NDArray[np.float32]:
        """Return the positions after an iteration relative to `centre`, (m, 3).

        Raises
        ------
        LookupError
            If memory ran short for it.
        """
        position = self.positions[iteration]
        if position is None:
            raise LookupError(f"The snapshot after iteration {iteration} is not there.")
        return position

    def vertices(self, iteration: int) -> FloatArray:
        """Return the positions after an iteration in model coordinates, (m, 3)."""
        return self.snapshot(iteration).astype(np.float64) + self.centre

    def values(self, metric: str) -> list[float]:
        """Return a metric after 0, 1, 2 … iterations."""
        return [errors[metric] for errors in self.errors]

    def best(self, metric: str) -> tuple[int, float]:
        """Return the iteration with the smallest error, and that error."""
        values = self.values(metric)
        iteration = int(np.argmin(values))
        return iteration, values[iteration]

    def extended(self, step: Kept | DivergenceError, wanted: int = 0) -> "Run":
        """Return the run with one more iteration, or with the news that it diverged.

        Of an iteration that is known, only the snapshot is taken, and only if it is `wanted`.
        """
        if isinstance(step, DivergenceError):
            return replace(self, diverged=step.iteration)
        if step.iteration <= self.computed:
            return (
                self._holding(step.iteration, step.position) if step.iteration == wanted else self
            )
        return replace(
            self,
            positions=(*self.positions, step.position),
            errors=(*self.errors, step.errors),
            seconds=(*self.seconds, step.seconds),
        )

    def thinned(self, wanted: int) -> "Run":
        """Return the run without every other snapshot; the first, the last, and `wanted` stay."""
        stay = {0, self.computed, wanted}
        spare = [k for k in range(len(self.positions)) if self.holds(k) and k not in stay]
        gone = set(spare[::2])
        kept = (None if k in gone else position for k, position in enumerate(self.positions))
        return replace(self, positions=tuple(kept)) if gone else self

    def _holding(self, iteration: int, position: NDArray[np.float32]) -> "Run":
        before, after = self.positions[:iteration], self.positions[iteration + 1 :]
        return replace(self, positions=(*before, position, *after))


class RunStore:
    """Runs by key, the least recently used dropped first when memory runs short.

    Parameters
    ----------
    budget : int
        Memory for snapshots in bytes. Runs in use lose snapshots when they take more, but never
        a number.
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
            self._entries[key] = (
                Run.begin(comparison),
                Source(partial(kept_iterations, comparison, choice)),
            )
        self._entries.move_to_end(key)
        return self._entries[key]

    def put(self, key: RunKey, run: Run, in_use: Mapping[RunKey, int]) -> None:
        """Replace a run by one that knows more, and make room as :meth:`trim` does."""
        if key not in self._entries:
            return
        self._entries[key] = run, self._entries[key][1]
        self._entries.move_to_end(key)
        self.trim({key: 0, **in_use})

    def trim(self, in_use: Mapping[RunKey, int]) -> None:
        """Make room: runs that are not in use go first, the least recently used before others.

        If that is not enough, runs in use are thinned, the largest first; the snapshot after the
        iteration that `in_use` gives stays.
        """
        for key in [key for key in self._entries if key not in in_use]:
            if self._excess <= 0:
                return
            del self._entries[key]
        while self._excess > 0 and self._thin(in_use):
            pass

    @property
    def _excess(self) -> int:
        return sum(run.bytes for run, _ in self._entries.values()) - self.budget

    def _thin(self, in_use: Mapping[RunKey, int]) -> bool:
        """Thin the largest run that can be; tell whether there was one."""
        for key in sorted(self._entries, key=lambda key: -self._entries[key][0].bytes):
            run, source = self._entries[key]
            thinner = run.thinned(in_use[key])
            if thinner is not run:
                self._entries[key] = thinner, source
                return True
        return False
