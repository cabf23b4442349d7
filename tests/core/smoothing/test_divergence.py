"""The divergence guard against its promise written out."""

import numpy as np
import pytest

from core.smoothing.divergence import DivergenceGuard, _reach_and_growth, _total_length


def allowed(mesh, vertices):
    """What the guard promises, written out."""
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    reach = 10 * (high - low).max() / 2
    ends, moved = mesh.vertices[mesh.edges], vertices[mesh.edges]
    before = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum()
    after = np.linalg.norm(moved[:, 0] - moved[:, 1], axis=1).sum()
    inside = np.abs(vertices - (low + high) / 2).max() <= reach
    return bool(np.isfinite(vertices).all() and inside and after <= 3 * before)


@pytest.mark.parametrize("scale", [1e-12, 1, 1e12])
def test_guard_keeps_its_promise_at_any_size(irregular, scale):
    start = irregular.with_vertices(scale * irregular.vertices + 100 * scale)
    guard = DivergenceGuard(start)
    random = np.random.default_rng(1)
    verdicts = set()
    for amplitude in np.geomspace(0.01, 30, 40) * start.mean_edge_length:
        vertices = start.vertices + amplitude * random.normal(size=start.vertices.shape)
        assert guard.allows(vertices) == allowed(start, vertices)
        verdicts.add(guard.allows(vertices))
    assert verdicts == {True, False}


def test_guard_allows_what_moved_far_but_did_not_grow(irregular):
    size = np.ptp(irregular.vertices, axis=0).max()
    assert DivergenceGuard(irregular).allows(irregular.vertices + 4 * size)
    assert not DivergenceGuard(irregular).allows(irregular.vertices + 6 * size)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_guard_sees_every_coordinate(irregular, bad):
    guard = DivergenceGuard(irregular)
    for x in range(3):
        vertices = irregular.vertices.copy()
        vertices[-1, x] = bad
        assert not guard.allows(vertices)


def test_edges_grow_by_no_more_than_the_guard_says(irregular):
    moved = irregular.vertices + np.random.default_rng(3).normal(size=irregular.vertices.shape)
    growth = _reach_and_growth(moved, irregular.vertices, irregular.degrees, np.zeros(3), np.inf)[1]
    longer = _total_length(moved, irregular.edges) - _total_length(
        irregular.vertices, irregular.edges
    )
    distances = np.linalg.norm(moved - irregular.vertices, axis=1)
    assert growth == pytest.approx(irregular.degrees @ distances)
    assert longer <= growth
