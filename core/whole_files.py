"""Files that are written whole or not at all, so that a full disk or a kill leaves the old one."""

import io
import os
from collections.abc import Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING

from core.leftovers import fresh_path, remove_leftovers

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

_BLOCK = 2**20


class Staging:
    """Files that take their places together, or none of them does.

    What this module writes within ``with staging:`` stays beside its place until :meth:`commit`.
    Any thread may :meth:`discard` it meanwhile: what is being written then stops soon.
    """

    def __init__(self) -> None:
        self._files: dict[Path, Path | None] = {}
        self._lock = Lock()
        self._is_discarded = False

    def __enter__(self) -> None:
        self._token = _STAGING.set(self)

    def __exit__(self, *_: object) -> None:
        _STAGING.reset(self._token)

    def check(self) -> None:
        """Go on only where what is written is still wanted.

        Raises
        ------
        CancelledError
            If it was discarded.
        """
        if self._is_discarded:
            raise CancelledError

    def hold(self, fresh: Path, target: Path | None) -> None:
        """Keep a file until it may take its place, which it has when it is written."""
        with self._lock:
            self.check()
            self._files[fresh] = target

    def drop(self, fresh: Path) -> None:
        """Forget a file that could not be written."""
        with self._lock:
            self._files.pop(fresh, None)

    def commit(self) -> None:
        """Put every file in its place.

        Raises
        ------
        OSError
            If the system refuses one of them.
        CancelledError
            If they were discarded.
        """
        with self._lock:
            self.check()
            for fresh, target in list(self._files.items()):
                if target:
                    fresh.replace(target)
                    del self._files[fresh]

    def discard(self) -> None:
        """Leave nothing behind of what has not taken its place, and take nothing more."""
        with self._lock:
            self._is_discarded = True
            while self._files:
                with suppress(OSError):  # Windows keeps what is open; who writes it removes it
                    self._files.popitem()[0].unlink(missing_ok=True)


_STAGING: ContextVar[Staging | None] = ContextVar("_STAGING", default=None)


def write_atomically(file: Path, content: bytes) -> None:
    """Write to a new file beside `file` and put it in its place: the old one or the new one.

    Parameters
    ----------
    file : Path
        What is written; a link stays a link.
    content : bytes
        The whole content.

    Raises
    ------
    OSError
        If the system refuses; the old file is then untouched and nothing is left behind.
    CancelledError
        If it is written within a :class:`Staging` that is discarded meanwhile.
    """
    with replacing(file) as fresh, fresh.open("xb") as stream:
        for start in range(0, len(content), _BLOCK):
            _check()
            stream.write(memoryview(content)[start : start + _BLOCK])
        stream.flush()
        os.fsync(stream.fileno())


@contextmanager
def replacing(file: Path) -> Iterator[Path]:
    """Give the path of a new file beside `file`, which takes its place unless something fails.

    Within a :class:`Staging` it takes its place when that says so. Also removes what processes
    that were killed have left of the same file.

    Raises
    ------
    OSError
        If the system refuses; the old file is then untouched and nothing is left behind.
    """
    target = Path(os.path.realpath(file))
    remove_leftovers(target)
    fresh = fresh_path(target)
    staging = _STAGING.get()
    try:
        if staging:
            staging.hold(fresh, None)
        yield fresh
        if staging:
            staging.hold(fresh, target)
        else:
            fresh.replace(target)
    except BaseException:
        fresh.unlink(missing_ok=True)
        if staging:
            staging.drop(fresh)
        raise


@contextmanager
def whole_file(file: Path) -> Iterator[io.BytesIO]:
    """Give a stream in memory whose content becomes the file at the end, unless something fails.

    Raises
    ------
    OSError
        If the system refuses; the old file is then untouched and nothing is left behind.
    """
    stream = _Stream()
    yield stream
    write_atomically(file, stream.getvalue())


class _Stream(io.BytesIO):
    """Memory that takes nothing more when it is not wanted any more: its writer stops there."""

    def write(self, content: "ReadableBuffer", /) -> int:
        _check()
        return super().write(content)


def _check() -> None:
    if staging := _STAGING.get():
        staging.check()
