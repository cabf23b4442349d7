"""PLY: text and binary, further properties, polygons and strips, and headers that lie."""

import struct

import numpy as np
import pytest

from core.io import LoadError, load_mesh, read_mesh

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
HEAD = """ply
format ascii 1.0
element vertex {vertices}
property float x
property float y
property float z
element face {faces}
property list uchar int vertex_indices
end_header
"""
POINTS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"


def refused(path) -> str:
    with pytest.raises(LoadError) as caught:
        load_mesh(path)
    return str(caught.value)


def test_polygons_become_fans(write):
    result = read_mesh(write("quad.ply", HEAD.format(vertices=4, faces=1) + POINTS + "4 0 1 2 3\n"))
    assert result.mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert result.report == ("1 polygon triangulated",)


def test_faces_of_different_sizes(write):
    faces = "3 0 1 2\n4 0 1 2 3\n3 0 2 3\n"
    mesh = load_mesh(write("mixed.ply", HEAD.format(vertices=4, faces=3) + POINTS + faces))
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 1, 2], [0, 2, 3], [0, 2, 3]]


@pytest.mark.parametrize("order", ["<", ">"])
def test_binary_faces_of_different_sizes_with_further_properties(order, write):
    """Colours, a scalar before and a list after the corners, and an element nobody asked for."""
    name = "binary_little_endian" if order == "<" else "binary_big_endian"
    head = (
        f"ply\nformat {name} 1.0\nobj_info made by hand\nelement camera 1\nproperty double f\n"
        "element vertex 4\nproperty uchar red\nproperty double x\nproperty double y\n"
        "property short z\nproperty float quality\n"
        "element face 2\nproperty uchar flags\nproperty list ushort uint vertex_index\n"
        "property list uchar float texcoord\nend_header\n"
    ).encode()
    vertices = b"".join(struct.pack(f"{order}B2dhf", 9, x, y, z, 0.5) for x, y, z in SQUARE)
    triangle = struct.pack(f"{order}BH3IB6f", 1, 3, 0, 1, 2, 6, *range(6))
    quad = struct.pack(f"{order}BH4IB", 1, 4, 0, 1, 2, 3, 0)
    camera = struct.pack(f"{order}d", 50)
    mesh = load_mesh(write("rich.ply", head + camera + vertices + triangle + quad))
    assert mesh.vertices.tolist() == SQUARE
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 1, 2], [0, 2, 3]]


def test_strips_alternate_their_winding(write):
    head = HEAD.replace("element face", "element tristrips").replace("uchar", "int")
    points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n"
    content = head.format(vertices=5, faces=1) + points + "9 0 1 2 3 -1 2 3 4 4\n"
    result = read_mesh(write("strips.ply", content))
    assert result.mesh.faces.tolist() == [[0, 1, 2], [2, 1, 3], [2, 3, 4]]
    assert result.mesh.topology.is_consistently_wound
    assert result.report == ("2 triangle strips cut into 3 faces",)


def test_faces_and_strips_together(write):
    strips = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    head = HEAD.format(vertices=4, faces=1).replace("end_header\n", strips)
    mesh = load_mesh(write("both.ply", head + POINTS + "3 0 1 2\n3 0 2 3\n"))
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize("newline", ["\r\n", "\r"])
def test_lines_may_end_as_on_other_systems(newline, write):
    content = (HEAD.format(vertices=4, faces=1) + POINTS + "4 0 1 2 3\n").replace("\n", newline)
    assert len(load_mesh(write("other.ply", content)).faces) == 2


def test_binary_data_may_begin_with_a_newline_byte(write):
    """The header ends with one newline; the next byte, 10, belongs to the first number."""
    head = HEAD.format(vertices=3, faces=1).replace("ascii", "binary_little_endian")
    first = struct.unpack("<f", b"\n\0\0\x40")[0]
    numbers = struct.pack("<9fB3i", first, 0, 0, 5, 0, 0, 0, 5, 0, 3, 0, 1, 2)
    assert load_mesh(write("newline.ply", head.encode() + numbers)).vertices[0, 0] == first


def test_float32_coordinates_are_not_rounded_again(write):
    values = np.array([[0.1, 0.2, 0.3], [1.1, 0, 0], [0, 1.1, 0]], np.float32)
    head = HEAD.format(vertices=3, faces=1).replace("ascii", "binary_little_endian")
    path = write("f.ply", head.encode() + values.tobytes() + struct.pack("<B3i", 3, 0, 1, 2))
    assert np.array_equal(load_mesh(path).vertices, values.astype(np.float64))


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        (
            "element vertex 4",
            "element vertex 4000000000",
            "4,000,000,000 rows of 'vertex' announced",
        ),
        ("element face 1", "element face 4000000000", "4,000,000,000 rows of 'face' announced"),
        ("element vertex 4", "element vertex -4", "its header announces -4 rows"),
        ("element vertex 4", "element vertex four", "'four' is not a whole number"),
        ("4 0 1 2 3", "4000000000 0 1 2 3", "cut short in the middle of a list"),
        ("element face 1", "element face 2", "cut short in the middle of a list"),
        ("4 0 1 2 3", "-4 0 1 2 3", "a list announces -4 entries"),
        ("4 0 1 2 3", "4 0 1 2 4", "face 0 names vertex 4; allowed are 0 to 3"),
        ("4 0 1 2 3", "4 0 1 2 -1", "face 0 names vertex -1; allowed are 0 to 3"),
        ("4 0 1 2 3", "4 0 1 2 3.5", "'3.5' is not a whole number"),
        ("1 1 0", "1 nan 0", r"vertex 2 is \[1.0, nan, 0.0\]; coordinates must be finite"),
        ("1 1 0", "1 1e999 0", r"vertex 2 is \[1.0, inf, 0.0\]"),
        ("1 1 0", "1 one 0", "'one' is not a number"),
        ("4 0 1 2 3", "4 0 0 1 1", "none of its faces has three different corners"),
        ("element face 1", "element face 0", "it has no faces, only 4 points"),
        ("property float y\n", "", "its vertices have no x, y and z"),
        ("vertex_indices", "corners", "its element 'face' has no list of vertex_indices"),
        ("int vertex", "float vertex", "its element 'face' has no list of vertex_indices"),
        ("property float y", "property quaternion y", "a property of no known type"),
        ("property float y", "property y", "its header has a line that is not PLY: 'property y'"),
        ("format ascii", "format cuneiform", "its format is cuneiform; allowed are ascii"),
        ("element vertex 4", "element point 4", "its header declares no vertices"),
        ("element vertex 4", "elephant vertex 4", "its header has a line that is not PLY"),
        ("end_header", "", "its header has no end"),
        ("ply\n", "plywood\n", "it does not begin with the word 'ply'"),
    ],
)
def test_bad_files_are_refused(old, new, reason, write):
    content = HEAD.format(vertices=4, faces=1) + POINTS + "4 0 1 2 3\n"
    assert content.count(old) >= 1
    with pytest.raises(LoadError, match=reason):
        load_mesh(write("bad.ply", content.replace(old, new, 1)))


@pytest.mark.parametrize("element", [b"vertex 4", b"face 2"])
def test_a_binary_header_that_lies_is_refused_before_memory_is_asked_for(element, squares, write):
    lie = element.split()[0] + b" 4000000000"
    assert "announced" in refused(write("lie.ply", squares["little.ply"].replace(element, lie)))


def test_a_binary_list_that_lies_is_refused(squares, write):
    content = bytearray(squares["little.ply"])
    content[-26] = 200
    assert "cut short" in refused(write("list.ply", bytes(content)))
