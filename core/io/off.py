"""Object File Format: OFF, COFF, NOFF, STOFF and their combinations, as text or ``OFF BINARY``.

An own reader, because others fail on polygons and on the binary form.
"""

import re
from pathlib import Path

import numpy as np

from core.io.errors import LoadError
from core.io.polygons import Lists, Numbers, Polygons
from core.io.records import BinaryRecords, Element, Property
from core.io.text import coordinates, integers, whole_rows
from core.mesh import TriangleMesh

# Texture coordinates, colours and normals may stand before the word; 4 and n mean that the
# vertices have not three coordinates.
_WORD = re.compile(rb"\s*(ST)?(C)?(N)?(4)?(n)?OFF\b[^\S\n]*(BINARY\b[^\n]*\n)?")
_COMMENT = re.compile(rb"#[^\n]*")


def read_off(path: Path) -> Polygons:
    """Read the vertices and polygons of an OFF file."""
    data = path.read_bytes()
    start = _COMMENT.sub(b"", data[:65536])
    word = _WORD.match(start)
    if word is None and not re.match(rb"\s*\d+\s+\d+", start):
        raise LoadError("it does not begin with the word OFF, so it is no OFF file")
    if word and (word[4] or word[5]):
        raise LoadError("its vertices have not three coordinates (4OFF or nOFF)")
    if word and word[6]:
        return _binary(data, data.index(b"\n", data.index(b"BINARY")) + 1, word)
    return _text(data)


def _text(data: bytes) -> Polygons:
    text = _COMMENT.sub(b"", data.replace(b"\r", b"\n"))
    text = re.sub(rb"^\s*[A-Z]*OFF\b", b"", text)
    lines = [line for line in text.split(b"\n") if line and not line.isspace()]
    counts = integers(lines[0].split()[:3] if lines else [])
    if len(counts) < 2 or counts.min() < 0:
        raise LoadError("it does not say how many vertices and faces it has")
    vertex_count, face_count = int(counts[0]), int(counts[1])
    need = vertex_count + face_count
    if len(lines) - 1 < need:
        raise LoadError(
            f"the file is cut short: {need:,} lines of vertices and faces announced, "
            f"{len(lines) - 1:,} there"
        )
    vertices = coordinates(lines[1 : 1 + vertex_count])
    return Polygons(vertices, _faces(lines[1 + vertex_count : 1 + need]))


def _faces(lines: list[bytes]) -> Lists:
    """Read "k v₁ … vₖ" from each line; a colour may follow."""
    if not lines:
        return Lists.empty()
    rows = whole_rows(lines)
    if rows is not None and (rows[:, 0] == rows[0, 0]).all():
        return _equal_faces(rows)
    table = [line.split() for line in lines]
    sizes = integers([row[0] for row in table])
    if sizes.size and sizes.min() < 0:
        raise LoadError(f"a face announces {sizes.min()} corners")
    faces = [row[1 : size + 1] for row, size in zip(table, sizes.tolist(), strict=True)]
    broken = next((i for i, face in enumerate(faces) if len(face) < sizes[i]), None)
    if broken is not None:
        raise LoadError(f"face {broken} is cut short: {sizes[broken]} corners announced")
    return Lists(sizes, integers([word for face in faces for word in face]))


def _equal_faces(rows: Numbers) -> Lists:
    """Take faces that all have the same number of corners."""
    size, room = int(rows[0, 0]), rows.shape[1] - 1
    if not 0 < size <= room:
        raise LoadError(f"a face announces {size} corners and has {room}")
    return Lists.of_rows(rows[:, 1 : 1 + size])


def _binary(data: bytes, start: int, word: re.Match[bytes]) -> Polygons:
    """Read big-endian counts, positions with their extras, and faces with their colours."""
    if len(data) < start + 12:
        raise LoadError("the file is cut short: it ends before its counts")
    counts = np.frombuffer(data, ">i4", 3, start)
    if counts.min() < 0:
        raise LoadError("it does not say how many vertices and faces it has")
    extras = 2 * bool(word[1]) + 4 * bool(word[2]) + 3 * bool(word[3])
    columns = tuple(Property(f"{i}", np.dtype(">f4")) for i in range(3 + extras))
    lists = (
        Property("corners", np.dtype(">i4"), np.dtype(">i4")),
        Property("colour", np.dtype(">f4"), np.dtype(">i4")),
    )
    records = BinaryRecords(data, start + 12)
    vertices = records.read(Element("vertex", int(counts[0]), columns), ("0", "1", "2"))
    faces = records.read(Element("face", int(counts[1]), lists), ("corners",))
    positions = np.stack([column.items.astype(np.float64) for column in vertices], axis=1)
    return Polygons(positions, faces[0])


def write_off(mesh: TriangleMesh) -> bytes:
    """Return a mesh as text OFF; each number has the digits that give the same float64 back."""
    head = f"OFF\n{len(mesh.vertices)} {len(mesh.faces)} 0\n"
    vertices = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in mesh.vertices.tolist())
    faces = "".join(f"3 {i} {j} {k}\n" for i, j, k in mesh.faces.tolist())
    return (head + vertices + faces).encode("ascii")
