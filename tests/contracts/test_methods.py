"""What every smoothing method keeps to; a new one is tested as soon as it is listed."""

from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.mesh import TriangleMesh, primitives
from core.noise import add_noise
from core.parameters import describe
from core.smoothing import METHODS, smooth

every_method = pytest.mark.parametrize("method", list(METHODS))
NOISY = add_noise(primitives.torus(14, 9), sigma=0.2, seed=3)


def after(mesh: TriangleMesh, method: str, iterations: int = 2) -> np.ndarray:
    return smooth(mesh, method, iterations).vertices


@every_method
def test_declares_itself_fully(method):
    spec = METHODS[method]
    assert spec.id == method
    assert all((spec.title, spec.summary, spec.formula, spec.reference))
    assert spec.steps.__doc__
    assert "References" in spec.steps.__doc__
    assert all(parameter.help for parameter in describe(spec.params))


@every_method
def test_steps_are_new_arrays_and_leave_the_mesh_alone(method):
    spec = METHODS[method]
    before = NOISY.vertices.copy()
    one, two = islice(spec.steps(NOISY, spec.params()), 2)
    assert one.shape == two.shape == before.shape
    assert one is not two
    assert np.array_equal(NOISY.vertices, before)
    assert not np.array_equal(one, two)


@every_method
def test_makes_a_noisy_sphere_smoother(method):
    ball = primitives.sphere(3)
    noisy = add_noise(ball, sigma=0.2)
    radii = np.linalg.norm(after(noisy, method, 3), axis=1)
    assert radii.std() < np.linalg.norm(noisy.vertices, axis=1).std()


@every_method
def test_leaves_a_flat_grid_flat(method):
    flat = primitives.grid(6, 6)
    assert np.abs(after(flat, method)[:, 2]).max() == 0


@every_method
@settings(max_examples=8, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.floats(-6, 6).map(lambda power: 10.0**power),
    st.lists(st.floats(-100, 100), min_size=3, max_size=3),
)
def test_commutes_with_moving_turning_and_scaling(method, seed, scale, shift):
    turn = Rotation.random(rng=np.random.default_rng(seed)).as_matrix()

    def place(points: np.ndarray) -> np.ndarray:
        return scale * (points @ turn.T + np.array(shift))

    moved = after(NOISY.with_vertices(place(NOISY.vertices)), method)
    expected = place(after(NOISY, method))
    assert np.abs(moved - expected).max() < 1e-7 * scale * (1 + np.abs(shift).max())


@every_method
def test_commutes_with_renumbering(method):
    order = np.random.default_rng(5).permutation(len(NOISY.vertices))
    inverse = np.argsort(order)
    renumbered = TriangleMesh(NOISY.vertices[order], inverse[NOISY.faces][::-1])
    assert after(renumbered, method) == pytest.approx(after(NOISY, method)[order], abs=1e-9)


@every_method
@pytest.mark.parametrize("scale", [1e-12, 1e12])
def test_is_finite_at_any_size(method, scale):
    assert np.isfinite(after(NOISY.with_vertices(scale * NOISY.vertices), method)).all()


@every_method
def test_is_defined_on_awkward_meshes(method):
    fan = TriangleMesh(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [9, 9, 9], [2, 0, 0], [3, 0, 0]],
        [[0, 1, 2], [0, 2, 3], [1, 5, 6]],  # a fan, a face without area, an isolated vertex
    )
    moved = after(fan, method)
    assert np.isfinite(moved).all()
    assert moved[4].tolist() == [9, 9, 9]
    single = TriangleMesh(np.eye(3), [[0, 1, 2]])
    assert np.isfinite(after(single, method)).all()
