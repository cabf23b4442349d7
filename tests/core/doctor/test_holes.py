"""Filling holes: by hand, and what the models were before they were opened."""

import numpy as np
import pytest

from core.doctor import NOTHING, examine, filling, repair
from core.doctor.patches import patch
from core.io import load_mesh
from core.mesh import TriangleMesh, primitives
from core.mesh.geometry import face_areas, volume
from core.stepwise import carried_out

NO_RINGS = np.zeros(100, np.int32), np.zeros(0, np.int32)


def test_a_square_is_cut_along_its_shorter_diagonal():
    points = np.array([[0, 0, 0], [2, -0.2, 0], [4, 0, 0], [2, 0.2, 0]], float)
    faces, area = patch(points, np.arange(4, dtype=np.int32), *NO_RINGS)
    assert area == pytest.approx(0.8)
    assert all({1, 3} <= set(face) for face in faces.tolist())


def test_least_area_bends_along_the_better_diagonal():
    points = np.array([[0, 0, 1], [1, 0, 0], [1, 1, 1.2], [0, 1, 0]], float)
    faces, area = patch(points, np.arange(4, dtype=np.int32), *NO_RINGS)
    areas = [
        face_areas(TriangleMesh(points, pair)).sum()
        for pair in ([[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [0, 1, 3]])
    ]
    assert area == pytest.approx(min(areas))
    assert len(faces) == 2


def test_a_patch_leaves_no_flat_triangle_and_no_edge_twice():
    points = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 1, 0]], float)
    faces, _ = patch(points, np.arange(4, dtype=np.int32), *NO_RINGS)
    assert all({1, 3} <= set(face) for face in faces.tolist())
    starts = np.array([0, 0, 1, 1, 2], np.int32)  # 1 and 3 are neighbours already
    faces, area = patch(points, np.arange(4, dtype=np.int32), starts, np.array([3, 1], np.int32))
    assert len(faces) == 0
    assert area == np.inf


def test_a_filled_hole_is_wound_like_its_neighbours(defective):
    mesh = repair(defective("holed"), "fill_holes").mesh
    assert mesh.topology.is_closed
    assert mesh.topology.is_consistently_wound
    assert volume(mesh) > 0
    assert mesh.genus == 0


def test_the_end_of_a_surface_is_no_hole():
    assert repair(primitives.grid(3, 3), "fill_holes").changes == (NOTHING,)
    triangle = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert repair(triangle, "fill_holes").changes == (NOTHING,)


def test_holes_are_filled_some_at_a_time(monkeypatch):
    ball = primitives.sphere(1)
    copy = np.arange(8)[:, None, None]
    places, corners = ball.vertices + 3 * copy, ball.faces[1:] + len(ball.vertices) * copy
    mesh = TriangleMesh(places.reshape(-1, 3), corners.reshape(-1, 3))
    assert repair(mesh, "fill_holes").changes == ("Filled 8 holes with 8 faces.",)
    whole = carried_out(filling.filling_steps(mesh, 30))
    monkeypatch.setattr(filling, "_STEP", 2 * 27)
    steps = filling.filling_steps(mesh, 30)
    assert [next(steps) for _ in range(4)] == [None] * 4
    assert np.array_equal(carried_out(steps).patches, whole.patches)


def test_the_largest_number_of_edges_is_kept_to(defective):
    mesh = defective("holed")
    assert repair(mesh, "fill_holes", most_edges=4).changes == (NOTHING,)
    assert repair(mesh, "fill_holes", most_edges=5).changes == ("Filled 1 hole with 3 faces.",)


@pytest.mark.parametrize("apart", [False, True])
def test_holes_that_touch_are_filled_together(apart):
    ball = primitives.sphere(3)
    ring = ball.topology.vertex_ring
    first = int(ring.row(300)[0])
    far = [v for v in ring.row(first) if v != 300 and v not in ring.row(300)]
    gone = np.isin(ball.faces, [300, far[0]]).any(axis=1)
    mesh = TriangleMesh(ball.vertices, ball.faces[~gone])
    if apart:
        mesh = repair(mesh, "split").mesh
    closed = repair(mesh, "fill_holes").mesh
    assert closed.topology.is_closed
    assert examine(repair(closed, "unreferenced_vertices").mesh).findings == ()


def test_the_elephant_gets_its_skin_back(shared_models):
    mesh = load_mesh(shared_models / "awkward" / "elephant_with_holes.off")
    result = repair(mesh, "fill_holes")
    assert result.changes == ("Filled 171 holes with 1,011 faces.",)
    report = examine(result.mesh)
    assert report.findings == ()
    assert report.genus == examine(load_mesh(shared_models / "elephant_2775.off")).genus == 3


def test_no_new_defects(shared_models):
    for name in ("many_small_holes.ply", "nonmanifold_hole.ply", "teapot_soup.stl"):
        mesh = load_mesh(shared_models / "awkward" / name)
        split = repair(mesh, "split").mesh
        assert examine(repair(split, "fill_holes").mesh).is_sound, name
