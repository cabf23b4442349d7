"""Tables of records as PLY and binary OFF store them: rows of numbers and of lists of numbers.

Nearly every file has the same list lengths in all rows (three corners a face): such a table is
mapped at once. Only a table with mixed lengths is walked row by row.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.io.errors import LoadError
from core.io.polygons import Lists
from core.io.text import floats, integers


@dataclass(frozen=True)
class Property:
    """One entry of a record.

    Attributes
    ----------
    name : str
        Its name in the file.
    item : numpy dtype
        Type of the number, or of the numbers in the list.
    count : numpy dtype or None
        Type of the list's length; None where the entry is a single number.
    """

    name: str
    item: np.dtype[Any]
    count: np.dtype[Any] | None = None


@dataclass(frozen=True)
class Element:
    """A table: its name, its number of rows and the entries of each row."""

    name: str
    rows: int
    properties: tuple[Property, ...]


class Records(ABC):
    """A stream of tables, read one after the other from `position` on."""

    def __init__(self, data: Sequence[Any], position: int) -> None:
        self._data = data
        self._position = position

    def read(self, element: Element, wanted: tuple[str, ...]) -> list[Lists]:
        """Read the next table and return the wanted entries; a single number is a list of one."""
        if not element.rows or not element.properties:
            return [Lists.empty() for _ in wanted]
        self._check_size(element)
        start = self._position
        lengths = [self._take(entry)[0] for entry in element.properties]
        self._position = start
        table = self._uniform(element, lengths, wanted)
        return self._ragged(element, wanted) if table is None else table

    def _check_size(self, element: Element) -> None:
        """Compare the announced rows with the rest of the file before memory is asked for."""
        least = sum(self._width(entry, 0 if entry.count else 1) for entry in element.properties)
        rows = (len(self._data) - self._position) // least
        if element.rows > rows:
            raise LoadError(
                f"the file is cut short: {element.rows:,} rows of '{element.name}' announced, "
                f"room for {rows:,} at most"
            )

    def _ragged(self, element: Element, wanted: tuple[str, ...]) -> list[Lists]:
        taken: dict[str, list[tuple[int, Any]]] = {name: [] for name in wanted}
        for _ in range(element.rows):
            for entry in element.properties:
                cell = self._take(entry)
                if entry.name in taken:
                    taken[entry.name].append(cell)
        types = {entry.name: entry.item for entry in element.properties}
        return [self._join(types[name], taken[name]) for name in wanted]

    def _advance(self, width: int) -> Any:
        """Return the next bytes or words."""
        start, self._position = self._position, self._position + width
        if self._position > len(self._data):
            raise LoadError("the file is cut short in the middle of a list")
        return self._data[start : self._position]

    @abstractmethod
    def _width(self, entry: Property, length: int) -> int:
        """Bytes or words that an entry takes, with its list's length."""

    @abstractmethod
    def _take(self, entry: Property) -> tuple[int, Any]:
        """Take the next entry: the length of its list (1 for a number), and its bytes or words."""

    @abstractmethod
    def _join(self, item: np.dtype[Any], cells: list[tuple[int, Any]]) -> Lists:
        """Turn what `_take` gave for one property in all rows into numbers."""

    @abstractmethod
    def _uniform(
        self, element: Element, lengths: list[int], wanted: tuple[str, ...]
    ) -> list[Lists] | None:
        """Read all rows at once if each has lists of the given lengths; otherwise None."""


class BinaryRecords(Records):
    """Tables in the bytes of a binary file; the types of the properties carry the byte order."""

    _data: bytes

    def _width(self, entry: Property, length: int) -> int:
        return length * entry.item.itemsize + (entry.count.itemsize if entry.count else 0)

    def _take(self, entry: Property) -> tuple[int, bytes]:
        length = 1
        if entry.count is not None:
            length = int(np.frombuffer(self._advance(entry.count.itemsize), entry.count)[0])
        if length < 0:
            raise LoadError(f"a list announces {length} entries")
        return length, self._advance(length * entry.item.itemsize)

    def _join(self, item: np.dtype[Any], cells: list[tuple[int, bytes]]) -> Lists:
        sizes = np.array([length for length, _ in cells], np.int64)
        return Lists(sizes, np.frombuffer(b"".join(piece for _, piece in cells), item))

    def _uniform(
        self, element: Element, lengths: list[int], wanted: tuple[str, ...]
    ) -> list[Lists] | None:
        dtype = np.dtype(list(_fields(element.properties, lengths)))
        if self._position + dtype.itemsize * element.rows > len(self._data):
            return None
        table = np.frombuffer(self._data, dtype, element.rows, self._position)
        for entry, length in zip(element.properties, lengths, strict=True):
            if entry.count and (table[f"length of {entry.name}"] != length).any():
                return None
        self._position += table.nbytes
        return [Lists.of_rows(table[name]) for name in wanted]


def _fields(properties: Sequence[Property], lengths: Sequence[int]) -> Any:
    for entry, length in zip(properties, lengths, strict=True):
        if entry.count:
            yield f"length of {entry.name}", entry.count
        yield entry.name, entry.item, (length,)


class TextRecords(Records):
    """Tables in the words of a text file."""

    _data: list[bytes]

    def __init__(self, text: bytes) -> None:
        super().__init__(text.split(), 0)

    def _width(self, entry: Property, length: int) -> int:
        return length + (1 if entry.count else 0)

    def _take(self, entry: Property) -> tuple[int, list[bytes]]:
        length = int(integers(self._advance(1))[0]) if entry.count else 1
        if length < 0:
            raise LoadError(f"a list announces {length} entries")
        return length, self._advance(length)

    def _join(self, item: np.dtype[Any], cells: list[tuple[int, list[bytes]]]) -> Lists:
        sizes = np.array([length for length, _ in cells], np.int64)
        return Lists(sizes, _numbers(item, [word for _, words in cells for word in words]))

    def _uniform(
        self, element: Element, lengths: list[int], wanted: tuple[str, ...]
    ) -> list[Lists] | None:
        width = sum(map(self._width, element.properties, lengths))
        block = self._data[self._position : self._position + width * element.rows]
        if len(block) < width * element.rows:
            return None
        columns, at = {}, 0
        for entry, length in zip(element.properties, lengths, strict=True):
            if entry.count and block[at::width].count(block[at]) < element.rows:
                return None
            at += self._width(entry, length)
            columns[entry.name] = entry.item, range(at - length, at)
        self._position += len(block)
        return [_table(block, width, *columns[name]) for name in wanted]


def _table(block: list[bytes], width: int, item: np.dtype[Any], columns: range) -> Lists:
    empty = np.zeros((len(block) // width, 0), item)
    columns_read = [_numbers(item, block[column::width])[:, None] for column in columns]
    return Lists.of_rows(np.concatenate([empty, *columns_read], axis=1))


def _numbers(item: np.dtype[Any], words: Sequence[bytes]) -> NDArray[Any]:
    return floats(words) if item.kind == "f" else integers(words)
