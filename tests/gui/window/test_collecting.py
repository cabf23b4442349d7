"""Garbage is collected by the window's thread, whoever makes it."""

import gc
import threading
import weakref

from app.session.jobs import Job


class Knot:
    """Refers to itself, so that only a collection can end it."""

    def __init__(self):
        self.itself = self


def test_a_worker_that_makes_garbage_collects_none(user):
    ended_by = []
    weakref.finalize(Knot(), lambda: ended_by.append(threading.current_thread()))

    def make_garbage():
        for _ in range(100_000):
            Knot()
        yield "made"

    done = []
    user.window.session.jobs.start(Job(make_garbage(), done.append, done.append, title="Garbage"))
    user.wait(lambda: done == ["made"])
    user.wait(lambda: ended_by)
    assert ended_by == [threading.main_thread()]


def test_without_a_window_python_collects_again(window):
    assert not gc.isenabled()
    window.close()
    assert gc.isenabled()
