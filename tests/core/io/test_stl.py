"""STL: corners at equal places become one vertex."""

import struct

import numpy as np
import pytest

from core.io import LoadError, SaveError, load_mesh, read_mesh, save_mesh
from core.io.merging import merge_equal
from core.mesh import TriangleMesh


def test_equal_corners_are_merged_in_the_order_of_their_first_appearance(squares, write):
    for name in ("text.stl", "binary.stl"):
        result = read_mesh(write(name, squares[name]))
        assert result.mesh.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        assert result.report == ("6 corners merged into 4 vertices",)


def test_nearly_equal_corners_stay_apart(squares, write):
    content = squares["text.stl"].replace(b"vertex 0 1 0", b"vertex 1e-12 0 0")
    assert len(load_mesh(write("near.stl", content)).vertices) == 4


def test_minus_zero_is_zero():
    vertices, numbers = merge_equal(np.array([[0.0, -0.0, 1], [-0.0, 0.0, 1], [2, 0, 0]]))
    assert vertices.tolist() == [[0, 0, 1], [2, 0, 0]]
    assert numbers.tolist() == [0, 0, 1]


def test_merging_gives_every_corner_its_own_place_back():
    positions = np.random.default_rng(0).integers(-2, 3, (500, 3)).astype(float)
    vertices, numbers = merge_equal(positions)
    assert np.array_equal(vertices[numbers], positions)
    assert len(np.unique(vertices, axis=0)) == len(vertices) == len(np.unique(positions, axis=0))
    assert (np.diff(np.unique(numbers, return_index=True)[1]) > 0).all()


def test_triangles_that_collapse_are_dropped(squares, write):
    content = squares["text.stl"].replace(b"vertex 0 1 0", b"vertex 1 1 0")
    report = read_mesh(write("flat.stl", content)).report
    assert report == ("6 corners merged into 3 vertices", "1 collapsed face dropped")


def test_several_solids_are_joined(squares, write):
    second = squares["text.stl"].replace(b" 0\n", b" 5\n")
    result = read_mesh(write("two.stl", squares["text.stl"] + second))
    assert len(result.mesh.faces) == 4
    assert result.report[0] == "2 solids joined"


def test_a_binary_file_may_be_longer_than_it_says(squares, write):
    """Some programs write a few bytes after the last face, some begin with the word "solid"."""
    content = squares["binary.stl"].replace(b"solid but", b"something")
    assert len(load_mesh(write("long.stl", content + b"the end")).faces) == 2
    assert squares["binary.stl"].startswith(b"solid")


def test_capitals_and_exponents_are_read(squares, write):
    content = squares["text.stl"].upper().replace(b"1 1 0", b"1.0E+00 1E0 -0")
    assert len(load_mesh(write("big.stl", content)).vertices) == 4


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        (b"endsolid square", b"", "its last solid has no end"),
        (b"  vertex 0 1 0\n", b"", "its last solid has no end"),
        (b"  vertex 0 1 0\n", b"  vertex 0 1 0\n  vertex 0 2 0\n", "it has 7 corners for 2 faces"),
        (b"vertex 0 1 0", b"vertex 0 1", "a vertex has fewer than three coordinates"),
        (b"vertex 0 1 0", b"vertex 0 nan 0", r"vertex 3 is \[0.0, nan, 0.0\]"),
        (b"vertex 0 1 0", b"vertex 0 one 0", "'one' is not a number"),
        (b"solid", b"fluid", "it is neither|it is no STL file"),
    ],
)
def test_bad_text_is_refused(old, new, reason, squares, write):
    with pytest.raises(LoadError, match=reason):
        load_mesh(write("bad.stl", squares["text.stl"].replace(old, new, 1)))


def test_a_binary_count_that_lies_is_refused(squares, write):
    content = bytearray(squares["binary.stl"])
    content[:5] = b"hello"
    content[80:84] = struct.pack("<I", 4_000_000_000)
    with pytest.raises(LoadError, match="4,000,000,000 faces announced, room for 2"):
        load_mesh(write("lying.stl", bytes(content)))


def test_no_faces_at_all_is_refused(write):
    with pytest.raises(LoadError, match="it has no faces"):
        load_mesh(write("none.stl", bytes(84)))


def test_coordinates_too_large_for_32_bits_are_not_written(tmp_path):
    mesh = TriangleMesh([[0, 0, 0], [1e300, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    with pytest.raises(SaveError, match="STL has 32-bit coordinates"):
        save_mesh(mesh, tmp_path / "huge.stl")
