from itertools import pairwise

import numpy as np
import pytest

from core.mesh import TriangleMesh, geometry
from resources.models import panels

UP = (0.0, 0.0, 1.0)
FRAME = panels.Frame((1, 2, 3), UP, (1, 0, 0))
SHEETS = {
    "plane": panels.Plane((0, 0, 1), (0, 1, 0), (0, 0, 1)),
    "cylinder": panels.Cylinder(FRAME, 0.7),
    "cone": panels.Cone(FRAME, (0.9, 0.1), (0.5, 0.4)),
}


def square(side: float, spacing: float) -> np.ndarray:
    corners = side * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0]])
    return panels.loop(*[panels.line(a, b, spacing) for a, b in pairwise(corners)])


def area(points, faces) -> float:
    return geometry.face_areas(TriangleMesh(points, faces)).sum()


@pytest.mark.parametrize("sheet", SHEETS.values(), ids=SHEETS.keys())
def test_unrolling_keeps_lengths_and_rolling_undoes_it(sheet):
    middle = sheet.unroll(FRAME.at([0.3], 0.7, 0.2))
    flat = middle + 1e-5 * np.array([[0, 0], [1, 0], [0, 1], [1, 1]])
    points = sheet.roll(flat)
    np.testing.assert_allclose(sheet.unroll(points), flat, atol=1e-12)
    steps = np.linalg.norm(points[1:] - points[0], axis=1)
    np.testing.assert_allclose(steps, 1e-5 * np.array([1, 1, np.sqrt(2)]), rtol=1e-4)


def test_line_and_arc_contain_their_ends():
    straight = panels.line([0, 0, 0], [0, 0, 1], 0.24)
    np.testing.assert_allclose(straight[:, 2], np.linspace(0, 1, 5))
    quarter = panels.arc(FRAME, (0, np.pi / 2), 2, 0, 0.5)
    np.testing.assert_allclose(quarter[[0, -1]], [[3, 2, 3], [1, 4, 3]])
    np.testing.assert_allclose(np.linalg.norm(quarter - [1, 2, 3], axis=1), 2)


def test_panel_fills_a_square_with_even_faces():
    points, faces = panels.flat_panel(square(1, 0.1), spacing=0.1)
    assert area(points, faces) == pytest.approx(1)
    angles = geometry.corner_angles(TriangleMesh(points, faces))
    assert np.degrees(angles).min() > 25


def test_panel_leaves_holes_open_and_borders_in_place():
    outer, hole = square(1, 0.1), 0.3 + square(0.4, 0.1) * [1, 1, 0] - [0, 0, 0.3]
    hole[:, 2] = 0
    points, faces = panels.flat_panel(outer, hole, spacing=0.1)
    assert area(points, faces) == pytest.approx(1 - 0.16)
    np.testing.assert_array_equal(points[: len(outer) + len(hole)], np.concatenate([outer, hole]))
    assert TriangleMesh(points, faces).topology.boundary_edges.sum() == len(outer) + len(hole)


def test_welded_faces_of_a_cube_are_one_closed_surface_wound_outwards():
    side = panels.flat_panel(square(1, 0.25) - [0.5, 0.5, 0.5], spacing=0.25)
    turns = [np.eye(3)[[0, 1, 2]], np.eye(3)[[2, 0, 1]], np.eye(3)[[1, 2, 0]]]
    sides = [(side[0] @ turn, side[1]) for turn in turns]
    cube = TriangleMesh(*panels.weld(sides + [(-points, faces) for points, faces in sides]))
    assert cube.genus == 0
    assert geometry.volume(cube) == pytest.approx(1)


def test_mirror_doubles_for_each_axis():
    side = panels.flat_panel(square(1, 0.5), spacing=0.5)
    images = panels.mirror([side], 0, 1)
    assert len(images) == 4
    np.testing.assert_array_equal(images[3][0], side[0] * [-1, -1, 1])
