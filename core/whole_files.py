"""Files that are written whole or not at all, so that a full disk or a kill leaves the old one."""

import io
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


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

    Raises
    ------
    OSError
        If the system refuses; the old file is then untouched and nothing is left behind.
    """
    target = Path(os.path.realpath(file))
    fresh = target.with_name(f".{target.stem}.{secrets.token_hex(4)}.tmp{target.suffix}")
    try:
        yield fresh
        fresh.replace(target)
    finally:
        fresh.unlink(missing_ok=True)


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
