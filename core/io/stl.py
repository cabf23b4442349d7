"""STL: triangles without common vertices, as text or binary.

Corners at exactly equal places become one vertex; nearly equal ones stay apart. Vertices are
numbered in the order in which they first appear.
"""

import re
from pathlib import Path

import numpy as np

from core.arrays import FloatArray
from core.io.errors import LoadError, SaveError
from core.io.merging import merge_equal
from core.io.polygons import Lists, Polygons, counted
from core.io.text import coordinates
from core.mesh import TriangleMesh
from core.mesh.geometry import face_normals

_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEAD = 84
# Searched for in small letters; a line is not the first one, which begins with "solid".
_CORNER = re.compile(rb"\n[ \t]*vertex[ \t]([^\n]*)")
_END_FACET = re.compile(rb"\n[ \t]*endfacet")
_END_SOLID = re.compile(rb"\n[ \t]*endsolid")


def read_stl(path: Path) -> Polygons:
    """Read the triangles of an STL file and join corners at equal places."""
    data = path.read_bytes()
    corners, changes = _text(data) if _is_text(data) else (_binary(data), ())
    vertices, faces = merge_equal(corners)
    merged = f"{counted(len(corners), 'corner')} merged into {len(vertices):,} vertices"
    return Polygons(vertices, Lists.of_rows(faces.reshape(-1, 3)), (*changes, merged))


def _is_text(data: bytes) -> bool:
    """Tell text from binary by the size, because binary files may begin with "solid" too."""
    if len(data) >= _HEAD and len(data) == _binary_size(data):
        return False
    return data.lstrip()[:5].lower() == b"solid" and b"\0" not in data


def _binary_size(data: bytes) -> int:
    return _HEAD + _FACET.itemsize * int.from_bytes(data[80:_HEAD], "little")


def _binary(data: bytes) -> FloatArray:
    if len(data) < _HEAD:
        raise LoadError("it is neither a text STL (no 'solid') nor as long as a binary one's head")
    facets = int.from_bytes(data[80:_HEAD], "little")
    if len(data) < _binary_size(data):
        room = (len(data) - _HEAD) // _FACET.itemsize
        raise LoadError(
            f"it is no STL file or cut short: {facets:,} faces announced, room for {room:,}"
        )
    return np.frombuffer(data, _FACET, facets, _HEAD)["corners"].reshape(-1, 3).astype(np.float64)


def _text(data: bytes) -> tuple[FloatArray, tuple[str, ...]]:
    data = data.lower().replace(b"\r", b"\n")
    corners, facets = _CORNER.findall(data), len(_END_FACET.findall(data))
    solids = len(_END_SOLID.findall(data))
    if not solids or len(corners) < 3 * facets:
        raise LoadError("the file is cut short: its last solid has no end")
    if len(corners) != 3 * facets:
        raise LoadError(f"it has {len(corners)} corners for {facets} faces; allowed are three each")
    joined = (f"{solids:,} solids joined",) if solids > 1 else ()
    return coordinates(corners), joined


def write_stl(mesh: TriangleMesh) -> bytes:
    """Return a mesh as binary STL; it has only float32 coordinates."""
    with np.errstate(over="ignore"):
        corners = mesh.vertices.astype(np.float32)[mesh.faces]
    if not np.isfinite(corners).all():
        raise SaveError("STL has 32-bit coordinates, and some are too large for that")
    facets = np.zeros(len(mesh.faces), _FACET)
    facets["normal"], facets["corners"] = face_normals(mesh), corners
    head = b"Burnish".ljust(80) + len(mesh.faces).to_bytes(4, "little")
    return head + facets.tobytes()
