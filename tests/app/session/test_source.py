"""The worker's end of a run, where iterations come in parts."""

from types import SimpleNamespace

import numpy as np

from app.session.run_source import Source, kept_iterations
from core import smooth
from core.comparison import Comparison
from core.mesh import TriangleMesh, primitives
from core.noise import add_noise
from core.study import MethodChoice


def test_what_is_kept_has_the_order_of_the_file():
    ball = primitives.sphere(6)
    order = np.random.default_rng(1).permutation(len(ball.vertices))
    mesh = TriangleMesh(ball.vertices[order] + 100, np.argsort(order)[ball.faces])
    assert mesh.topology.ordering.vertices.order is not None
    noisy, choice = add_noise(mesh), MethodChoice(method="laplacian", iterations=2)
    iterations = filter(None, kept_iterations(Comparison(mesh, noisy), choice, lambda: 2))
    for number in (1, 2):
        kept = next(iterations)
        expected = smooth(noisy, "laplacian", number).vertices - mesh.vertices.mean(axis=0)
        assert kept.iteration == number
        assert kept.position.dtype == np.float32
        assert np.allclose(kept.position, expected, rtol=0, atol=1e-6)


def test_what_was_left_within_an_iteration_goes_on_there():
    one, two = SimpleNamespace(iteration=1), SimpleNamespace(iteration=2)
    source = Source(lambda wanted: iter([None, one, None, two]))
    first = source.advance(lambda: 1)
    assert next(first) is None
    first.close()
    assert list(source.advance(lambda: 2)) == [one, None, two]


def test_a_run_is_told_how_far_it_is_to_go():
    def snapshots(wanted):
        while True:
            yield SimpleNamespace(iteration=wanted())

    source = Source(snapshots)
    assert [step.iteration for step in source.advance(lambda: 3)] == [3]
    assert [step.iteration for step in source.advance(lambda: 5)] == [5]
