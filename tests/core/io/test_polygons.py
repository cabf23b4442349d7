"""From polygons to a checked mesh."""

from itertools import chain

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.io import LoadError
from core.io.polygons import Lists, Polygons, assemble, counted, cut_strips, fan_triangles


def lists(*rows: list[int]) -> Lists:
    return Lists(
        np.array([len(row) for row in rows], np.int64), np.array([*chain(*rows)], np.int64)
    )


def test_a_pentagon_becomes_a_fan():
    assert fan_triangles(lists([4, 3, 2, 1, 0])).tolist() == [[4, 3, 2], [4, 2, 1], [4, 1, 0]]


def test_polygons_with_fewer_than_three_corners_give_nothing():
    assert fan_triangles(lists([], [1], [1, 2], [5, 6, 7])).tolist() == [[5, 6, 7]]


@given(st.lists(st.integers(0, 9), min_size=1, max_size=20))
def test_a_polygon_of_k_corners_gives_k_minus_two_faces(sizes):
    rows = [list(range(size)) for size in sizes]
    faces = fan_triangles(lists(*rows))
    assert len(faces) == sum(max(size - 2, 0) for size in sizes)
    assert (faces[:, 0] == 0).all()
    assert (faces[:, 2] == faces[:, 1] + 1).all()


def test_a_strip_turns_every_second_face():
    faces, phrase = cut_strips(lists([0, 1, 2, 3, 4], [5, 6], [7, 8, 9]))
    assert faces.items.reshape(-1, 3).tolist() == [[0, 1, 2], [2, 1, 3], [2, 3, 4], [7, 8, 9]]
    assert phrase == "3 triangle strips cut into 4 faces"


def test_repeated_corners_join_two_strips_without_faces_of_their_own():
    faces, _ = cut_strips(lists([0, 1, 2, 2, 3, 3, 4, 5]))
    assert faces.items.reshape(-1, 3).tolist() == [[0, 1, 2], [4, 3, 5]]


def test_unreferenced_vertices_go_and_the_others_keep_their_order():
    vertices = np.arange(18.0).reshape(6, 3)
    mesh, report = assemble(Polygons(vertices, lists([5, 3, 1]), ("something",)))
    assert mesh.vertices.tolist() == vertices[[1, 3, 5]].tolist()
    assert mesh.faces.tolist() == [[2, 1, 0]]
    assert report == ("something", "3 unreferenced vertices dropped")


def test_nothing_is_reported_where_nothing_was_changed():
    assert assemble(Polygons(np.eye(3), lists([0, 1, 2])))[1] == ()


def test_numbers_are_given_in_the_files_own_counting():
    polygons = Polygons(np.eye(3), lists([0, 1, 2], [0, 1, 3]), first_number=1)
    with pytest.raises(LoadError, match="face 2 names vertex 4; allowed are 1 to 3"):
        assemble(polygons)


def test_numbers_have_their_nouns():
    assert [counted(1, "face"), counted(2345, "face")] == ["1 face", "2,345 faces"]
    assert counted(0, "vertex", "vertices") == "0 vertices"
