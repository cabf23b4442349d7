"""Cameras as text."""

import json
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError
from vtkmodules.vtkRenderingCore import vtkCamera

from app.scene.camera import CameraPose
from app.scene.camera_text import CameraTextError, named, pose_of, pose_text, read_pose
from core.view import NamedCamera

POSE = CameraPose((0.1, 2.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def test_a_pose_comes_back_from_its_text_and_from_its_name():
    assert read_pose(pose_text(POSE)) == POSE
    assert pose_of(named("front", POSE)) == POSE


@pytest.mark.parametrize(
    "text",
    [
        "",
        "hello",
        "[1, 2]",
        '{"position": [1, 2, 3]}',
        '{"position": [1, 2], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
        '{"position": "abc", "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
        '{"position": null, "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
    ],
)
def test_other_text_is_refused_in_one_sentence(text):
    with pytest.raises(CameraTextError, match="This text is no camera"):
        read_pose(text)


@pytest.mark.parametrize(
    ("place", "value", "words"),
    [
        ("position", (0, 0, 0), "sees nothing"),
        ("position", (0, 1e-30, 0), "sees nothing"),
        ("position", (0, 3, 0), "sees nothing"),
        ("position", (1e-9, 3, 0), "sees nothing"),
        ("view_up", (0, 0, 0), "sees nothing"),
        ("view_up", (1e-300, 0, 0), "sees nothing"),
        ("position", (math.nan, 3, 0), "Coordinates of a camera"),
        ("position", (0, 0, math.inf), "Coordinates of a camera"),
        ("focal_point", (0, -1e308, 0), "Coordinates of a camera"),
        ("view_up", (1e308, 1e308, 1e308), "Coordinates of a camera"),
    ],
)
def test_a_camera_that_sees_nothing_is_refused_in_one_sentence(place, value, words):
    hostile = POSE._replace(**{place: value})
    with pytest.raises(CameraTextError, match=words):
        read_pose(pose_text(hostile))
    with pytest.raises(CameraTextError, match=words):
        named("hostile", hostile)
    with pytest.raises(ValidationError, match=f"{words}|finite"):
        NamedCamera(name="hostile", **hostile._asdict())


@pytest.mark.parametrize(
    "text",
    [
        '{"position": [1e999, 3, 0], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
        '{"position": [' + "9" * 400 + ', 3, 0], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
        "[" * 100_000,
    ],
)
def test_numbers_beyond_all_measure_are_refused(text):
    with pytest.raises(CameraTextError):
        read_pose(text)


def test_what_else_a_text_says_is_passed_over():
    text = json.dumps({**POSE._asdict(), "view_angle": -1e308, "parallel_scale": 0, "clipping": []})
    assert read_pose(text) == POSE


@settings(max_examples=300, deadline=None)
@given(st.tuples(*[st.tuples(*[st.floats(width=64)] * 3)] * 3))
def test_what_is_let_through_gives_finite_transformations(places):
    """Any nine numbers: refused, or a camera in which the renderer finds no NaN."""
    try:
        pose = read_pose(pose_text(CameraPose(*places)))
    except CameraTextError:
        return
    assert_finite(pose)


@pytest.mark.parametrize("length", [1e-17, 1.0, 9e17])
@pytest.mark.parametrize("lean", [2e-6, 1.0])
def test_the_ends_of_what_is_allowed_give_finite_transformations(length, lean):
    pose = CameraPose((0.0, 0.0, length), (0.0, 0.0, 0.0), (lean * length, 0.0, length))
    assert read_pose(pose_text(pose)) == pose
    assert_finite(pose)


def assert_finite(pose):
    camera = vtkCamera()
    pose.apply(camera)
    matrix = camera.GetViewTransformMatrix()
    assert all(math.isfinite(matrix.GetElement(i, j)) for i in range(4) for j in range(4))
    assert matrix.Determinant() == pytest.approx(1, abs=1e-3)
