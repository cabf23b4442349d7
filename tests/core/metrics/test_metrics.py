"""Metrics: by hand, against plain numpy, and their invariances."""

import numba
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.mesh import TriangleMesh, primitives
from core.metrics import METRICS, visual_error
from core.noise import add_noise

every_metric = pytest.mark.parametrize("metric", list(METRICS))
TRIANGLE = TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])


def plain_visual_error(original: TriangleMesh, mesh: TriangleMesh) -> float:
    """Equation (12) written out with dense matrices."""
    unit = original.mean_edge_length
    centre = original.vertices.mean(axis=0)
    adjacency = original.topology.adjacency.toarray()
    d = adjacency.sum(axis=1)

    def operator(v):
        scaled = v / np.sqrt(d)[:, None]
        pairs = np.sum((scaled[:, None] - scaled[None]) ** 2, axis=2)
        g = 1 / (1 + (adjacency * pairs).sum(axis=1) / 2.3849**2)
        weights = adjacency * (g[:, None] + g[None])
        return (weights.sum(axis=1)[:, None] * v - weights @ v) / d[:, None]

    a, b = (original.vertices - centre) / unit, (mesh.vertices - centre) / unit
    total = np.sum((a - b) ** 2) + np.sum((operator(a) - operator(b)) ** 2)
    return total / (2 * len(a))


def test_visual_error_agrees_with_the_formula_written_out():
    ball = primitives.sphere(2)
    noisy = add_noise(ball, 0.1)
    assert visual_error(ball, noisy) == pytest.approx(plain_visual_error(ball, noisy))


def test_visual_error_in_model_units_changes_with_the_units(ball):
    noisy = add_noise(ball, 0.1)
    large = ball.with_vertices(100 * ball.vertices)
    noisy_large = ball.with_vertices(100 * noisy.vertices)
    assert visual_error(ball, noisy) == pytest.approx(visual_error(large, noisy_large))
    assert visual_error(ball, noisy, model_units=True) != pytest.approx(
        visual_error(large, noisy_large, model_units=True)
    )


def test_visual_error_refuses_other_meshes(ball):
    with pytest.raises(ValueError, match="4 vertices cannot be compared with the original's 642"):
        visual_error(ball, primitives.tetrahedron())


def test_vertex_rms_by_hand():
    # The mean edge length is 4; one of three vertices moves by 6: sqrt(36/3)/4.
    moved = TRIANGLE.vertices + np.array([[0, 0, 6], [0, 0, 0], [0, 0, 0]])
    evaluator = METRICS["vertex_rms"].evaluator(TRIANGLE)
    assert evaluator.value(moved) == pytest.approx(np.sqrt(12) / 4)
    assert evaluator.elements(moved).tolist() == [1.5, 0, 0]


def test_normal_angle_by_hand():
    # Turning about the leg along x by 30 degrees turns the normal by 30 degrees.
    turned = TRIANGLE.vertices @ Rotation.from_euler("x", 30, degrees=True).as_matrix().T
    evaluator = METRICS["normal_angle"].evaluator(TRIANGLE)
    assert evaluator.value(turned) == pytest.approx(30)
    flipped = TRIANGLE.vertices * [1, -1, 1]
    assert evaluator.value(flipped) == pytest.approx(180)
    assert evaluator.value(0 * flipped) == 0


@pytest.mark.parametrize("metric", ["visual_error", "normal_angle"])
@pytest.mark.parametrize("mesh", [primitives.torus(23, 17), TRIANGLE], ids=["torus", "triangle"])
def test_is_the_mean_of_its_elements(metric, mesh):
    evaluator = METRICS[metric].evaluator(mesh)
    moved = add_noise(mesh, 0.2).vertices
    assert evaluator.value(moved) == pytest.approx(evaluator.elements(moved).mean(), rel=1e-12)


@every_metric
def test_does_not_depend_on_the_number_of_threads(metric, ball):
    evaluator = METRICS[metric].evaluator(ball)
    vertices = add_noise(ball).vertices
    here = evaluator.value(vertices)
    before = numba.get_num_threads()
    numba.set_num_threads(1)
    alone = evaluator.value(vertices)
    numba.set_num_threads(before)
    assert alone == pytest.approx(here, rel=1e-12)


@every_metric
def test_is_zero_for_equal_meshes_and_positive_otherwise(metric, ball):
    evaluator = METRICS[metric].evaluator(ball)
    assert evaluator.value(ball.vertices) == 0
    assert evaluator.value(add_noise(ball).vertices) > 0


@every_metric
def test_elements_belong_to_what_is_declared(metric, ball):
    spec = METRICS[metric]
    elements = spec.evaluator(ball).elements(add_noise(ball).vertices)
    assert len(elements) == len(ball.vertices if spec.elements_on == "vertex" else ball.faces)
    assert (elements >= 0).all()


@every_metric
def test_does_not_depend_on_place_turn_and_size(metric, ball):
    noisy = add_noise(ball, 0.05)
    turn = Rotation.from_euler("xyz", [10, 20, 30], degrees=True).as_matrix()

    def place(points):
        return 1e3 * points @ turn.T + [5, -7, 9]

    here = METRICS[metric].evaluator(ball).value(noisy.vertices)
    moved = ball.with_vertices(place(ball.vertices))
    there = METRICS[metric].evaluator(moved).value(place(noisy.vertices))
    assert there == pytest.approx(here, rel=1e-6)


@every_metric
def test_grows_with_the_noise(metric, ball):
    evaluator = METRICS[metric].evaluator(ball)
    errors = [evaluator.value(add_noise(ball, sigma).vertices) for sigma in (0.01, 0.05, 0.2)]
    assert errors == sorted(errors)
