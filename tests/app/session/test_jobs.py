"""Work beside the window: turns, cancelling, closing while a step cannot be cut."""

import os
import queue
import sys
import threading
import time
from itertools import islice

import pytest

from app.session.jobs import Job, Jobs, progress_job
from core.statistics import Progress

_LONG = 30.0


class Owner:
    """The thread that owns the jobs, which are its own."""

    def __init__(self, **options):
        self.calls = queue.Queue()
        self.jobs = Jobs(self.calls.put, **options)

    def work_until(self, condition):
        while not condition():
            self.calls.get(timeout=_LONG)()


@pytest.fixture
def owner():
    owner = Owner()
    yield owner
    owner.jobs.close()


@pytest.fixture
def gate():
    """Something to wait for on the worker, opened at the end in any case."""
    gate = threading.Event()
    yield gate
    gate.set()


def test_jobs_take_turns(owner, gate):
    seen, ended = [], []

    def counting(name):
        gate.wait(_LONG)
        for k in range(3):
            yield f"{name}{k}"

    for name in "ab":
        owner.jobs.start(Job(counting(name), seen.append, on_done=lambda: ended.append(1)))
    gate.set()
    owner.work_until(lambda: len(ended) == 2)
    assert seen == ["a0", "b0", "a1", "b1", "a2", "b2"]


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has priorities of threads")
def test_work_gives_way_to_the_window(owner):
    seen, ended = [], []
    nice = iter(lambda: os.getpriority(os.PRIO_PROCESS, 0), None)
    owner.jobs.start(Job(islice(nice, 1), seen.append, on_done=lambda: ended.append(1)))
    owner.work_until(lambda: ended)
    assert seen[0] > os.getpriority(os.PRIO_PROCESS, 0)


def test_urgent_jobs_are_done_before_the_others(owner, gate):
    seen, ended, begun = [], [], threading.Event()

    def blocking():
        begun.set()
        gate.wait(_LONG)
        yield "first"

    def start(steps, **options):
        owner.jobs.start(Job(steps, seen.append, on_done=lambda: ended.append(1)), **options)

    start(blocking())
    begun.wait(_LONG)
    start(iter("xyz"))
    start(iter("uv"), urgent=True)
    gate.set()
    owner.work_until(lambda: len(ended) == 3)
    assert seen == ["first", "u", "v", "x", "y", "z"]


def test_a_step_with_nothing_to_tell_is_no_end(owner):
    seen, ended = [], []
    steps = iter([None, "a", None, None, "b"])
    owner.jobs.start(Job(steps, seen.append, on_done=lambda: ended.append(1)))
    owner.work_until(lambda: ended)
    assert seen == ["a", "b"]


def test_jobs_are_listed_while_they_run(owner):
    job = progress_job(iter([Progress(None, 0.5), Progress("all", 1.0)]), print, title="Graph")
    owner.jobs.start(job)
    (state,) = owner.jobs.tasks.states()
    assert (state.title, state.share) == ("Graph", None)
    owner.calls.get(timeout=_LONG)()
    assert owner.jobs.tasks.states()[0].share == 0.5
    owner.work_until(lambda: not owner.jobs.tasks.states())


@pytest.mark.parametrize(("late", "expected"), [(False, []), (True, ["outcome"])])
def test_the_outcome_of_the_step_that_ends_after_cancelling(owner, gate, late, expected):
    seen, begun, ended = [], threading.Event(), []

    def steps():
        begun.set()
        gate.wait(_LONG)
        yield "outcome"
        yield "never"

    job = Job(steps(), seen.append, on_done=lambda: ended.append(1), late=late)
    owner.jobs.start(job)
    begun.wait(_LONG)
    owner.jobs.tasks.cancel(job)
    assert owner.jobs.tasks.states()[0].stopping
    gate.set()
    owner.work_until(lambda: ended)
    assert seen == expected
    assert not owner.jobs.tasks.states()


def test_errors_are_told_unless_the_job_was_cancelled(owner, gate):
    told, ended = [], []

    def failing():
        gate.wait(_LONG)
        raise ValueError("no")
        yield

    jobs = [Job(failing(), on_error=told.append, on_done=lambda: ended.append(1)) for _ in "ab"]
    for job in jobs:
        owner.jobs.start(job)
    owner.jobs.tasks.cancel(jobs[0])
    gate.set()
    owner.work_until(lambda: len(ended) == 2)
    assert len(told) == 1


def test_closing_does_not_wait_for_a_step_that_cannot_be_cut(gate):
    owner = Owner()
    begun = threading.Event()

    def steps():
        begun.set()
        gate.wait(_LONG)
        yield "too late"

    owner.jobs.start(Job(steps(), title="Decimation"))
    begun.wait(_LONG)
    started = time.monotonic()
    owner.jobs.close()
    # The step would take 30 s; the rest is room for a busy machine.
    assert time.monotonic() - started < 10
    assert not owner.jobs.tasks.states()
    gate.set()
    owner.jobs._thread.join(_LONG)
    assert not owner.jobs._thread.is_alive()
    assert owner.calls.empty()


def test_closing_ends_the_thread_where_the_step_ends():
    owner = Owner()

    def steps():
        while True:
            yield 1

    owner.jobs.start(Job(steps()))
    owner.jobs.close()
    owner.jobs._thread.join(_LONG)
    assert not owner.jobs._thread.is_alive()


def test_what_must_finish_is_finished_by_closing():
    owner = Owner(must_finish=True, patience=None)
    written = []

    def write(name):
        time.sleep(0.05)
        written.append(name)
        yield True

    for name in ("study", "other"):
        owner.jobs.start(Job(write(name)))
    owner.jobs.close()
    assert written == ["study", "other"]
    assert not owner.jobs._thread.is_alive()


def test_what_must_finish_is_cancelled_when_patience_ends(gate):
    owner, told, reached = Owner(must_finish=True, patience=0.05), [], threading.Event()

    def write():
        reached.set()
        gate.wait(_LONG)
        yield True
        told.append("went on")

    job = Job(write(), on_cancel=lambda: told.append(threading.current_thread()))
    owner.jobs.start(job)
    assert reached.wait(_LONG)
    owner.jobs.close()
    assert job.cancelled
    gate.set()
    owner.jobs._thread.join(_LONG)
    assert told == [threading.current_thread()]


def test_a_cancelled_generator_cleans_up_on_the_worker(owner, gate):
    cleaned, ended = [], []

    def steps():
        try:
            yield 1
            gate.wait(_LONG)
            yield 2
        finally:
            cleaned.append(threading.current_thread().name)

    begun = []
    job = owner.jobs.start(Job(steps(), begun.append, on_done=lambda: ended.append(1)))
    owner.work_until(lambda: begun)
    job.cancel()
    gate.set()
    owner.work_until(lambda: ended)
    assert cleaned == ["burnish-jobs"]


def test_closing_lets_every_generator_clean_up():
    owner = Owner()
    cleaned, begun = [], threading.Semaphore(0)

    def steps(name):
        try:
            begun.release()
            while True:
                yield name
        finally:
            cleaned.append(name)

    for name in "ab":
        owner.jobs.start(Job(steps(name)))
    for _ in range(2):
        assert begun.acquire(timeout=_LONG)
    owner.jobs.close()
    owner.jobs._thread.join(_LONG)
    assert sorted(cleaned) == ["a", "b"]
