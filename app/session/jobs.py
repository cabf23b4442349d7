"""Work beside the window: generators advanced in turn by one thread.

One thread, because the compiled loops use all cores themselves; in turn, so that six methods
advance side by side and none waits for another to finish.
"""

import logging
import threading
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any

logger = logging.getLogger(__name__)

Post = Callable[[Callable[[], None]], None]
"""Runs a function on the thread that owns the session."""


def _ignore(_: Any) -> None:
    """Default for results nobody asked for."""


@dataclass(eq=False)
class Job:
    """A piece of work: a generator and what to do with what it yields.

    Attributes
    ----------
    steps : iterator
        Advanced on the worker thread.
    on_step, on_error, on_done : callable
        Called on the owner's thread with each item, with an exception, and at the end.
    """

    steps: Iterator[Any]
    on_step: Callable[[Any], None] = _ignore
    on_error: Callable[[Exception], None] = _ignore
    on_done: Callable[[], None] = lambda: None
    cancelled: bool = field(default=False, init=False)

    def cancel(self) -> None:
        """Stop after the step that is running; `on_done` is still called."""
        self.cancelled = True


class Jobs:
    """Queue of jobs and the thread that advances them.

    Parameters
    ----------
    post : callable
        Runs a function on the owner's thread; the default runs it at once, on the worker.
    """

    def __init__(self, post: Post = lambda call: call()) -> None:
        self._post = post
        self._queue: deque[Job] = deque()
        self._wake = threading.Condition()
        self._closed = False
        self._thread = threading.Thread(target=self._work, name="burnish-jobs", daemon=True)
        self._thread.start()

    def start(self, job: Job, *, urgent: bool = False) -> Job:
        """Add a job; an urgent one takes the next turn."""
        with self._wake:
            if urgent:
                self._queue.appendleft(job)
            else:
                self._queue.append(job)
            self._wake.notify()
        return job

    def close(self) -> None:
        """Drop all jobs and wait for the step that is running."""
        with self._wake:
            self._closed = True
            self._queue.clear()
            self._wake.notify()
        self._thread.join()

    def _work(self) -> None:
        while (job := self._next()) is not None:
            if self._advance(job):
                with self._wake:
                    self._queue.append(job)

    def _next(self) -> Job | None:
        with self._wake:
            self._wake.wait_for(lambda: self._closed or self._queue)
            return None if self._closed else self._queue.popleft()

    def _advance(self, job: Job) -> bool:
        """Take one step of a job; tell whether there is more."""
        try:
            item = None if job.cancelled else next(job.steps, None)
        except Exception as error:
            # Whatever a worker raises belongs to its owner.
            logger.info("job failed", exc_info=error)
            self._deliver(partial(job.on_error, error))
            item = None
        if item is None:
            self._deliver(job.on_done)
            return False
        self._deliver(lambda: job.on_step(item))
        return True

    def _deliver(self, call: Callable[[], None]) -> None:
        if not self._closed:
            self._post(call)
