"""Work beside the window: generators advanced in turn by one thread.

One thread, because the compiled loops use all cores themselves; in turn, so that six methods
advance side by side and none waits for another to finish.
"""

import logging
import os
import sys
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeVar

from app.session.running import RunningTasks, Task
from core.statistics import Progress

logger = logging.getLogger(__name__)

T = TypeVar("T")
Post = Callable[[Callable[[], None]], None]
"""Runs a function on the thread that owns the session."""

_END = object()
_PATIENCE = 0.3
_NICE = 4


def _give_way() -> None:
    """Let the window have the cores first: this thread, and those that its loops start, yield.

    Only Linux has a priority for each thread.
    """
    if sys.platform == "linux":
        lower = os.getpriority(os.PRIO_PROCESS, 0) + _NICE
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), lower)


def _ignore(_: Any) -> None:
    """Default for results nobody asked for."""


@dataclass(eq=False)
class Job(Task):
    """A piece of work: a generator and what to do with what it yields.

    A job that is cancelled stops after the step that is running, and its generator is closed on the
    worker thread; nobody hears of its outcome, but `on_done` is still called.

    Attributes
    ----------
    steps : iterator
        Advanced on the worker thread. It may yield None where there is nothing to tell yet, so
        that others have their turns and it may be cancelled.
    on_step, on_error, on_done : callable
        Called on the owner's thread with each item, with an exception, and at the end.
    late : bool
        Whether `on_step` is to get the step too that was running when the job was cancelled.
    urgent : bool
        Whether it takes its turn before those that are not.
    """

    steps: Iterator[Any]
    on_step: Callable[[Any], None] = _ignore
    on_error: Callable[[Exception], None] = _ignore
    on_done: Callable[[], None] = lambda: None
    late: bool = field(default=False, kw_only=True)
    urgent: bool = field(default=False, init=False)


def progress_job(
    steps: Iterator[Progress[T] | None],
    use: Callable[[T], None],
    on_error: Callable[[Exception], None] = _ignore,
    on_done: Callable[[], None] = lambda: None,
    *,
    title: str,
) -> Job:
    """Make a job of steps that tell how far they are, of which only the values are used."""
    reached: float | None = None

    def step(progress: Progress[T]) -> None:
        nonlocal reached
        reached = progress.share
        if progress.value is not None:
            use(progress.value)

    return Job(steps, step, on_error, on_done, title=title, share=lambda: reached)


class Jobs:
    """Queue of jobs and the thread that advances them.

    Parameters
    ----------
    post : callable
        Runs a function on the owner's thread; the default runs it at once, on the worker.
    tasks : RunningTasks, optional
        Where the jobs are listed while they run.
    must_finish : bool
        Whether what was started is carried out even when the jobs are closed.
    patience : float or None
        Seconds that closing waits for the step that is running, or for all that must finish; None:
        as long as it takes.
    """

    def __init__(
        self,
        post: Post = lambda call: call(),
        tasks: RunningTasks | None = None,
        *,
        must_finish: bool = False,
        patience: float | None = _PATIENCE,
    ) -> None:
        self.tasks = tasks or RunningTasks()
        self._post = post
        self._must_finish = must_finish
        self._patience = patience
        self._urgent: deque[Job] = deque()
        self._queue: deque[Job] = deque()
        self._unfinished: set[Job] = set()
        self._wake = threading.Condition()
        self._closed = False
        self._thread = threading.Thread(target=self._work, name="burnish-jobs", daemon=True)
        self._thread.start()

    def start(self, job: Job, *, urgent: bool = False) -> Job:
        """Add a job; urgent ones take their turns before all others."""
        job.urgent = urgent
        self._unfinished.add(job)
        self.tasks.begin(job)
        with self._wake:
            self._put(job)
            self._wake.notify()
        return job

    def close(self) -> None:
        """Cancel all jobs; give the step that is running a moment to end.

        A step that takes longer goes on by itself and nobody hears of its outcome: there is no way
        to cut it, and whoever closes is not to wait. Jobs that must finish are cancelled only when
        patience ends.
        """
        unfinished = list(self._unfinished)
        with self._wake:
            self._closed = True
            for job in unfinished:
                job.cancelled |= not self._must_finish
            self._wake.notify()
        for job in unfinished:
            self._forget(job)
        self._thread.join(self._patience)
        if self._must_finish and self._thread.is_alive():
            for job in unfinished:
                job.cancel()
                job.on_cancel()

    def _put(self, job: Job) -> None:
        (self._urgent if job.urgent else self._queue).append(job)

    def _work(self) -> None:
        _give_way()
        while (job := self._next()) is not None:
            if self._advance(job):
                with self._wake:
                    self._put(job)

    def _next(self) -> Job | None:
        with self._wake:
            self._wake.wait_for(lambda: self._closed or self._urgent or self._queue)
            queue = self._urgent or self._queue
            return queue.popleft() if queue else None

    def _advance(self, job: Job) -> bool:
        """Take one step of a job; tell whether there is more."""
        item: Any = _END
        try:
            if job.cancelled and isinstance(job.steps, Generator):
                job.steps.close()  # cleans up what it has begun
            item = _END if job.cancelled else next(job.steps, _END)
        except Exception as error:
            # Whatever a worker raises belongs to its owner.
            logger.info("job failed", exc_info=error)
            self._deliver(partial(_unless_cancelled, job, job.on_error, error))
        if item is _END:
            self._deliver(partial(self._end, job))
            return False
        if item is not None:
            self._deliver(partial(_unless_cancelled, job, job.on_step, item, late=job.late))
        return True

    def _end(self, job: Job) -> None:
        self._forget(job)
        job.on_done()

    def _forget(self, job: Job) -> None:
        self._unfinished.discard(job)
        self.tasks.end(job)

    def _deliver(self, call: Callable[[], None]) -> None:
        with self._wake:  # the owner may be gone as soon as it has closed
            if not self._closed:
                self._post(partial(self._unless_closed, call))

    def _unless_closed(self, call: Callable[[], None]) -> None:
        if not self._closed:
            call()


def _unless_cancelled(
    job: Job, call: Callable[[Any], None], value: Any, *, late: bool = False
) -> None:
    if late or not job.cancelled:
        call(value)
