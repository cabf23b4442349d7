"""Noise: amount, seed, refusal."""

import numpy as np
import pytest

from core.noise import add_noise
from core.parameters import ParameterError


def test_deviation_is_sigma_mean_edge_lengths(ball):
    noise = add_noise(ball, sigma=0.1).vertices - ball.vertices
    assert noise.std() == pytest.approx(0.1 * ball.mean_edge_length, rel=0.05)
    assert abs(noise.mean()) < 0.01 * ball.mean_edge_length


def test_same_seed_same_mesh_other_seed_other_mesh(ball):
    assert np.array_equal(add_noise(ball, seed=7).vertices, add_noise(ball, seed=7).vertices)
    assert not np.array_equal(add_noise(ball, seed=7).vertices, add_noise(ball, seed=8).vertices)


def test_scales_with_the_model(ball):
    large = ball.with_vertices(1000 * ball.vertices)
    assert add_noise(large).vertices == pytest.approx(1000 * add_noise(ball).vertices)


def test_no_noise_at_zero(ball):
    assert np.array_equal(add_noise(ball, sigma=0).vertices, ball.vertices)


@pytest.mark.parametrize("sigma", [-0.1, 1.5, float("nan")])
def test_sigma_out_of_range_says_what_is_allowed(ball, sigma):
    with pytest.raises(ParameterError, match=r"noise.sigma=.* use 0 to 1 ℓ̄"):
        add_noise(ball, sigma=sigma)
