"""Cameras of a stranger's study from which nothing can be seen: refused in one sentence."""

import json
import math

import pytest

from core.io import save_mesh
from core.mesh import primitives
from core.study import Study
from core.study_files import StudyFileError, read_study_file, write_study_file
from core.view import NamedCamera

CAMERA = NamedCamera(name="a", position=(0, 0, 3), focal_point=(0, 0, 0), view_up=(0, 1, 0))


@pytest.fixture
def file(tmp_path):
    save_mesh(primitives.sphere(1), tmp_path / "ball.ply")
    study = Study(model=str(tmp_path / "ball.ply"))
    write_study_file(
        study.model_copy(update={"view": study.view.with_camera(CAMERA)}), tmp_path / "a.burnish"
    )
    return tmp_path / "a.burnish"


def with_camera(file, **changes):
    plain = json.loads(file.read_text())
    plain["study"]["view"]["cameras"][0] |= changes
    file.write_text(json.dumps(plain))


def test_a_camera_comes_back(file):
    assert read_study_file(file).study.view.cameras == (CAMERA,)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"position": [math.nan, 0, 1]}, "should be a finite number"),
        ({"position": [math.inf, 0, 1]}, "should be a finite number"),
        ({"position": [0, 0, 10**400]}, "position.2="),
        ({"position": [0, 0, 1e308]}, "Coordinates of a camera must be numbers"),
        ({"position": [0, 0, 0]}, "sees nothing"),
        ({"view_up": [0, 0, 0]}, "sees nothing"),
        ({"view_up": [0, 0, -1]}, "sees nothing"),
        ({"view_angle": 0}, "view_angle, which this Burnish does not know"),
        ({"parallel_scale": -1e308}, "parallel_scale, which this Burnish does not know"),
    ],
)
def test_a_hostile_camera_is_refused_in_one_sentence(file, changes, words):
    with_camera(file, **changes)
    with pytest.raises(StudyFileError, match=words) as refusal:
        read_study_file(file)
    assert str(refusal.value).startswith("a.burnish: has ")
    assert "\n" not in str(refusal.value)
    assert "Value error" not in str(refusal.value)
