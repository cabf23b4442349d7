"""Places that are pointed out: the dots, and the camera that goes close to them."""

import numpy as np
import pytest

from app.scene.camera import CameraPose
from app.scene.marks import Marks, close_up
from app.scene.panes import NO_FACES, Look, Pane
from core.mesh import primitives

FAR = CameraPose((0.0, 0.0, 10.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def shown(points, marks):
    dots = Marks()
    dots.show(Pane("original", "", "", "#000000", points), Look(NO_FACES, marks=marks))
    return dots.actor


def test_dots_lie_at_the_vertices_that_are_pointed_out():
    points = np.arange(30, dtype=np.float32).reshape(10, 3)
    actor = shown(points, np.array([2, 5]))
    actor.GetMapper().Update()
    drawn = actor.GetMapper().GetInput()
    assert [drawn.GetPoint(i) for i in range(2)] == [(6, 7, 8), (15, 16, 17)]
    assert drawn.GetNumberOfVerts() == 2
    assert actor.GetVisibility()


def test_nothing_is_drawn_without_marks():
    assert not shown(np.zeros((4, 3), np.float32), None).GetVisibility()


def test_many_dots_are_small():
    points = np.zeros((9000, 3), np.float32)
    sizes = [
        shown(points, np.arange(count)).GetProperty().GetPointSize() for count in (1, 200, 9000)
    ]
    assert sizes[0] > sizes[1] > sizes[2] >= 3


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_one_place_is_seen_from_outside_and_from_near(scale):
    ball = primitives.sphere(3)
    ball = ball.with_vertices(scale * (ball.vertices + np.array([5, 0, 0])))
    pose = close_up(ball, np.array([7]), FAR)
    place = ball.vertices[7] - ball.vertices.mean(axis=0)
    towards = np.subtract(pose.position, pose.focal_point)
    assert np.allclose(pose.focal_point, place)
    assert np.dot(towards / np.linalg.norm(towards), place / scale) > 0.95
    assert np.linalg.norm(towards) < 0.6 * scale


def test_places_all_over_are_seen_from_where_the_camera_stands():
    ball = primitives.sphere(2)
    pose = close_up(ball, np.arange(len(ball.vertices)), FAR)
    assert np.allclose(pose.focal_point, 0, atol=1e-9)
    assert np.allclose(pose.position[:2], 0, atol=1e-9)
    assert pose.view_up == (0, 1, 0)


def test_what_is_up_is_never_along_the_view():
    ball = primitives.sphere(2)
    top = int(ball.vertices[:, 1].argmax())
    pose = close_up(ball, np.array([top]), FAR)
    towards = np.subtract(pose.position, pose.focal_point)
    assert np.linalg.norm(np.cross(pose.view_up, towards / np.linalg.norm(towards))) > 0.1
