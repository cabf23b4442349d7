"""Long computations in C, in a process of their own.

C code that keeps Python's interpreter lock stops every other thread, and nothing can end it. Here
a generator runs in another process, which can be ended at any moment: when whoever iterates stops,
and when this process ends, however it does.
"""

import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import IO, Any, TypeVar

T = TypeVar("T")
Reply = tuple[str, Any]
"""``item`` and its value, ``error`` and the exception, or ``end``."""

_CHILD = Path(__file__).with_name("apart_child.py")
_TICK = 0.03
_FAREWELL = 1.0
_LOST = "A computation's own process has ended before its time; there may be too little memory"


def run_apart(
    steps: Callable[..., Iterator[T]], *arguments: object
) -> Generator[T | None, None, None]:
    """Advance a generator in a process of its own.

    Parameters
    ----------
    steps : callable
        A generator function of a file that imports nothing of this project: the other process
        loads that file alone, which takes a fraction of the time.
    *arguments
        What it is called with: arrays, numbers, text.

    Yields
    ------
    object or None
        What the generator yields, and None several times a second while it is computing, so that
        whoever iterates may stop then.

    Raises
    ------
    ValueError, MemoryError, RuntimeError
        What the generator raises; an exception of another kind is named in a RuntimeError.
    ChildProcessError
        If the other process ends by itself.
    """
    child = _Child(steps, arguments)
    try:
        while True:
            kind, value = yield from child.next_reply()
            if kind == "end":
                return
            if kind == "error":
                raise value
            yield value
    finally:
        child.end()


class _Child:
    """The other process, and the thread that talks with it."""

    def __init__(self, steps: Callable[..., Any], arguments: tuple[object, ...]) -> None:
        self._replies: SimpleQueue[Reply] = SimpleQueue()
        self._turns: SimpleQueue[bool] = SimpleQueue()
        self._process, self._lifeline = _started()
        self._thread = threading.Thread(
            target=self._talk, args=(steps, arguments), name="burnish-apart", daemon=True
        )
        self._thread.start()

    def next_reply(self) -> Generator[None, None, Reply]:
        """Ask for a reply; yield None until it is there."""
        self._turns.put(True)
        while True:
            try:
                return self._replies.get(timeout=_TICK)
            except Empty:
                yield None

    def end(self) -> None:
        """End the process, whatever it is doing."""
        self._turns.put(False)
        if self._lifeline is None:
            self._process.kill()
        else:
            os.close(self._lifeline)
        self._thread.join(_FAREWELL)

    def _talk(self, steps: Callable[..., Any], arguments: tuple[object, ...]) -> None:
        requests, replies = self._process.stdin, self._process.stdout
        assert requests is not None
        assert replies is not None
        try:
            _send(requests, steps, arguments)
            while self._turns.get():
                requests.write(b"\n")
                requests.flush()
                self._replies.put(_received(replies))
        except (OSError, EOFError, pickle.UnpicklingError):
            self._replies.put(("error", ChildProcessError(_LOST)))
        except Exception as error:  # noqa: BLE001 - whoever waits is to hear of it
            self._replies.put(("error", error))
        self._process.communicate()  # closes the pipes and waits until the process is gone


def _send(requests: IO[bytes], steps: Callable[..., Any], arguments: tuple[object, ...]) -> None:
    """Say what is to be done. The arguments are unpacked last, when it is known from where."""
    file = sys.modules[steps.__module__].__file__
    pickle.dump((sys.path, file, steps.__name__, pickle.dumps(arguments)), requests)


def _received(replies: IO[bytes]) -> Reply:
    kind, value = pickle.load(replies)
    return kind, _error(*value) if kind == "error" else value


def _error(kind: str, message: str, trace: str) -> Exception:
    """Make the error again that the other process has met."""
    error = {"ValueError": ValueError, "MemoryError": MemoryError}.get(kind, RuntimeError)(message)
    error.add_note(trace)
    return error


def _started() -> tuple[subprocess.Popen[bytes], int | None]:
    """Start the process; return it with the end of the pipe that keeps it alive.

    It comes to an end when that end is closed, by this process or by its death. Windows has no
    fork, so there the process ends with the step it is in at the latest.
    """
    if sys.platform == "win32":
        return _popen([], creationflags=subprocess.CREATE_NO_WINDOW), None
    theirs, ours = os.pipe()
    try:
        # In a session of its own it does not hear of Ctrl+C, which is for this process to answer.
        return _popen([str(theirs)], pass_fds=[theirs], start_new_session=True), ours
    except OSError:
        os.close(ours)
        raise
    finally:
        os.close(theirs)


def _popen(words: list[str], **options: Any) -> subprocess.Popen[bytes]:
    process: subprocess.Popen[bytes] = subprocess.Popen(
        [sys.executable, "-I", "-S", str(_CHILD), *words],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        **options,
    )
    return process
