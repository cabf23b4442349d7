"""Numbers out of text files, a whole block of lines at a time."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.io.errors import LoadError
from core.io.polygons import Lists

# Put between lines before they are split, it shows where each line began.
_MARK = b"|"


def floats(tokens: Sequence[bytes]) -> FloatArray:
    """Convert words to numbers, (n,)."""
    try:
        return np.fromiter(map(float, tokens), np.float64, len(tokens))
    except ValueError as error:
        raise LoadError(f"{_culprit(tokens, float)} is not a number") from error


def integers(tokens: Sequence[bytes]) -> NDArray[np.int64]:
    """Convert words to whole numbers, (n,)."""
    try:
        return np.fromiter(map(int, tokens), np.int64, len(tokens))
    except (ValueError, OverflowError) as error:
        raise LoadError(f"{_culprit(tokens, np.int64)} is not a whole number") from error


def _culprit(tokens: Sequence[bytes], convert: Callable[[bytes], object]) -> str:
    return next(_quoted(token) for token in tokens if not _is_good(token, convert))


def _is_good(token: bytes, convert: Callable[[bytes], object]) -> bool:
    try:
        convert(token)
    except (ValueError, OverflowError):
        return False
    return True


def _quoted(text: bytes) -> str:
    return repr(text[:24].decode("latin-1"))


def split_rows(lines: Sequence[bytes]) -> tuple[list[bytes], int | None]:
    """Split lines into words, with a mark before each line.

    Parameters
    ----------
    lines : sequence of bytes
        At least one line.

    Returns
    -------
    words : list of bytes
        The words of all lines, and the marks.
    width : int or None
        Words of each line with its mark, where all lines have the same number.
    """
    tokens = (b" | " + b" | ".join(lines)).split()
    width = len(lines[0].split()) + 1
    marks = tokens[::width]
    uniform = len(tokens) == width * len(lines) and marks.count(_MARK) == len(lines)
    return tokens, width if uniform else None


def coordinates(lines: Sequence[bytes]) -> FloatArray:
    """Read the first three numbers of each line, (n, 3); what follows them is left alone."""
    if not lines:
        return np.zeros((0, 3))
    tokens, width = split_rows(lines)
    if width is not None and width >= 4:
        return np.stack([floats(tokens[axis::width]) for axis in (1, 2, 3)], axis=1)
    rows = [line.split(maxsplit=3)[:3] for line in lines]
    short = next((line for line, row in zip(lines, rows, strict=True) if len(row) < 3), None)
    if short is not None:
        raise LoadError(f"a vertex has fewer than three coordinates: {_quoted(short)}")
    return floats([token for row in rows for token in row]).reshape(-1, 3)


def number_lists(lines: Sequence[bytes]) -> Lists:
    """Read all whole numbers of each line."""
    if not lines:
        return Lists.empty()
    tokens, width = split_rows(lines)
    if width is not None:
        del tokens[::width]
        sizes = np.full(len(lines), width - 1)
    else:
        marks = np.flatnonzero([token == _MARK for token in tokens])
        sizes = np.diff(marks, append=len(tokens)) - 1
        tokens = [token for token in tokens if token != _MARK]
    return Lists(sizes, integers(tokens))
