"""Every metric against its formula in plain numpy on irregular, open and non-manifold meshes."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.lanes import WIDTH, side_by_side
from core.metrics import METRICS, metrics_in
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


def exact_diffusion_operator(mesh, vertices, scale):
    """𝒜(vᵢ) of thesis eq. (12) edge by edge, in extended precision, lengths times the scale."""
    centre = mesh.vertices.astype(np.longdouble).mean(axis=0)
    v = scale * (vertices.astype(np.longdouble) - centre)
    i, j = np.vstack([mesh.edges, mesh.edges[:, ::-1]]).T
    d = np.maximum(mesh.degrees, 1).astype(np.longdouble)[:, None]
    squares, operator = np.zeros(len(v), np.longdouble), np.zeros_like(v)
    np.add.at(squares, i, (((v / np.sqrt(d))[i] - (v / np.sqrt(d))[j]) ** 2).sum(axis=1))
    g = 1 / (1 + squares / np.longdouble(2.3849) ** 2)
    np.add.at(operator, i, (g[i] + g[j])[:, None] * (v[i] - v[j]))
    return operator / d


@pytest.mark.parametrize("away", [0, 1e6])
def test_visual_error_keeps_its_digits(irregular, away):
    mesh = irregular.with_vertices(irregular.vertices + away)
    vertices = mesh.vertices + np.random.default_rng(2).normal(scale=1e-3, size=mesh.vertices.shape)
    scale = 1 / np.longdouble(mesh.mean_edge_length)
    change = exact_diffusion_operator(mesh, vertices, scale) - exact_diffusion_operator(
        mesh, mesh.vertices, scale
    )
    displacement = scale * (vertices.astype(np.longdouble) - mesh.vertices)
    expected = ((displacement**2 + change**2).sum(axis=1) / 2).astype(np.float64)
    evaluator = METRICS["visual_error"].evaluator(mesh)
    assert evaluator.elements(vertices) == pytest.approx(expected, rel=1e-9 if away else 1e-11)
    assert evaluator.value(vertices) == pytest.approx(expected.mean(), rel=1e-9 if away else 1e-12)


@pytest.mark.parametrize("metric", list(METRICS))
def test_equal_positions_have_no_error_at_all(irregular, metric):
    evaluator = METRICS[metric].evaluator(irregular)
    assert evaluator.value(irregular.vertices) == 0
    assert not evaluator.elements(irregular.vertices).any()


@pytest.mark.parametrize("metric", list(METRICS))
def test_positions_in_any_order_of_memory(irregular, moved, metric):
    evaluator = METRICS[metric].evaluator(irregular)
    assert evaluator.value(np.asfortranarray(moved)) == evaluator.value(moved)
    assert np.array_equal(evaluator.elements(np.asfortranarray(moved)), evaluator.elements(moved))


@pytest.mark.parametrize("metric", list(METRICS))
@pytest.mark.parametrize("model_units", [False, True])
def test_a_mesh_has_the_error_that_it_has_alone_whatever_stands_beside(
    irregular, metric, model_units
):
    evaluator = metrics_in(model_units=model_units)[metric].evaluator(irregular)
    noisy = [add_noise(irregular, 0.1, seed=k).vertices for k in range(WIDTH - 1)]
    meshes = [irregular.vertices, *noisy]
    alone = [evaluator.value(vertices) for vertices in meshes]
    assert alone[0] == 0
    for count in range(2, WIDTH + 1):
        values = evaluator.values(side_by_side(meshes[:count]))
        assert values[:count].tolist() == alone[:count]
    assert evaluator.values(side_by_side(meshes[::-1])).tolist() == alone[::-1]
