"""The other process of :mod:`core.apart`: ``python -I -S apart_child.py [LIFELINE]``.

It imports nothing of the project, so that it can be started by its path, and nothing that takes
time before it knows what it is to do.
"""

import importlib.util
import os
import pickle
import signal
import sys
import traceback
from collections.abc import Iterator
from types import ModuleType
from typing import IO, Any


def main() -> None:
    """Advance a generator by one step for each byte that is read."""
    if len(sys.argv) > 1:
        _work_in_a_fork(int(sys.argv[1]))
    requests, replies = _pipes()
    steps = _steps(*pickle.load(requests))
    while requests.read(1):
        pickle.dump(_reply(steps), replies, protocol=5)
        replies.flush()


def _work_in_a_fork(lifeline: int) -> None:
    """Go on in a fork, while this process waits for the lifeline to be cut and then ends it.

    A thread could not do that: C code that keeps the interpreter lock would keep it waiting.
    """
    worker = os.fork()
    if not worker:
        os.close(lifeline)
        return
    for pipe in range(3):
        os.close(pipe)  # so that the other side sees when the worker ends by itself
    os.read(lifeline, 1)
    os.kill(worker, signal.SIGKILL)
    os.waitpid(worker, 0)
    os._exit(0)


def _pipes() -> tuple[IO[bytes], IO[bytes]]:
    """The pipes to read and to write; what a library prints goes nowhere."""
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return sys.stdin.buffer, replies


def _steps(path: list[str], file: str, name: str, arguments: bytes) -> Iterator[Any]:
    sys.path[:] = path
    yield from getattr(_loaded(file), name)(*pickle.loads(arguments))


def _loaded(file: str) -> ModuleType:
    name = os.path.splitext(os.path.basename(file))[0]
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _reply(steps: Iterator[Any]) -> tuple[str, Any]:
    try:
        return "item", next(steps)
    except StopIteration:
        return "end", None
    except Exception as error:  # noqa: BLE001 - the other process reports it
        return "error", _description(error)


def _description(error: Exception) -> tuple[str, str, str]:
    """Kind, message and trace: an exception itself cannot always be sent."""
    trace = traceback.format_exc()
    for kind in (ValueError, MemoryError, RuntimeError):
        if isinstance(error, kind):
            return kind.__name__, str(error), trace
    return "RuntimeError", f"{type(error).__name__}: {error}", trace


if __name__ == "__main__":
    main()
