"""Work in a process of its own: its results, its faults, its end."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from core.apart import run_apart
from core.mesh import quadrics
from core.statistics import extremes, heat

HERE = Path(__file__).parent
PATIENCE = 60

posix = pytest.mark.skipif(sys.platform == "win32", reason="there is no fork on Windows")


@pytest.fixture
def steps(monkeypatch):
    monkeypatch.syspath_prepend(str(HERE))
    import apart_steps

    return apart_steps


def items(*work):
    return [item for item in run_apart(*work) if item is not None]


def is_gone(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return True
    return False


def wait_until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_items_come_in_their_order(steps):
    assert np.array_equal(items(steps.squares, [1, 2, 3]), [[1] * 3, [4] * 3, [9] * 3])
    assert items(steps.squares, []) == []


def test_what_a_library_prints_does_not_get_among_the_items(steps):
    assert items(steps.prints) == ["said"]


def test_there_is_a_turn_for_whoever_iterates_while_it_computes(steps):
    found = list(run_apart(steps.dawdles, 0.5))
    assert found[-1] == "done"
    assert found.count(None) == len(found) - 1 >= 3


@pytest.mark.parametrize(("work", "kind", "sentence"), [
    ("refuses", ValueError, "This cannot be done."),
    ("breaks", RuntimeError, "KeyError: 'a fault'"),
    ("has_too_little_memory", MemoryError, "too large"),
])  # fmt: skip
def test_an_error_of_the_other_process_is_raised_here(steps, work, kind, sentence):
    with pytest.raises(kind) as caught:
        items(getattr(steps, work))
    assert str(caught.value) == sentence
    assert f"in {work}" in caught.value.__notes__[0]


def test_a_crash_of_the_other_process_is_one_sentence(steps):
    running = run_apart(steps.crashes)
    assert next(item for item in running if item is not None) == 1
    with pytest.raises(ChildProcessError, match="has ended before its time"):
        list(running)


@posix
def test_what_keeps_the_lock_is_ended_at_once_and_leaves_nothing(steps):
    threads, pipes = set(threading.enumerate()), len(os.listdir("/dev/fd"))
    running = run_apart(steps.keeps_the_lock)
    process = next(item for item in running if item is not None)
    assert [next(running) for _ in range(5)] == [None] * 5
    assert not is_gone(process)
    running.close()
    wait_until(lambda: is_gone(process))
    wait_until(lambda: set(threading.enumerate()) <= threads)
    assert len(os.listdir("/dev/fd")) == pipes


_PARENT = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # programs in the background ignore it
sys.path[:0] = sys.argv[1:]
import apart_steps
from core.apart import run_apart
for item in run_apart(apart_steps.keeps_the_lock):
    if item is not None:
        print(item, flush=True)
"""


@posix
@pytest.mark.parametrize("how", ["SIGKILL", "SIGTERM", "SIGINT"])
def test_it_does_not_outlive_who_started_it(how):
    """The program has no ``if __name__ == "__main__"``; another process must not run it again."""
    words = [sys.executable, "-c", _PARENT, str(HERE), str(HERE.parents[1])]
    parent = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    with parent:
        process = int(parent.stdout.readline())
        assert not is_gone(process)
        parent.send_signal(getattr(signal, how))
    wait_until(lambda: is_gone(process))


@pytest.mark.parametrize("module", [extremes, heat, quadrics])
def test_the_files_that_run_apart_import_nothing_of_the_project(module):
    code = f"import runpy, sys; runpy.run_path({module.__file__!r}); print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-I", "-c", code], capture_output=True, text=True, check=True
    )
    assert not {"core", "app", "numba", "PySide6", "vtkmodules"} & set(done.stdout.split())
