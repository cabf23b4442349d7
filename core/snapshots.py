"""The states of a run: its iterations, and the errors of several of them measured together."""

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.lanes import WIDTH, side_by_side
from core.mesh import TriangleMesh
from core.mesh.ordering import Numbering
from core.metrics import Evaluator
from core.smoothing import DivergenceError, DivergenceGuard, method_spec
from core.study import MethodChoice

# Errors are measured after at most this time, in seconds: whoever looks at the plot sees it grow.
_PATIENCE = 0.2
# Memory for iterations that wait: each with its positions, and all side by side with one number.
_ROOM = 512 * 2**20
_BYTES_OF_A_VERTEX = 8 * WIDTH * (3 + 3 + 1)


class Iteration(NamedTuple):
    """What an iteration gave: its number from 1 on, its time, its positions, their numbering."""

    number: int
    seconds: float
    along_surface: FloatArray
    numbering: Numbering


@dataclass(frozen=True, eq=False)
class Snapshot:
    """State of a run after one iteration.

    Attributes
    ----------
    iteration : int
        Counted from 1.
    errors : dict of str to float
        Each metric against the original.
    seconds : float
        Processor time that the calling thread spent on the iteration, without the metrics; the
        parallel loops' other threads work at the same time.
    along_surface : (m, 3) float64 ndarray
        Positions as the method gave them.
    numbering : Numbering
        Of these positions.
    """

    iteration: int
    errors: dict[str, float]
    seconds: float
    along_surface: FloatArray
    numbering: Numbering

    @property
    def vertices(self) -> FloatArray:
        """Positions in the order of the file, (m, 3)."""
        return self.numbering.outward(self.along_surface)


def iterations(noisy: TriangleMesh, choice: MethodChoice) -> Iterator[Iteration | None]:
    """Yield the iterations of a method without end; None while one takes long.

    Raises
    ------
    DivergenceError
        When the run diverges; the iteration before is the last good one.
    """
    numbering = noisy.topology.ordering.vertices
    noisy = noisy.along_surface()
    guard = DivergenceGuard(noisy)
    positions = method_spec(choice.method).steps(noisy, choice.settings)
    number, seconds = 1, 0.0
    while True:
        # Not the clock on the wall: beside a window that is drawing, this thread waits a lot.
        started = time.thread_time()
        vertices = next(positions)
        seconds += time.thread_time() - started
        if vertices is None:
            yield None
            continue
        if not guard.allows(vertices):
            raise DivergenceError(number)
        yield Iteration(number, seconds, vertices, numbering)
        number, seconds = number + 1, 0.0


def measured(
    steps: Iterator[Iteration | None],
    evaluators: Mapping[str, Evaluator],
    wanted: Callable[[], int],
) -> Iterator[Snapshot | None]:
    """Yield snapshots with their errors; None while an iteration takes long or waits for others.

    Eight are measured together, because that takes less than three by themselves. Fewer, when the
    last one that is `wanted` is there, when the last errors are a while ago, when those of a large
    mesh would take too much memory, and when the run ends.
    """
    errors = _Errors(evaluators)
    waiting: list[Iteration] = []
    before = time.monotonic()
    try:
        for step in steps:
            if step:
                waiting.append(step)
            there = bool(waiting) and waiting[-1].number >= wanted()
            late = time.monotonic() - before > _PATIENCE
            if waiting and (there or late or _is_full(waiting)):
                yield from errors.snapshots(waiting, more=not there)
                before = time.monotonic()
            else:
                yield None
    except Exception:
        if waiting:
            yield from errors.snapshots(waiting)  # what went before stands
        raise


def _is_full(waiting: Sequence[Iteration]) -> bool:
    """Whether as many iterations wait as can be measured together."""
    needed = _BYTES_OF_A_VERTEX * len(waiting[0].along_surface)
    return len(waiting) == WIDTH or needed > _ROOM


class _Errors:
    """Measures iterations of one run together.

    They are put side by side in memory that is kept until no more of them are wanted: new memory
    costs a page fault every 4 kB.
    """

    def __init__(self, evaluators: Mapping[str, Evaluator]) -> None:
        self._evaluators = evaluators
        self._room: FloatArray | None = None

    def snapshots(self, waiting: list[Iteration], *, more: bool = False) -> Iterator[Snapshot]:
        """Yield the one to eight iterations that wait, with their errors; they wait no longer."""
        values = self._values([step.along_surface for step in waiting])
        if not more:
            self._room = None
        for k in range(len(waiting)):
            number, seconds, along_surface, numbering = waiting.pop(0)
            errors = {id_: float(v[k]) for id_, v in values.items()}
            yield Snapshot(number, errors, seconds, along_surface, numbering)

    def _values(self, meshes: Sequence[FloatArray]) -> dict[str, FloatArray]:
        positions = side_by_side(meshes, self._room)
        if len(meshes) > 1:
            self._room = positions
        return {id_: np.atleast_1d(e.values(positions)) for id_, e in self._evaluators.items()}
