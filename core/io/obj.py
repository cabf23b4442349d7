"""Wavefront OBJ: the lines ``v`` and ``f``; normals, texture coordinates and groups are left alone.

An own reader, because others split vertices at texture seams or renumber them: here the vertices
are exactly the ``v`` lines of the file.
"""

import re
from pathlib import Path

import numpy as np

from core.io.errors import LoadError
from core.io.polygons import Lists, Polygons
from core.io.text import coordinates, number_lists
from core.mesh import TriangleMesh

# The end of a line is left out, so a key alone on its line gives an empty row and not the next one.
# A pattern that begins with a plain character is found twice as fast as one that begins with ^.
_VERTEX = re.compile(rb"\n[^\S\n]*v(?!\S)([^\n]*)")
_FACE = re.compile(rb"\n[^\S\n]*f(?!\S)([^\n]*)")
_CONTINUED = re.compile(rb"\\[^\S\n]*\n")
_AFTER_FIRST_NUMBER = re.compile(rb"/\S*|#.*")


def read_obj(path: Path) -> Polygons:
    """Read the vertices and polygons of an OBJ file."""
    data = b"\n" + path.read_bytes().replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    text = _CONTINUED.sub(b" ", data)
    vertex_lines, face_lines = _VERTEX.findall(text), _FACE.findall(text)
    if not vertex_lines and not face_lines:
        raise LoadError("it has no line that begins with 'v' or 'f', so it is no OBJ file")
    faces = number_lists(_without_slashes(face_lines))
    if len(faces.sizes) and faces.sizes[-1] < 3 and not data.endswith(b"\n"):
        raise LoadError("the file is cut short: its last face has fewer than three corners")
    return Polygons(coordinates(vertex_lines), _from_zero(faces, text), first_number=1)


def _without_slashes(lines: list[bytes]) -> list[bytes]:
    """Keep the first number of corners such as 3/1/2 and 3//2; drop comments after the numbers."""
    text = b"\n".join(lines)
    if b"/" in text or b"#" in text:
        return _AFTER_FIRST_NUMBER.sub(b"", text).split(b"\n")
    return lines


def _from_zero(faces: Lists, text: bytes) -> Lists:
    """Count from 0; a negative number counts back from the last vertex before its face."""
    numbers = faces.items.astype(np.int64)
    if numbers.size and numbers.min() < 0:
        vertex_places = [match.start() for match in _VERTEX.finditer(text)]
        face_places = [match.start() for match in _FACE.finditer(text)]
        seen = np.repeat(np.searchsorted(vertex_places, face_places), faces.sizes)
        numbers = np.where(numbers < 0, numbers + seen + 1, numbers)
    return Lists(faces.sizes, numbers - 1)


def write_obj(mesh: TriangleMesh) -> bytes:
    """Return a mesh as OBJ; each number has the digits that give the same float64 back."""
    vertices = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in mesh.vertices.tolist())
    faces = "".join(f"f {i} {j} {k}\n" for i, j, k in (mesh.faces + 1).tolist())
    return (vertices + faces).encode("ascii")
