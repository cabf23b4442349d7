"""Cameras as text."""

import pytest

from app.scene.camera import CameraPose
from app.scene.camera_text import CameraTextError, named, pose_of, pose_text, read_pose

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
    "text",
    [
        '{"position": [0, 0, 0], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
        '{"position": [0, 3, 0], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
        '{"position": [NaN, 3, 0], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}',
    ],
)
def test_a_camera_that_sees_nothing_is_refused(text):
    with pytest.raises(CameraTextError, match="sees nothing"):
        read_pose(text)
