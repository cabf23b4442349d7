"""Files that are written whole or not at all, so that a full disk or a kill leaves the old one."""

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from core.leftovers import fresh_path, remove_leftovers


class Staging:
    """Files that take their places together, or none of them does.

    What this module writes within ``with staging:`` stays beside its place until :meth:`commit`.
    """

    def __init__(self) -> None:
        self._held: list[tuple[Path, Path]] = []

    def __enter__(self) -> None:
        self._token = _STAGING.set(self)

    def __exit__(self, *_: object) -> None:
        _STAGING.reset(self._token)

    def hold(self, fresh: Path, target: Path) -> None:
        """Keep a file that is written until it may take its place."""
        self._held.append((fresh, target))

    def commit(self) -> None:
        """Put every file in its place.

        Raises
        ------
        OSError
            If the system refuses one of them.
        """
        while self._held:
            fresh, target = self._held[0]
            fresh.replace(target)
            self._held.pop(0)

    def discard(self) -> None:
        """Leave nothing behind of what has not taken its place."""
        while self._held:
            self._held.pop()[0].unlink(missing_ok=True)


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
    """
    with replacing(file) as fresh, fresh.open("xb") as stream:
        stream.write(content)
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
    try:
        yield fresh
        if staging := _STAGING.get():
            staging.hold(fresh, target)
        else:
            fresh.replace(target)
    except BaseException:
        fresh.unlink(missing_ok=True)
        raise


@contextmanager
def whole_file(file: Path) -> Iterator[io.BytesIO]:
    """Give a stream in memory whose content becomes the file at the end, unless something fails.

    Raises
    ------
    OSError
        If the system refuses; the old file is then untouched and nothing is left behind.
    """
    stream = io.BytesIO()
    yield stream
    write_atomically(file, stream.getvalue())
