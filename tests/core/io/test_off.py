"""OFF: headers, colours, polygons, comments and the binary form."""

import struct

import pytest

from core.io import LoadError, load_mesh, read_mesh

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
POINTS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
FACES = [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize(
    "content",
    [
        "OFF\n4 1 0\n" + POINTS + "4 0 1 2 3\n",
        "OFF 4 1 0\n" + POINTS + "4 0 1 2 3\n",
        "OFF\n4 1\n" + POINTS + "4 0 1 2 3",
        "4 1 0\n" + POINTS + "4 0 1 2 3\n",
        "# by hand\nOFF # word\n\n4 1 0 # counts\n\n" + POINTS + "# faces\n4 0 1 2 3 # square\n",
        ("OFF\n4 1 0\n" + POINTS + "4 0 1 2 3\n").replace("\n", "\r\n"),
        "OFF\n4 2 0\n" + POINTS + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n",
        "OFF\n4 2 0\n" + POINTS + "3 0 1 2 7\n3 0 2 3 8\n",
        "COFF\n4 1 0\n" + POINTS.replace("\n", " 255 0 0 255\n") + "4 0 1 2 3\n",
        "NOFF\n4 1 0\n" + POINTS.replace("\n", " 0 0 1\n") + "4 0 1 2 3\n",
        "STCNOFF\n4 1 0\n" + POINTS.replace("\n", " 0 0 1 1 0 0 1 0 0\n") + "4 0 1 2 3\n",
        "COFF\n4 1 0\n" + POINTS.replace("1 1 0", "1 1 0 255 0 0 255") + "4 0 1 2 3\n",
    ],
)
def test_spellings_of_the_square(content, write):
    mesh = load_mesh(write("square.off", content))
    assert mesh.vertices.tolist() == SQUARE
    assert mesh.faces.tolist() == FACES


def test_faces_of_different_sizes(write):
    content = "OFF\n4 3 0\n" + POINTS + "3 0 1 2\n4 0 1 2 3\n2 0 1\n"
    result = read_mesh(write("mixed.off", content))
    assert result.mesh.faces.tolist() == [[0, 1, 2], *FACES]
    assert result.report == (
        "1 polygon triangulated",
        "1 face with fewer than three corners dropped",
    )


def test_binary_with_normals_and_colours_of_vertices(write):
    vertices = b"".join(struct.pack(">10f", *p, *([0.5] * 7)) for p in SQUARE)
    faces = struct.pack(">6i4f", 4, 0, 1, 2, 3, 4, 1, 0, 0, 1)
    content = b"CNOFF BINARY\n" + struct.pack(">3i", 4, 1, 0) + vertices + faces
    mesh = load_mesh(write("binary.off", content))
    assert mesh.vertices.tolist() == SQUARE
    assert mesh.faces.tolist() == FACES


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("4 2 0", "4000000000 2 0", "cut short: 4,000,000,002 lines .* announced, 6 there"),
        ("4 2 0", "4 4000000000 0", "cut short: 4,000,000,004 lines .* announced, 6 there"),
        ("4 2 0", "4 -2 0", "it does not say how many"),
        ("4 2 0", "4", "it does not say how many"),
        ("4 2 0", "4 two 0", "'two' is not a whole number"),
        ("4 2 0", "4 0 0", "it has no faces, only 4 points"),
        ("3 0 1 2", "3 0 1 4", "face 0 names vertex 4; allowed are 0 to 3"),
        ("3 0 1 2", "3 0 1 -1", "face 0 names vertex -1; allowed are 0 to 3"),
        ("3 0 1 2", "9 0 1 2", "face 0 is cut short: 9 corners announced"),
        ("3 0 1 2", "-3 0 1 2", "a face announces -3 corners"),
        ("1 1 0", "1 inf 0", r"vertex 2 is \[1.0, inf, 0.0\]"),
        ("1 1 0", "1 1", "a vertex has fewer than three coordinates: '1 1'"),
        ("OFF", "4OFF", "its vertices have not three coordinates"),
        ("OFF", "nOFF", "its vertices have not three coordinates"),
        ("OFF", "PLY", "it does not begin with the word OFF"),
    ],
)
def test_bad_files_are_refused(old, new, reason, write):
    content = "OFF\n4 2 0\n" + POINTS + "3 0 1 2\n3 0 2 3\n"
    with pytest.raises(LoadError, match=reason):
        load_mesh(write("bad.off", content.replace(old, new, 1)))


def test_equal_faces_that_announce_more_corners_than_they_have_are_refused(write):
    content = "OFF\n4 2 0\n" + POINTS + "4 0 1 2\n4 0 2 3\n"
    with pytest.raises(LoadError, match="a face announces 4 corners and has 3"):
        load_mesh(write("bad.off", content))


@pytest.mark.parametrize("counts", [(2**31 - 1, 2, 0), (4, 2**31 - 1, 0), (-4, 2, 0)])
def test_binary_counts_that_lie_are_refused(counts, squares, write):
    content = bytearray(squares["binary.off"])
    content[11:23] = struct.pack(">3i", *counts)
    with pytest.raises(LoadError, match=r"announced|does not say"):
        load_mesh(write("lying.off", bytes(content)))
