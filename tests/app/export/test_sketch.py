"""Small pictures of meshes without graphics."""

import numpy as np
import pytest

from app.export.sketch import sketch_picture
from core.mesh import TriangleMesh, primitives

SIZE = (112, 84)


def test_a_ball_is_a_closed_bright_disc():
    picture = sketch_picture(primitives.sphere(3), SIZE).astype(int)
    assert picture.shape == (84, 112, 4)
    alpha = picture[..., 3] / 255
    radius = 0.5 * 84 * 0.88
    rows, columns = np.mgrid[0:84, 0:112]
    distance = np.hypot(rows + 0.5 - 42, columns + 0.5 - 56)
    assert alpha[distance < radius - 3].min() > 0.9
    assert alpha[distance > radius + 2].max() == 0
    middle, edge = picture[42, 56, 0], picture[42, 56 + int(radius) - 2, 0]
    assert middle > edge + 60


def test_size_and_place_do_not_count():
    mesh = primitives.torus(24, 12)
    moved = mesh.with_vertices(mesh.vertices * 1000 + [5, -7, 3])
    difference = sketch_picture(mesh, SIZE).astype(int) - sketch_picture(moved, SIZE)
    assert (np.abs(difference).max(axis=2) > 20).mean() < 0.02


@pytest.mark.parametrize(
    "mesh",
    [
        TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)),
        TriangleMesh(np.zeros((3, 3)), np.array([[0, 1, 2]])),
    ],
)
def test_nothing_to_see_is_an_empty_picture(mesh):
    assert not sketch_picture(mesh, SIZE).any()
