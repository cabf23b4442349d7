"""Work that leaves the window its turns: a few steps whenever the window has nothing else to do."""

import time
from collections import deque
from collections.abc import Callable, Iterator

from PySide6.QtCore import QObject, QTimer

_TURN_SECONDS = 0.005


class Turns(QTimer):
    """Takes steps of the work that is there in each turn of the event loop, for a moment.

    Whatever takes longer than that moment has a turn to itself: steps are not added up to a wait.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent, singleShot=True)
        self._jobs: deque[Iterator[None]] = deque()
        self.timeout.connect(self._take_some)

    def add(self, job: Iterator[None]) -> None:
        """Take the steps of a job, up to each of its yields."""
        self._jobs.append(job)
        self.start()

    def _take_some(self) -> None:
        begun = time.perf_counter()
        try:
            while self._jobs and time.perf_counter() - begun < _TURN_SECONDS:
                job = self._jobs.popleft()
                for _ in job:
                    self._jobs.append(job)
                    break
        finally:
            if self._jobs:
                self.start()  # only now, else it would come before timers that are due already


class Work:
    """Something that is done in steps as often as it is asked for, once for many requests.

    Parameters
    ----------
    turns : Turns
        Takes the steps.
    steps : callable
        Begins the work; asked for meanwhile, it begins anew after its last step.
    """

    def __init__(self, turns: Turns, steps: Callable[[], Iterator[None]]) -> None:
        self._turns, self._steps = turns, steps
        self._is_wanted = False
        self.is_active = False

    def request(self, *_: object) -> None:
        """Ask for it; takes whatever a signal sends."""
        self._is_wanted = True
        if not self.is_active:
            self.is_active = True
            self._turns.add(self._work())

    def _work(self) -> Iterator[None]:
        try:
            while self._is_wanted:
                self._is_wanted = False
                yield from self._steps()
        finally:
            self.is_active = False
