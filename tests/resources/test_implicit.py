import numpy as np
import pytest

from resources.models import implicit

RNG = np.random.default_rng(0)
POINTS = RNG.uniform(-1, 1, (200, 3))


def test_ellipsoid_with_equal_radii_is_a_ball():
    ball = implicit.ellipsoid([1, 0, 0], [2, 2, 2])
    np.testing.assert_allclose(ball(POINTS), np.linalg.norm(POINTS - [1, 0, 0], axis=1) - 2)


def test_ring_is_zero_on_its_tube():
    torus = implicit.ring([0, 0, 1], radius=2, tube_radius=0.5)
    np.testing.assert_allclose(
        torus(np.array([[2.5, 0, 1], [0, 2, 1.5], [2, 0, 1.0]])), [0, 0, -0.5]
    )


def test_half_space_is_negative_behind_its_plane():
    ground = implicit.half_space([0, 0, 1], [0, 0, 3])
    np.testing.assert_allclose(ground(np.array([[5, 5, 0], [5, 5, 2.0]])), [-1, 1])


def test_straight_tube_is_a_capsule():
    capsule = implicit.tube([[0, 0, 0], [0, 0, 1]], [0.1, 0.1])
    points = np.array([[0.15, 0, 0.5], [0, 0, 1.2], [0, 0.05, 0.3]])
    np.testing.assert_allclose(capsule(points), [0.05, 0.1, -0.05], atol=1e-9)


def test_bent_tube_follows_its_path():
    path = [[0, 0, 0], [0.5, 0.2, 0], [1, 0, 0.3], [1.2, 0, 0.8]]
    bent = implicit.tube(path, [0.1, 0.1])
    np.testing.assert_allclose(bent(np.array(path, float)), -0.1, atol=1e-6)


def test_far_from_a_tube_the_value_is_constant():
    capsule = implicit.tube([[0, 0, 0], [0, 0, 1]], [0.1, 0.1])
    assert capsule(np.array([[5.0, 5, 5]]))[0] == implicit.FAR


@pytest.mark.parametrize("blend", [0.01, 0.3])
def test_smooth_minimum_lies_just_below_the_minimum(blend):
    a, b = RNG.normal(size=(2, 500))
    smooth = implicit.smooth_minimum(a, b, blend)
    assert np.all(smooth <= np.minimum(a, b))
    assert np.all(smooth >= np.minimum(a, b) - blend / 6)
    apart = np.abs(a - b) > blend
    np.testing.assert_array_equal(smooth[apart], np.minimum(a, b)[apart])


def test_union_has_what_either_part_has_and_cut_takes_away():
    left, right = (implicit.ellipsoid([x, 0, 0], [0.5] * 3) for x in (-0.3, 0.3))
    inside = (left(POINTS) < 0) | (right(POINTS) < 0)
    np.testing.assert_array_equal(implicit.union(1e-6, left, right)(POINTS) < 0, inside)
    rest = (left(POINTS) < 0) & (right(POINTS) > 0)
    np.testing.assert_array_equal(implicit.cut(1e-6, left, right)(POINTS) < 0, rest)


def test_mirrored_is_symmetric():
    field = implicit.mirrored(implicit.ellipsoid([0, 0.5, 0], [0.2, 0.3, 0.4]))
    np.testing.assert_allclose(field(POINTS), field(POINTS * [1, -1, 1]))


def test_placed_moves_a_part_with_its_points():
    part = implicit.ellipsoid([0.1, 0, 0], [0.2, 0.3, 0.4])
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    moved = implicit.placed(part, turn, [1, 2, 3])
    np.testing.assert_allclose(moved(POINTS @ turn.T + [1, 2, 3]), part(POINTS))


def test_stretched_ball_is_an_ellipsoid():
    egg = implicit.stretched(implicit.ellipsoid([0, 0, 0], [1, 1, 1]), [1, 2, 3])
    np.testing.assert_allclose(egg(np.array([[1, 0, 0], [0, 2, 0], [0, 0, 3.0]])), 0, atol=1e-12)


def test_raised_and_bump():
    swell = implicit.bump([1, 0, 0], 0.5)
    ball = implicit.raised(implicit.ellipsoid([0, 0, 0], [1, 1, 1]), lambda p: 0.1 * swell(p))
    np.testing.assert_allclose(ball(np.array([[1, 0, 0], [-1, 0, 0.0]])), [-0.1, 0], atol=1e-12)


def test_project_lands_on_the_surface():
    egg = implicit.ellipsoid([0, 0, 0], [1, 0.8, 0.6])
    near = POINTS[np.abs(egg(POINTS)) < 0.2]
    assert len(near) > 20
    np.testing.assert_allclose(egg(implicit.project(egg, near)), 0, atol=1e-6)
