"""Fixtures for the file tests."""

import io
import json
import re
import signal
import struct
import tracemalloc
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from core.io import LoadError, load_mesh

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float64)

Write = Callable[[str, str | bytes], Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Write a file and return its path."""

    def write_file(name: str, content: str | bytes) -> Path:
        path = tmp_path / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return write_file


def gltf_tree(**changes: object) -> dict[str, object]:
    """Description of one square, two triangles, with its numbers in one buffer of 60 bytes."""
    tree: dict[str, object] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 12},
        ],
        "buffers": [{"byteLength": 60}],
    }
    return {**tree, **changes}


GLTF_NUMBERS = SQUARE.astype("<f4").tobytes() + np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()


def glb(tree: dict[str, object], numbers: bytes = GLTF_NUMBERS) -> bytes:
    """Pack a description and its numbers as GLB."""
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(numbers)
    head = struct.pack("<4sII", b"glTF", 2, size) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(numbers), b"BIN\0") + numbers


SQUARE_3MF = """<mesh><vertices>
<vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="1" y="1" z="0"/>
<vertex x="0" y="1" z="0"/></vertices><triangles>
<triangle v1="0" v2="1" v3="2"/><triangle v1="0" v2="2" v3="3"/></triangles></mesh>"""


def model_3mf(resources: str, build: str) -> str:
    """XML of a model part."""
    core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
    return (
        f'<?xml version="1.0"?><model unit="millimeter" xmlns="{core}" xmlns:p="{production}">'
        f"<resources>{resources}</resources><build>{build}</build></model>"
    )


def archive_3mf(model: str, **others: str) -> bytes:
    """Pack a model part, and other parts by name, as 3MF."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in others.items():
            archive.writestr(f"3D/{name}.model", text)
        archive.writestr("3D/3dmodel.model", model)
        archive.writestr(
            "_rels/.rels",
            '<Relationships><Relationship Target="/3D/3dmodel.model"/></Relationships>',
        )
    return buffer.getvalue()


VTK = """# vtk DataFile Version 3.0
a square
ASCII
DATASET POLYDATA
POINTS 4 float
0 0 0 1 0 0 1 1 0 0 1 0
POLYGONS 1 5
4 0 1 2 3
"""

VTP = """<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0"
NumberOfPolys="1"><Points>
<DataArray type="Float32" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""

ASCII_STL = """solid square
facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 1 0 0
  vertex 1 1 0
 endloop
endfacet
facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 1 1 0
  vertex 0 1 0
 endloop
endfacet
endsolid square
"""

PLY_HEAD = """ply
format {encoding} 1.0
comment a square
element vertex 4
property float x
property float y
property float z
element face {faces}
property list uchar int vertex_indices
end_header
"""


def binary_ply(order: str) -> bytes:
    """Return a square of two triangles; `order` is ``<`` or ``>``."""
    encoding = "binary_little_endian" if order == "<" else "binary_big_endian"
    faces = struct.pack(f"{order}B3iB3i", 3, 0, 1, 2, 3, 0, 2, 3)
    head = PLY_HEAD.format(encoding=encoding, faces=2).encode()
    return head + SQUARE.astype(f"{order}f4").tobytes() + faces


def binary_stl() -> bytes:
    """Return a square of two triangles."""
    corners = SQUARE[[[0, 1, 2], [0, 2, 3]]].astype("<f4")
    facets = b"".join(bytes(12) + triangle.tobytes() + bytes(2) for triangle in corners)
    return b"solid but binary".ljust(80) + struct.pack("<I", 2) + facets


def binary_off() -> bytes:
    """Return a square of two triangles; the second has a colour."""
    faces = struct.pack(">5i", 3, 0, 1, 2, 0) + struct.pack(">5i3f", 3, 0, 2, 3, 3, 1, 0, 0)
    counts = struct.pack(">3i", 4, 2, 0)
    return b"OFF BINARY\n" + counts + SQUARE.astype(">f4").tobytes() + faces


@pytest.fixture(scope="session")
def squares() -> dict[str, bytes]:
    """The unit square as two triangles or one quad, in every format that is read."""
    vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    texts = {
        "text.ply": PLY_HEAD.format(encoding="ascii", faces=1) + vertices + "4 0 1 2 3\n",
        "text.obj": "v " + vertices.strip().replace("\n", "\nv ") + "\nf 1/1/1 2/2/1 3/3/1 4/4/1\n",
        "text.off": "OFF\n4 2 0\n" + vertices + "3 0 1 2\n3 0 2 3\n",
        "text.stl": ASCII_STL,
        "old.vtk": VTK,
        "new.vtp": VTP,
    }
    model = model_3mf(f'<object id="7">{SQUARE_3MF}</object>', '<item objectid="7"/>')
    return {
        **{name: text.encode() for name, text in texts.items()},
        "little.ply": binary_ply("<"),
        "big.ply": binary_ply(">"),
        "binary.off": binary_off(),
        "binary.stl": binary_stl(),
        "binary.glb": glb(gltf_tree()),
        "archive.3mf": archive_3mf(model),
    }


@pytest.fixture(scope="session")
def describe_gltf() -> Callable[..., dict[str, object]]:
    """Describe the square as glTF; keywords replace parts of the description."""
    return gltf_tree


@pytest.fixture(scope="session")
def gltf_numbers() -> bytes:
    """Positions and vertex numbers that the description refers to."""
    return GLTF_NUMBERS


@pytest.fixture(scope="session")
def make_glb() -> Callable[..., bytes]:
    """Pack the square as GLB; keywords replace parts of its description."""
    return lambda numbers=GLTF_NUMBERS, **changes: glb(gltf_tree(**changes), numbers)


@pytest.fixture(scope="session")
def make_3mf() -> Callable[..., bytes]:
    """Pack resources and a build as 3MF; ``{square}`` stands for the square's mesh.

    Further parts are given by name.
    """

    def make(resources: str, build: str, **others: str) -> bytes:
        parts = {
            name: model_3mf(text.format(square=SQUARE_3MF), "") for name, text in others.items()
        }
        return archive_3mf(model_3mf(resources.format(square=SQUARE_3MF), build), **parts)

    return make


# Reading may take this much besides the file itself: numbers become float64 and int64, text
# becomes words, a scene is built of Python objects.
_BYTES, _BYTES_A_BYTE = 3 << 20, 300
_SECONDS = 10


class _TooSlow(BaseException):
    """Not an Exception, so that no reader can take it for its own."""


def _stop(*_: object) -> None:
    raise _TooSlow


@pytest.fixture
def attempt(tmp_path: Path) -> Iterator[Callable[[str, bytes], str]]:
    """Read a file that may be anything, within bounds of time and memory.

    Returns what was said about it, one sentence, or nothing where a mesh came out.
    """

    def read(name: str, content: bytes) -> str:
        path = tmp_path / name
        path.write_bytes(content)
        tracemalloc.reset_peak()
        before = tracemalloc.get_traced_memory()[1]
        signal.setitimer(signal.ITIMER_REAL, _SECONDS)
        try:
            sentence = _outcome(path)
        except BaseException:
            (tmp_path / "culprit").write_bytes(content)
            raise
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
        taken = tracemalloc.get_traced_memory()[1] - before
        assert taken < _BYTES + _BYTES_A_BYTE * len(content), f"{name}: {taken:,} bytes"
        return sentence

    (tmp_path / "first.glb").write_bytes(glb(gltf_tree()))
    load_mesh(tmp_path / "first.glb")  # loads libraries, whose memory is not the file's
    usual = signal.signal(signal.SIGALRM, _stop)
    tracemalloc.start()
    yield read
    tracemalloc.stop()
    signal.signal(signal.SIGALRM, usual)


def _outcome(path: Path) -> str:
    try:
        mesh = load_mesh(path)
    except LoadError as error:
        sentence, cause = str(error), error.__cause__
    else:
        sentence, cause = "", None
    assert not isinstance(cause, Warning), sentence
    if sentence:
        assert re.fullmatch(rf"{re.escape(path.name)}: [^\n]{{3,230}}\.", sentence), sentence
        return sentence
    assert len(mesh.faces)
    assert np.isfinite(mesh.vertices).all()
    assert mesh.faces.min() >= 0
    assert mesh.faces.max() < len(mesh.vertices)
    return ""
