"""Statistics computed in a process of their own are those computed in this one."""

import numpy as np
import pytest

from core.mesh import TriangleMesh, primitives
from core.statistics import (
    GeodesicParams,
    SpectrumParams,
    StatisticsError,
    finished,
    geodesic_sources,
    geodesic_steps,
    spectrum,
    spectrum_steps,
)

SURFACE = GeodesicParams(along="surface", sources=20)


@pytest.fixture
def everything_apart(monkeypatch):
    def switch(on):
        for module in (geodesic_sources, spectrum):
            monkeypatch.setattr(module, "_SMALL", -1 if on else 10**9)

    return switch


def both(everything_apart, steps):
    for apart in (False, True):
        everything_apart(apart)
        yield finished(steps())


def test_distances_along_the_surface(everything_apart, ball):
    here, apart = both(everything_apart, lambda: geodesic_steps(ball, SURFACE))
    assert np.array_equal(here.histogram.counts, apart.histogram.counts)
    assert (here.mean, here.longest, here.pairs) == pytest.approx(
        (apart.mean, apart.longest, apart.pairs), rel=1e-12
    )


@pytest.mark.parametrize("matrix", ["laplacian", "normalized_laplacian"])
@pytest.mark.parametrize("dense_limit", [0, 4000])
def test_spectrum(everything_apart, ball, matrix, dense_limit):
    params = SpectrumParams(matrix=matrix, dense_limit=dense_limit)
    here, apart = both(everything_apart, lambda: spectrum_steps(ball, params))
    for name in ("eigenvalues", "low", "high", "smallest", "largest"):
        assert np.allclose(getattr(here, name), getattr(apart, name), atol=1e-9)


def test_a_process_that_is_slow_to_end_loses_no_result(everything_apart, monkeypatch, ball):
    def slow(steps, *arguments):
        for found in steps(*arguments):
            yield from (None, found, None)

    everything_apart(True)
    params = SpectrumParams(dense_limit=0)
    plain = finished(spectrum_steps(ball, params))
    monkeypatch.setattr(spectrum, "run_apart", slow)
    assert np.allclose(finished(spectrum_steps(ball, params)).largest, plain.largest)


@pytest.mark.parametrize("apart", [False, True])
def test_a_refusal_is_the_same_sentence(everything_apart, apart):
    everything_apart(apart)
    ball = primitives.sphere(1)
    flat = TriangleMesh(np.zeros_like(ball.vertices), ball.faces)
    with pytest.raises(StatisticsError, match=r"^The heat method .* on this mesh\.$"):
        finished(geodesic_steps(flat, SURFACE))


def test_more_chunks_than_sources_are_not_made(monkeypatch, everything_apart, ball):
    from core.statistics import geodesic

    everything_apart(False)
    monkeypatch.setattr(geodesic, "_CHUNK", 1)
    result = finished(geodesic_steps(ball, SURFACE))
    assert (result.sources, result.pairs) == (20, 20 * 641)
