"""3MF: a zip archive of XML parts with meshes, components made of them, and a build plate.

The reader takes the numbers as the parser meets them and builds no tree, so a large model costs
little more than its arrays.
"""

import io
import re
import zlib
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias
from xml.etree.ElementTree import ParseError, XMLParser
from zipfile import ZIP_DEFLATED, ZIP_STORED, BadZipFile, ZipFile, ZipInfo

import numpy as np

from core.arrays import FloatArray
from core.io.errors import LoadError, quoted
from core.io.parts import Part, join_parts
from core.io.polygons import Polygons

# Text of numbers shrinks 5 to 30 times; an archive that grows more than this is a trap.
_LARGEST_GROWTH = 200
_SMALLEST_LIMIT = 1 << 20
_DEEPEST = 32


@dataclass
class _Use:
    """A component or a build item: an object by its part and number, and where it stands."""

    key: tuple[str, str]
    matrix: FloatArray


@dataclass
class _Object:
    """A mesh, or the uses of other objects it is made of."""

    coordinates: "array[float]" = field(default_factory=lambda: array("d"))
    corners: "array[int]" = field(default_factory=lambda: array("q"))
    uses: list[_Use] = field(default_factory=list)


_Objects: TypeAlias = dict[tuple[str, str], _Object]


class _Collector:
    """Target of the XML parser for one model part: fills objects and the build."""

    def __init__(self, part: str) -> None:
        self._part = part
        self._current = _Object()
        self.objects: _Objects = {}
        self.build: list[_Use] = []

    def doctype(self, *_: object) -> None:
        """Refuse what 3MF forbids: its entities could make much out of little."""
        raise LoadError("its XML declares a document type, which 3MF does not allow")

    def start(self, tag: str, given: dict[str, str]) -> None:
        """Take what an opening tag says."""
        match tag.rpartition("}")[2]:
            case "vertex":
                x, y, z = given["x"], given["y"], given["z"]
                self._current.coordinates.extend((float(x), float(y), float(z)))
            case "triangle":
                a, b, c = given["v1"], given["v2"], given["v3"]
                self._current.corners.extend((int(a), int(b), int(c)))
            case "object":
                self._current = self.objects[self._part, given["id"]] = _Object()
            case "component":
                self._current.uses.append(self._use(given))
            case "item":
                self.build.append(self._use(given))

    def _use(self, given: dict[str, str]) -> _Use:
        """The part is this one unless an attribute ``path`` of any namespace names another."""
        paths = [value for name, value in given.items() if name.endswith("}path")]
        part = paths[0].lstrip("/") if paths else self._part
        return _Use((part, given["objectid"]), _matrix(given.get("transform", "")))


def _matrix(text: str) -> FloatArray:
    """Twelve numbers, four rows of three, acting on row vectors."""
    matrix = np.eye(4)
    if text:
        matrix[:3] = np.array(text.split(), np.float64).reshape(4, 3).T
    return matrix


def read_3mf(path: Path) -> Polygons:
    """Read the objects on the build plate of a 3MF file."""
    # From memory, because a read that an archive makes a gigabyte long ends where the bytes do.
    data = path.read_bytes()
    size = len(data)
    limit = max(_LARGEST_GROWTH * size, _SMALLEST_LIMIT)
    try:
        with ZipFile(io.BytesIO(data)) as archive:
            objects, build = _models(archive, limit)
    except (BadZipFile, EOFError, zlib.error) as error:
        raise LoadError("it is no 3MF file or cut short (not a whole zip archive)") from error
    except ParseError as error:
        raise LoadError(f"its model is not whole XML ({error})") from error
    except KeyError as error:
        raise LoadError(f"an element of its model has no attribute {error}") from error
    return join_parts(_parts(objects, build, np.eye(4), 0), file_size=size)


def _models(archive: ZipFile, limit: int) -> tuple[_Objects, list[_Use]]:
    """Read all model parts of the archive; the build is that of the main one."""
    names = [name for name in dict.fromkeys(archive.namelist()) if name.endswith(".model")]
    if not names:
        raise LoadError("its archive holds no model")
    _check_members([archive.getinfo(name) for name in [*names, *_relations(archive)]], limit)
    collectors = {name: _collect(archive, name) for name in names}
    objects = {key: item for each in collectors.values() for key, item in each.objects.items()}
    return objects, collectors[_main(archive, names)].build


def _check_members(members: list[ZipInfo], limit: int) -> None:
    """Refuse what would take memory before a single number is read."""
    # Other ways to pack are not 3MF's, and may take a gigabyte for a few bytes.
    if any(member.compress_type not in (ZIP_STORED, ZIP_DEFLATED) for member in members):
        raise LoadError("its archive is packed in a way that 3MF does not allow")
    # Nobody unpacks more than the sizes that the archive states, so they may be trusted here.
    if sum(member.file_size for member in members) > limit:
        raise LoadError("it unpacks to far more than a model of its size can hold")


def _relations(archive: ZipFile) -> list[str]:
    return [name for name in archive.namelist() if name == "_rels/.rels"]


def _main(archive: ZipFile, names: list[str]) -> str:
    """Name of the model part that the archive's relations point to."""
    relations = b"".join(archive.read(name) for name in _relations(archive)).decode("latin-1")
    targets = re.findall(r'Target\s*=\s*"/?([^"]+\.model)"', relations)
    return next((target for target in targets if target in names), names[0])


def _collect(archive: ZipFile, name: str) -> _Collector:
    collector = _Collector(name)
    parser = XMLParser(target=collector)
    with archive.open(name) as stream:
        while block := stream.read(1 << 16):
            parser.feed(block)
    parser.close()
    return collector


def _parts(objects: _Objects, uses: list[_Use], matrix: FloatArray, depth: int) -> Iterator[Part]:
    """Walk down the components; every use gives a part, so that whoever counts can stop."""
    if depth > _DEEPEST:
        raise LoadError(f"its components are nested more than {_DEEPEST} deep")
    for use in uses:
        if use.key not in objects:
            part, number = use.key
            raise LoadError(f"it uses object {quoted(number)}, which is not in {part[:80]}")
        item, placed = objects[use.key], matrix @ use.matrix
        vertices, corners = np.frombuffer(item.coordinates), np.frombuffer(item.corners, np.int64)
        yield Part(vertices.reshape(-1, 3), corners.reshape(-1, 3), placed)
        yield from _parts(objects, item.uses, placed, depth + 1)
