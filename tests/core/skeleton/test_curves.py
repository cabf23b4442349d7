"""Level curves: on the field's levels, connected, closed where the surface is."""

import numpy as np
import pytest

from core.fields import normalise, scalar_field
from core.mesh import TriangleMesh, primitives
from core.skeleton import band_levels, level_curves


def lengths(curves):
    return np.diff(curves.starts)


def test_a_grid_has_straight_lines():
    mesh = primitives.grid(4, 3)
    curves = level_curves(mesh, scalar_field(mesh, "height", x=1, z=0), np.array([0.1, 0.6]))
    assert curves.levels.tolist() == [0, 1]
    assert not curves.is_closed.any()
    # Three squares, each with its diagonal: seven edges cross.
    assert lengths(curves).tolist() == [7, 7]
    for k, x in enumerate((0.4, 2.4)):
        points = curves.points[curves.starts[k] : curves.starts[k + 1]]
        assert points[:, 0] == pytest.approx(x)
        assert sorted(points[[0, -1], 1]) == [0, 3]
        assert abs(np.diff(points[:, 1])).sum() == pytest.approx(3)


def test_a_torus_on_its_side_has_circles():
    mesh = primitives.torus(48, 16)
    field = scalar_field(mesh, "height", x=1, y=0.001, z=0.0001)
    curves = level_curves(mesh, field, np.array([0.1, 0.5, 0.9]))
    assert curves.is_closed.all()
    assert np.bincount(curves.levels).tolist() == [1, 2, 1]
    middle = curves.points[curves.starts[1] : curves.starts[2]]
    radii = np.hypot(np.abs(middle[:, 1]) - 1, middle[:, 2])
    assert radii == pytest.approx(0.4, abs=0.02)


def test_points_have_the_value_of_their_level():
    mesh = primitives.sphere(3)
    field = scalar_field(mesh, "height", x=0.3, y=0.5)
    levels = band_levels(mesh, field, 9)
    curves = level_curves(mesh, field, levels)
    direction = np.array([0.3, 0.5, 1])
    heights = curves.points @ (direction / np.linalg.norm(direction))
    expected = field.raw(levels)[np.repeat(curves.levels, lengths(curves))]
    assert heights == pytest.approx(expected)


def test_curves_part_at_a_non_manifold_edge():
    book = TriangleMesh(np.eye(5, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    curves = level_curves(book, normalise(book, np.array([0, 1, 0.4, 0.4, 0.4])), np.array([0.2]))
    assert lengths(curves).tolist() == [2, 2, 2]
    curves = level_curves(book, normalise(book, np.array([0.5, 0.5, 0, 1, 1])), np.array([0.7]))
    assert lengths(curves).tolist() == [2, 2]


def test_no_levels_no_curves():
    mesh = primitives.torus()
    curves = level_curves(mesh, scalar_field(mesh, "height"), np.zeros(0))
    assert (len(curves.points), len(curves.levels), len(curves.is_closed)) == (0, 0, 0)
