"""Stanford PLY: text and binary of either byte order, with any further properties and elements.

An own reader, because others turn files of triangle strips into points without a word.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.io.errors import LoadError, quoted
from core.io.polygons import Lists, Polygons, cut_strips
from core.io.records import BinaryRecords, Element, Property, Records, TextRecords
from core.io.text import integers
from core.mesh import TriangleMesh

_CODES = ("i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8")
_OLD_NAMES = ("char", "uchar", "short", "ushort", "int", "uint", "float", "double")
_NEW_NAMES = ("int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64")
_TYPES = dict(zip(_OLD_NAMES + _NEW_NAMES, _CODES + _CODES, strict=True))
_ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}
_END = re.compile(rb"[\r\n]end_header[ \t]*(\r\n|\n|\r)")


class _Header(NamedTuple):
    encoding: str
    elements: tuple[Element, ...]
    end: int


def read_ply(path: Path) -> Polygons:
    """Read the vertices, polygons and triangle strips of a PLY file."""
    data = path.read_bytes()
    header = _header(data)
    records: Records
    if header.encoding == "ascii":
        records = TextRecords(data[header.end :])
    else:
        records = BinaryRecords(data, header.end)
    tables = {element.name: records.read(element, _wanted(element)) for element in header.elements}
    if "vertex" not in tables:
        raise LoadError("its header declares no vertices")
    vertices = np.stack([axis.items.astype(np.float64) for axis in tables["vertex"]], axis=1)
    faces = Lists.chain(tables.get("face", []))
    if not tables.get("tristrips"):
        return Polygons(vertices, faces)
    triangles, change = cut_strips(_separate(tables["tristrips"][0]))
    return Polygons(vertices, Lists.chain([faces, triangles]), (change,))


def _header(data: bytes) -> _Header:
    if not data.startswith((b"ply\n", b"ply\r", b"ply ")):
        raise LoadError("it does not begin with the word 'ply', so it is no PLY file")
    end = _END.search(data)
    if end is None:
        raise LoadError("the file is cut short: its header has no end")
    lines = [line.split() for line in data[: end.start()].decode("latin-1").splitlines()]
    encoding = next((line[1] for line in lines if line[:1] == ["format"] and line[1:]), "missing")
    if encoding not in _ORDERS:
        raise LoadError(f"its format is {encoding[:24]}; allowed are {', '.join(_ORDERS)}")
    return _Header(encoding, _elements(lines[1:], _ORDERS[encoding]), end.end())


def _elements(lines: Sequence[Sequence[str]], order: str) -> tuple[Element, ...]:
    tables: list[tuple[str, int, list[Property]]] = []
    for line in lines:
        match line:
            case ["format" | "comment" | "obj_info", *_] | []:
                pass
            case ["element", name, rows]:
                tables.append((name, _row_count(rows), []))
            case ["property", _, _, *_] if tables:
                tables[-1][2].append(_property(line[1:], order))
            case _:
                raise LoadError(f"its header has a line that is not PLY: {quoted(' '.join(line))}")
    return tuple(Element(name, rows, tuple(entries)) for name, rows, entries in tables)


def _row_count(word: str) -> int:
    rows = int(integers([word.encode()])[0])
    if rows < 0:
        raise LoadError(f"its header announces {rows} rows")
    return rows


def _property(words: Sequence[str], order: str) -> Property:
    *types, name = words
    numbers = [_TYPES.get(word) for word in types if word != "list"]
    if None in numbers or len(types) != (3 if types[:1] == ["list"] else 1):
        raise LoadError(f"its header has a property of no known type: {quoted(' '.join(words))}")
    *count, item = [np.dtype(f"{order}{number}") for number in numbers]
    return Property(name, item, *count)


def _wanted(element: Element) -> tuple[str, ...]:
    """Return the names of the entries that make up the mesh."""
    numbers = [entry.name for entry in element.properties if entry.count is None]
    lists = [
        entry.name
        for entry in element.properties
        if entry.count is not None and entry.item.kind in "iu"
    ]
    if element.name == "vertex":
        if not {"x", "y", "z"} <= set(numbers):
            raise LoadError("its vertices have no x, y and z")
        return ("x", "y", "z")
    if element.name in {"face", "tristrips"} and element.rows:
        named = [name for name in lists if name in {"vertex_indices", "vertex_index"}]
        if not named:
            raise LoadError(f"its element '{element.name}' has no list of vertex_indices")
        return (named[0],)
    return ()


def _separate(strips: Lists) -> Lists:
    """Cut strips at the separators −1."""
    items = strips.items.astype(np.int64)
    strip = np.repeat(np.arange(len(strips.sizes)), strips.sizes) + np.cumsum(items < 0)
    _, sizes = np.unique(strip[items >= 0], return_counts=True)
    return Lists(sizes, items[items >= 0])


def write_ply(mesh: TriangleMesh) -> bytes:
    """Return a mesh as binary little-endian PLY with float64 coordinates: none is rounded."""
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(mesh.vertices)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(mesh.faces)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    faces = np.zeros(len(mesh.faces), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, mesh.faces
    return header.encode() + mesh.vertices.astype("<f8").tobytes() + faces.tobytes()
