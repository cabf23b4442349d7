"""All that runs at the moment: what it is, how far, and how long it will still take."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from psygnal import Signal

from app.session.remaining import Remaining, in_words


def _unknown() -> float | None:
    return None


def _nothing() -> None:
    """Default for what need not be done."""


@dataclass(eq=False, kw_only=True)
class Task:
    """Something that takes a while.

    Attributes
    ----------
    title : str
        What it is, for a person.
    share : callable
        Returns the share that is done, None where that is not known.
    on_cancel : callable
        What else happens when a person cancels it.
    can_cancel : bool
        Whether a person may cancel it.
    cancelled : bool
        Whether it is to stop.
    """

    title: str = "Working"
    share: Callable[[], float | None] = _unknown
    on_cancel: Callable[[], object] = _nothing
    can_cancel: bool = True
    cancelled: bool = field(default=False, init=False)

    def cancel(self) -> None:
        """Ask it to stop."""
        self.cancelled = True


@dataclass(frozen=True)
class TaskState:
    """How a task, or several together, stand.

    Attributes
    ----------
    title : str
        What it is.
    share : float or None
        Share that is done, 0 to 1.
    seconds : float
        Time so far.
    seconds_left : float or None
        Estimate of the time that is left.
    stopping : bool
        Whether it was cancelled and ends its last step.
    task : Task or None
        The task, None for several together.
    """

    title: str
    share: float | None
    seconds: float
    seconds_left: float | None
    stopping: bool
    task: Task | None = None

    @property
    def words(self) -> str:
        """How far it is and how long it will still take."""
        if self.stopping:
            return "stopping …"
        if self.share is None:
            return f"{self.seconds:.0f} s so far" if self.seconds >= 1 else ""
        done = f"{100 * self.share:.0f} %"
        return done if self.seconds_left is None else f"{done}, {in_words(self.seconds_left)}"


class RunningTasks:
    """The tasks that run, in the order in which they began; for one thread.

    Parameters
    ----------
    clock : callable
        Time in seconds.
    """

    changed = Signal()
    """A task has begun or ended, or was cancelled."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._known: dict[Task, tuple[float, Remaining]] = {}

    def begin(self, task: Task) -> None:
        """Tell that a task has begun."""
        self._known[task] = self._clock(), Remaining()
        self.changed.emit()

    def end(self, task: Task) -> None:
        """Tell that a task has ended, however it did."""
        if self._known.pop(task, None):
            self.changed.emit()

    def cancel(self, task: Task) -> None:
        """Cancel one task, as a person does."""
        if task in self._known and task.can_cancel and not task.cancelled:
            task.cancel()
            task.on_cancel()
            self.changed.emit()

    def cancel_all(self) -> None:
        """Cancel all that may be cancelled."""
        for task in list(self._known):
            self.cancel(task)

    def states(self, *, older_than: float = 0.0) -> tuple[TaskState, ...]:
        """Return how the tasks stand that have run for some seconds."""
        now = self._clock()
        return tuple(
            self._state(task, now)
            for task, (begun, _) in self._known.items()
            if now - begun >= older_than
        )

    def _state(self, task: Task, now: float) -> TaskState:
        begun, remaining = self._known[task]
        share = task.share()
        share = None if share is None else min(max(share, 0.0), 1.0)
        left = remaining.update(share, now)
        return TaskState(task.title, share, now - begun, left, task.cancelled, task)


def together(states: Sequence[TaskState]) -> TaskState:
    """Sum up what runs; the time left is that of the longest."""
    if len(states) == 1:
        return states[0]
    shares = [state.share for state in states if state.share is not None]
    times = [state.seconds_left for state in states if state.seconds_left is not None]
    return TaskState(
        f"{states[0].title} and {len(states) - 1} more",
        sum(shares) / len(shares) if shares else None,
        max(state.seconds for state in states),
        max(times, default=None),
        all(state.stopping for state in states),
    )
