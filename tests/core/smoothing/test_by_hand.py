"""Each method on a case solved by hand, and where the printed thesis fails."""

import numpy as np
import pytest

from core.mesh import TriangleMesh, primitives
from core.mesh.geometry import face_normals
from core.mesh.gradient import set_cauchy_weights
from core.noise import add_noise
from core.parameters import ParameterError
from core.smoothing import METHODS, DivergenceError, smooth
from core.smoothing.divergence import DivergenceGuard

# A square pyramid: tip 4 at height 1 over the centre of a square of side 2.
PYRAMID = TriangleMesh(
    [[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [0, 0, 1]],
    [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
)


def tip(method, **params):
    return smooth(PYRAMID, method, 1, **params).vertices[4]


def test_laplacian_moves_the_tip_into_the_square():
    assert tip("laplacian") == pytest.approx([0, 0, 0])
    assert tip("laplacian", step=0.25) == pytest.approx([0, 0, 0.75])


def test_weighted_laplacian_moves_the_tip_straight_down():
    # By symmetry all four weights are equal.
    assert tip("weighted_laplacian") == pytest.approx([0, 0, 0])


def test_weighted_laplacian_weights_by_cotangents():
    # Vertex 0 of one right triangle: cot 45° = 1 over each leg's opposite angle.
    triangle = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    moved = smooth(triangle, "weighted_laplacian", 1).vertices
    assert moved[0] == pytest.approx([0.5, 0.5, 0])
    # Vertex 1: the hypotenuse has weight cot 90° = 0, so it moves to vertex 0.
    assert moved[1] == pytest.approx([0, 0, 0])


def test_mean_filter_by_hand():
    # The mean of the other three normals of the pyramid, then the move of the tip: by symmetry
    # along z by the mean of ⟨c − v, m⟩ m over the four equal faces.
    normals = np.array([[0, 1, 1], [-1, 0, 1], [0, -1, 1], [1, 0, 1]]) / np.sqrt(2)
    means = normals.sum(axis=0) - normals
    means /= np.linalg.norm(means, axis=1, keepdims=True)
    centroids = PYRAMID.vertices[PYRAMID.faces].mean(axis=1)
    heights = np.einsum("tx,tx->t", centroids - [0, 0, 1], means)
    expected = np.array([0, 0, 1]) + (heights[:, None] * means).mean(axis=0)
    assert tip("mean") == pytest.approx(expected)


def test_median_takes_the_lower_middle_angle(median_faces):
    # Face 0 of a strip folded by 10, 30 and 50 degrees has three neighbours at vertex 0 and 1.
    angles = np.radians([0, 10, 30, 50, 90])
    rim = np.stack([np.zeros(5), np.cumsum(np.cos(angles)), np.cumsum(np.sin(angles))], axis=1)
    vertices = np.concatenate([[[1, 0, 0]], rim])
    faces = [[0, i, i + 1] for i in range(1, 5)]
    fan = TriangleMesh(vertices, faces)
    normals = face_normals(fan)
    ring = fan.topology.face_ring
    cosines = normals[ring.row(0)] @ normals[0]
    middle = ring.row(0)[np.argsort(-cosines)[1]]
    assert median_faces(fan)[0] == middle


def test_bilateral_moves_the_tip_towards_the_square():
    # All heights are −1 and all weights equal, so the tip moves by exactly −1.
    assert tip("bilateral", sigma_c=1.0, sigma_s=1.0) == pytest.approx([0, 0, 0])


def test_bilateral_does_not_depend_on_the_winding(ball):
    noisy = add_noise(ball, 0.1)
    turned = TriangleMesh(noisy.vertices, noisy.faces[:, ::-1])
    assert smooth(turned, "bilateral", 2).vertices == pytest.approx(
        smooth(noisy, "bilateral", 2).vertices
    )


def test_diffusion_by_hand():
    # κ = 2 mean edge lengths; the tip has degree 4, the corners 3.
    scale = 2 / PYRAMID.mean_edge_length
    c = 2.3849
    top = 1 / (1 + scale**2 * (4 * 3 / 4) / c**2)
    corner = 1 / (1 + scale**2 * ((4 + 4 + 3) / 3) / c**2)
    drop = 4 * (top + corner) / np.sqrt(12)
    assert tip("diffusion", gradient_scale=2.0) == pytest.approx([0, 0, 1 - drop])


def test_printed_and_invariant_diffusion_agree_where_degrees_do():
    noisy = add_noise(primitives.torus(12, 8), 0.1)
    printed = smooth(noisy, "diffusion", 3, form="printed").vertices
    assert printed == pytest.approx(smooth(noisy, "diffusion", 3).vertices)


def test_printed_diffusion_depends_on_the_origin(ball):
    noisy = add_noise(ball, 0.1)
    moved = noisy.with_vertices(noisy.vertices + 5)
    here = smooth(noisy, "diffusion", 1, form="printed", raw_units=True).vertices
    there = smooth(moved, "diffusion", 1, form="printed", raw_units=True).vertices
    assert np.abs(there - 5 - here).max() > 0.01


def test_gradient_weights_fall_with_scale(ball):
    ring = ball.topology.vertex_ring
    small, large = np.empty(len(ball.vertices)), np.empty(len(ball.vertices))
    set_cauchy_weights(ball.vertices, *ring, 1.0, 2.3849, small)
    set_cauchy_weights(ball.vertices, *ring, 10.0, 2.3849, large)
    assert (large < small).all()
    assert small.max() <= 1


def test_guard_stops_nan_far_vertices_and_growing_edges(ball):
    guard = DivergenceGuard(ball)
    assert guard.allows(ball.vertices)
    with_nan = ball.vertices.copy()
    with_nan[3, 1] = np.nan
    assert not guard.allows(with_nan)
    far = ball.vertices.copy()
    far[0, 0] = 11
    assert not guard.allows(far)
    assert guard.allows(np.where(far == 11, 9, far))
    shuffled = np.random.default_rng(0).permutation(ball.vertices)
    assert not guard.allows(shuffled)


def test_divergence_names_the_iteration(monkeypatch, ball):
    def explode(mesh, params):
        for factor in (1, 2, 20):
            yield mesh.vertices * factor

    spec = METHODS["laplacian"]
    monkeypatch.setitem(METHODS, "laplacian", type(spec)(**{**vars(spec), "steps": explode}))
    with pytest.raises(DivergenceError, match="diverged at iteration 3"):
        smooth(ball, "laplacian", 5)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("magic", 1), "magic is not a method; allowed: weighted_laplacian, mean, median"),
        (("laplacian", -1), "iterations=-1 is not allowed"),
    ],
)
def test_wrong_words_are_refused(ball, arguments, message):
    with pytest.raises(ParameterError, match=message):
        smooth(ball, *arguments)


def test_results_do_not_depend_on_the_number_of_threads():
    import numba

    noisy = add_noise(primitives.sphere(3), 0.1)
    results = {}
    before = numba.get_num_threads()
    for threads in (1, before):
        numba.set_num_threads(threads)
        results[threads] = [smooth(noisy, method, 3).vertices for method in METHODS]
    numba.set_num_threads(before)
    for one, many in zip(results[1], results[before], strict=True):
        assert np.array_equal(one, many)
