"""Every metric against its formula in plain numpy on irregular, open and non-manifold meshes."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.metrics import METRICS
from core.metrics.arctangent import angle_of
from core.noise import add_noise


@pytest.fixture
def moved(irregular):
    return add_noise(irregular, 0.1, seed=4).vertices


def diffusion_operator(mesh, v):
    """𝒜(vᵢ) of thesis eq. (12), with the printed gradient."""
    joined = mesh.topology.adjacency.toarray() > 0
    d = np.maximum(joined.sum(axis=1), 1)
    scaled = v / np.sqrt(d)[:, None]
    squares = [((scaled[ring] - scaled[i]) ** 2).sum() for i, ring in enumerate(joined)]
    g = 1 / (1 + np.array(squares) / 2.3849**2)
    terms = [
        ((g[i] + g[ring])[:, None] * (v[i] - v[ring])).sum(axis=0) for i, ring in enumerate(joined)
    ]
    return np.array(terms) / d[:, None]


@pytest.mark.parametrize("model_units", [False, True])
def test_visual_error(irregular, moved, model_units):
    centre = 0 if model_units else irregular.vertices.mean(axis=0)
    scale = 1 if model_units else irregular.mean_edge_length
    a, b = (irregular.vertices - centre) / scale, (moved - centre) / scale
    change = diffusion_operator(irregular, a) - diffusion_operator(irregular, b)
    expected = (((a - b) ** 2).sum(axis=1) + (change**2).sum(axis=1)) / 2
    evaluator = METRICS["visual_error"].evaluator(irregular, model_units=model_units)
    assert evaluator.elements(moved) == pytest.approx(expected)
    assert evaluator.value(moved) == pytest.approx(expected.mean())


def test_vertex_rms(irregular, moved):
    distances = np.linalg.norm(moved - irregular.vertices, axis=1) / irregular.mean_edge_length
    evaluator = METRICS["vertex_rms"].evaluator(irregular)
    assert evaluator.elements(moved) == pytest.approx(distances)
    assert evaluator.value(moved) == pytest.approx(np.sqrt((distances**2).mean()))


def test_normal_angle(irregular, moved):
    a, b = (
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        for corners in (irregular.vertices[irregular.faces], moved[irregular.faces])
    )
    sines = np.linalg.norm(np.cross(a, b), axis=1)
    angles = np.degrees(np.arctan2(sines, (a * b).sum(axis=1)))
    evaluator = METRICS["normal_angle"].evaluator(irregular)
    assert evaluator.elements(moved) == pytest.approx(angles)
    assert evaluator.value(moved) == pytest.approx(angles.mean())


lengths = st.floats(1e-150, 1e150)


@given(lengths, lengths, st.sampled_from([1, -1]))
def test_angle_is_exact_to_the_last_bits(sine, cosine, sign):
    expected = math.atan2(sine, sign * cosine)
    assert angle_of(sine, sign * cosine) == pytest.approx(expected, rel=2e-15, abs=0)


@pytest.mark.parametrize(
    ("sine", "cosine", "angle"),
    [(0, 0, 0), (0, 1, 0), (0, -1, np.pi), (1, 0, np.pi / 2), (1, 1, np.pi / 4)],
)
def test_angles_by_hand(sine, cosine, angle):
    assert angle_of(float(sine), float(cosine)) == pytest.approx(angle, rel=2e-15, abs=0)


def test_angle_of_no_number():
    assert np.isnan(angle_of(np.nan, 1.0))
    assert np.isnan(angle_of(np.nan, np.nan))
    assert np.isnan(angle_of(np.inf, np.inf))
