"""Undo and redo: the old studies themselves, each with the name of the step after it."""

import time
from dataclasses import dataclass

from core.study import Study

_STEPS = 200
_MERGE_SECONDS = 1.0


@dataclass(frozen=True)
class Step:
    """A study to go back (or forward) to, and what the step changes."""

    study: Study
    name: str


class History:
    """Two stacks of studies.

    Steps of the same name that follow each other within a second, as when a slider is dragged,
    count as one.
    """

    def __init__(self) -> None:
        self._past: list[Step] = []
        self._future: list[Step] = []
        self._last = 0.0

    @property
    def undo_name(self) -> str | None:
        """Name of the step that undo would take back."""
        return self._past[-1].name if self._past else None

    @property
    def redo_name(self) -> str | None:
        """Name of the step that redo would do again."""
        return self._future[-1].name if self._future else None

    @property
    def studies(self) -> tuple[Study, ...]:
        """All studies that undo and redo can come to."""
        return tuple(step.study for step in (*self._past, *self._future))

    def record(self, before: Study, name: str) -> None:
        """Record that `before` is about to be changed."""
        now = time.monotonic()
        merges = self._past and self._past[-1].name == name and now - self._last < _MERGE_SECONDS
        self._last = now
        self._future.clear()
        if not merges:
            self._past.append(Step(before, name))
            del self._past[:-_STEPS]

    def seal(self) -> None:
        """Let the next step be one of its own, so that undo comes back to this very study."""
        self._last = 0.0

    def undo(self, current: Study) -> Study:
        """Take back one step and return the study before it."""
        return self._move(self._past, self._future, current)

    def redo(self, current: Study) -> Study:
        """Do one step again and return the study after it."""
        return self._move(self._future, self._past, current)

    def _move(self, source: list[Step], target: list[Step], current: Study) -> Study:
        if not source:
            return current
        step = source.pop()
        target.append(Step(current, step.name))
        self.seal()
        return step.study
