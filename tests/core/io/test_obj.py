"""OBJ: the lines ``v`` and ``f`` in all their spellings."""

import pytest

from core.io import LoadError, load_mesh, read_mesh

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
POINTS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
FACES = [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize(
    "faces",
    [
        "f 1 2 3\nf 1 3 4\n",
        "f 1 2 3 4\n",
        "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n",
        "f 1//1 2//1 3//2 4//2\n",
        "f 1/1/1 2/2/1 3/3/1 4/4/1\n",
        "f -4 -3 -2 -1\n",
        "f -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1\n",
        "f 1 2 \\\n 3 4\n",
        "f 1 2 3 4 # the square\n",
        "  f\t1\t2\t3\t4  \n",
        "g left\nf 1 2 3\ns off\nusemtl paint\no right\nf 1 3 4",
        "f 1 2 3\r\nf 1 3 4\r\n",
    ],
)
def test_spellings_of_faces(faces, write):
    mesh = load_mesh(write("square.obj", POINTS + faces))
    assert mesh.vertices.tolist() == SQUARE
    assert mesh.faces.tolist() == FACES


def test_negative_numbers_count_from_their_own_line(write):
    """The face between the vertices means the first three, the one at the end the last three."""
    content = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nv 0 2 0\nf -3 -2 -1\n"
    assert load_mesh(write("a.obj", content)).faces.tolist() == [[0, 1, 2], [2, 3, 4]]


def test_faces_may_come_before_vertices(write):
    assert load_mesh(write("a.obj", "f 1 2 3 4\n" + POINTS)).faces.tolist() == FACES


def test_faces_of_different_sizes(write):
    mesh = load_mesh(write("a.obj", POINTS + "f 1 2 3\nf 1 2 3 4\nf 2 3 4\n"))
    assert mesh.faces.tolist() == [[0, 1, 2], *FACES, [1, 2, 3]]


def test_colours_and_weights_after_the_coordinates_are_left_alone(write):
    coloured = POINTS.replace("\n", " 0.5 0.5 0.5\n")
    uneven = POINTS.replace("v 1 0 0", "v 1 0 0 1.0")
    for points in (coloured, uneven):
        assert load_mesh(write("a.obj", points + "f 1 2 3 4\n")).vertices.tolist() == SQUARE


def test_texture_seams_and_coincident_vertices_keep_the_vertices_of_the_file(write):
    """Each corner has its own texture coordinate, and two vertices are at one place."""
    content = (
        POINTS + "v 1 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/3 3/1 4/2\nf 5/1 3/2 4/3\n"
    )
    mesh = load_mesh(write("a.obj", content))
    assert mesh.vertices.tolist() == [*SQUARE, [1, 0, 0]]
    assert mesh.faces.tolist() == [*FACES, [4, 2, 3]]


def test_what_is_dropped_is_reported(write):
    content = "v 9 9 9\n" + POINTS + "v 8 8 8\nf 2 3 4\nf 2 4 4\nf 2 3\nf 2 4 5\n"
    result = read_mesh(write("a.obj", content))
    assert result.mesh.vertices.tolist() == SQUARE
    assert result.mesh.faces.tolist() == FACES
    assert result.summary == (
        "1 face with fewer than three corners dropped; 1 collapsed face dropped; "
        "2 unreferenced vertices dropped"
    )


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (POINTS + "f 1 2 5\n", "face 1 names vertex 5; allowed are 1 to 4"),
        (POINTS + "f 1 2 3\nf 1 2 0\n", "face 2 names vertex 0; allowed are 1 to 4"),
        (POINTS + "f 1 2 -5\n", "face 1 names vertex 0; allowed are 1 to 4"),
        (POINTS + "f 1 2 99999999999999999999\n", "'99999999999999999999' is not a whole number"),
        (POINTS + "f 1 2 x\n", "'x' is not a whole number"),
        (POINTS + "v 1 2 x\nf 1 2 3\n", "'x' is not a number"),
        (POINTS + "v 1 2\nf 1 2 3\n", "a vertex has fewer than three coordinates: ' 1 2'"),
        (POINTS + "v\nf 1 2 3\n", "a vertex has fewer than three coordinates"),
        ("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 is .nan, 0.0, 0.0."),
        (POINTS + "f 1 2 3\nf 1 2", "the file is cut short"),
        (POINTS, "it has no faces, only 4 points"),
        ("f 1 2 3\n", "face 1 names vertex 1"),
        ("vn 0 0 1\n", "it has no line that begins with 'v' or 'f', so it is no OBJ file"),
    ],
)
def test_bad_files_are_refused(content, reason, write):
    with pytest.raises(LoadError, match=reason):
        load_mesh(write("bad.obj", content))


def test_an_unused_vertex_that_is_not_finite_does_no_harm(write):
    assert len(load_mesh(write("a.obj", POINTS + "v nan nan nan\nf 1 2 3 4\n")).vertices) == 4
