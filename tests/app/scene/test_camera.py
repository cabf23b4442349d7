"""Presets of the camera: what is seen first."""

import numpy as np
import pytest

from app.scene.camera import OBLIQUE, PRESETS, preset_directions, preset_pose
from core.io import load_mesh
from core.mesh import primitives

BALL = primitives.sphere(2).vertices


def seen_width(points, name=OBLIQUE):
    """How wide points are in the picture, as a share of how high."""
    direction, up = preset_directions(name, points)
    forward = -np.array(direction) / np.linalg.norm(direction)
    right = np.cross(forward, up) / np.linalg.norm(np.cross(forward, up))
    return np.ptp(points @ right) / np.ptp(points @ np.cross(right, forward))


@pytest.mark.parametrize(
    ("sides", "towards"),
    [((1, 1, 1), "z"), ((3, 1, 1), "z"), ((1, 3, 1), "z"), ((1, 1, 1.4), "z"), ((1, 1, 3), "x")],
)
def test_the_first_view_looks_across_the_longer_side(sides, towards):
    (x, _, z), up = preset_directions(OBLIQUE, BALL * sides)
    assert up == (0, 1, 0)
    assert ("x" if x > z else "z") == towards


@pytest.mark.parametrize("name", [name for name in PRESETS if name != OBLIQUE])
def test_other_presets_are_what_they_say(name):
    assert preset_directions(name, BALL * (1, 1, 9)) == PRESETS[name]


def test_the_direction_does_not_depend_on_size_and_place():
    deep = BALL * (1, 1, 3)
    assert preset_directions(OBLIQUE, deep) == preset_directions(OBLIQUE, 100 * deep + 7)


def test_the_camera_stands_where_the_direction_says():
    pose = preset_pose(OBLIQUE, BALL * (1, 1, 3), 3.0)
    assert pose.position[0] > pose.position[2] > pose.position[1] > 0
    assert pose.focal_point == (0, 0, 0)


@pytest.mark.parametrize("model", ["horse_19851.off", "camel_2444.ply", "spot_2930.obj"])
def test_animals_that_face_the_camera_or_turn_their_backs_are_seen_from_the_side(
    shared_models, model
):
    points = load_mesh(shared_models / model).vertices
    first, _ = PRESETS[OBLIQUE]
    assert preset_directions(OBLIQUE, points)[0] == first[::-1]
    assert seen_width(points) > 0.8
