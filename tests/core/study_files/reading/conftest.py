"""A study of two models in a folder of their own, and the file it is written to."""

import pytest

from core.io import save_mesh
from core.mesh import primitives
from core.noise import NoiseParams, add_noise
from core.study import MethodChoice, Study


@pytest.fixture
def models(tmp_path):
    folder = tmp_path / "models"
    folder.mkdir()
    save_mesh(primitives.sphere(1), folder / "ball.ply")
    save_mesh(add_noise(primitives.sphere(1), 0.1), folder / "scan.ply")
    return folder


@pytest.fixture
def study(models):
    return Study(
        model=str(models / "ball.ply"),
        noise=NoiseParams(sigma=0.3, seed=9),
        methods=(MethodChoice(method="mean", iterations=2),),
    )


@pytest.fixture
def file(tmp_path):
    folder = tmp_path / "studies"
    folder.mkdir()
    return folder / "first.burnish"
