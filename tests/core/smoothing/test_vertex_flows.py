"""The methods that need no normals, kernel by kernel, against their formulas in plain numpy."""

import numpy as np
import pytest

from core.kernels import unsigned
from core.mesh.gradient import inverse_roots, printed_cauchy_weights, set_cauchy_weights
from core.noise import add_noise
from core.smoothing import diffusion, laplacian, weighted_laplacian


def test_laplacian(irregular, plain, first_step):
    v = irregular.vertices
    expected = plain.moved(lambda i, ring: 0.7 * (v[ring] - v[i]).mean(axis=0))
    assert first_step(irregular, "laplacian", step=0.7) == pytest.approx(expected)


def cotangent_matrix(plain, *, clamp):
    """cot α + cot β of each edge."""
    mesh = plain.mesh
    weights = np.zeros((len(mesh.vertices),) * 2)
    for face, area in zip(mesh.faces, plain.areas, strict=True):
        for c in range(3):
            i, j, apex = np.roll(face, c)
            a, b = mesh.vertices[i] - mesh.vertices[apex], mesh.vertices[j] - mesh.vertices[apex]
            cotangent = a @ b / (2 * area) if area > 0 else 0
            weights[i, j] += cotangent
            weights[j, i] += cotangent
    return np.maximum(weights, 0) if clamp else weights


def test_cotangents_belong_to_angles_of_a_triangle(irregular, plain):
    cotangents = np.empty((len(irregular.faces), 3))
    weighted_laplacian.set_cotangents(irregular.vertices, irregular.faces, cotangents)
    flat = plain.areas == 0
    assert (cotangents[flat] == 0).all()
    assert np.arctan2(1, cotangents[~flat]).sum(axis=1) == pytest.approx(np.pi)


@pytest.mark.parametrize("clamp", [True, False])
def test_weighted_laplacian(irregular, plain, first_step, clamp):
    weights, v = cotangent_matrix(plain, clamp=clamp), irregular.vertices

    def move(i, ring):
        total = weights[i, ring].sum()
        return 0.5 * weights[i, ring] @ (v[ring] - v[i]) / total if total != 0 else 0

    ours = first_step(irregular, "weighted_laplacian", clamp_negative=clamp, step=0.5)
    assert ours == pytest.approx(plain.moved(move), rel=1e-6, abs=1e-6)


def test_cauchy_weights(irregular, plain):
    ring, roots = irregular.topology.vertex_ring, inverse_roots(irregular.degrees)
    v, ours = irregular.vertices, np.empty(len(irregular.vertices))
    invariant = 1 / (1 + 9 * plain.squared_gradients(printed=False) / 4)
    set_cauchy_weights(v, *ring, 3.0, 2.0, ours)
    assert ours == pytest.approx(invariant)
    printed = 1 / (1 + 9 * plain.squared_gradients(printed=True) / 4)
    assert printed_cauchy_weights(v, *ring, roots, 3.0, 2.0) == pytest.approx(printed)


@pytest.mark.parametrize("form", ["invariant", "printed"])
def test_diffusion(irregular, plain_of, first_step, form):
    centre = irregular.vertices.mean(axis=0)
    plain = plain_of(irregular.with_vertices(irregular.vertices - centre))
    v, d = plain.mesh.vertices, irregular.degrees
    scale = (3 / irregular.mean_edge_length) ** 2
    g = 1 / (1 + scale * plain.squared_gradients(printed=form == "printed") / 2.3849**2)

    def move(i, ring):
        weights = (g[i] + g[ring])[:, None]
        if form == "printed":
            terms = v[ring] / np.sqrt(d[ring])[:, None] - v[i] / np.sqrt(d[i])
            return (weights * terms).sum(axis=0) / np.sqrt(d[i])
        return (weights * (v[ring] - v[i]) / np.sqrt(d[i] * d[ring])[:, None]).sum(axis=0)

    ours = first_step(irregular, "diffusion", gradient_scale=3.0, form=form)
    assert ours - centre == pytest.approx(plain.moved(move))


def test_diffusion_of_a_mesh_far_away(ball):
    here = add_noise(ball, 0.1)
    there = here.with_vertices(here.vertices + 1e6)
    params = diffusion.DiffusionParams()
    moved = next(diffusion.steps(there, params)) - 1e6
    assert moved == pytest.approx(next(diffusion.steps(here, params)), abs=1e-9)


def test_unsigned_views_share_their_memory(irregular):
    ring = irregular.topology.vertex_ring
    starts, items = unsigned(*ring)
    assert items.dtype == np.uint32
    assert np.shares_memory(items, ring.items)
    plain = laplacian._move_to_ring_mean(irregular.vertices, *ring, 1.0)
    ours = laplacian._move_to_ring_mean(irregular.vertices, starts, items, 1.0)
    assert np.array_equal(plain, ours)
