"""Numbers out of text files, a whole block of lines at a time."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.io.errors import LoadError, quoted
from core.io.polygons import Lists

# Up to here a float64 holds every whole number.
_LARGEST_EXACT = 2.0**53


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
    return quoted(text.decode("latin-1"))


def number_rows(lines: Sequence[bytes]) -> FloatArray | None:
    """Read lines that have equally many numbers each, (n, k), by numpy's compiled reader.

    None for all other lines, which the functions below take word by word; they know, too, what to
    say about a word that is no number.
    """
    if not lines or not lines[0].strip():
        return None
    try:
        rows: FloatArray = np.loadtxt(lines, np.float64, comments=None, ndmin=2)
    except ValueError:
        return None
    return rows if len(rows) == len(lines) else None


def whole_rows(lines: Sequence[bytes]) -> NDArray[np.int64] | None:
    """Read lines as :func:`number_rows` where all of their numbers are whole."""
    rows = number_rows(lines)
    if rows is None or not (np.abs(rows) <= _LARGEST_EXACT).all():
        return None
    whole = rows.astype(np.int64)
    return whole if (whole == rows).all() else None


def coordinates(lines: Sequence[bytes]) -> FloatArray:
    """Read the first three numbers of each line, (n, 3); what follows them is left alone."""
    if not lines:
        return np.zeros((0, 3))
    table = number_rows(lines)
    if table is not None and table.shape[1] >= 3:
        return np.ascontiguousarray(table[:, :3])
    rows = [line.split(maxsplit=3)[:3] for line in lines]
    short = next((line for line, row in zip(lines, rows, strict=True) if len(row) < 3), None)
    if short is not None:
        raise LoadError(f"a vertex has fewer than three coordinates: {_quoted(short)}")
    return floats([token for row in rows for token in row]).reshape(-1, 3)


def number_lists(lines: Sequence[bytes]) -> Lists:
    """Read all whole numbers of each line."""
    if not lines:
        return Lists.empty()
    table = whole_rows(lines)
    if table is not None:
        return Lists.of_rows(table)
    rows = [line.split() for line in lines]
    sizes = np.array([len(row) for row in rows])
    return Lists(sizes, integers([word for row in rows for word in row]))
