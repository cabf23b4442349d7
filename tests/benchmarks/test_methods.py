"""Cost of an iteration, of a metric, of the guard, and of all of them together, in units.

All is measured as a study runs it, in numbers that follow the surface.
"""

import pytest

from core.metrics import METRICS
from core.smoothing import METHODS, DivergenceGuard


@pytest.fixture
def noisy(noisy):
    return noisy.along_surface()


@pytest.mark.parametrize("method", list(METHODS))
def test_iteration(benchmark, ruler, noisy, method):
    spec = METHODS[method]
    steps = spec.steps(noisy, spec.params())
    ruler.measure(benchmark, lambda: next(steps))


@pytest.mark.parametrize("metric", list(METRICS))
def test_metric(benchmark, ruler, original, noisy, metric):
    evaluator = METRICS[metric].evaluator(original.along_surface())
    ruler.measure(benchmark, lambda: evaluator.value(noisy.vertices))


def test_divergence_guard(benchmark, ruler, noisy):
    guard = DivergenceGuard(noisy)
    ruler.measure(benchmark, lambda: guard.allows(noisy.vertices))


@pytest.mark.parametrize("method", list(METHODS))
def test_iteration_with_errors(benchmark, ruler, original, noisy, method):
    """What a run for the plot costs: an iteration, the guard and every metric."""
    spec = METHODS[method]
    steps = spec.steps(noisy, spec.params())
    guard = DivergenceGuard(noisy)
    evaluators = [metric.evaluator(original.along_surface()) for metric in METRICS.values()]

    def step():
        vertices = next(steps)
        guard.allows(vertices)
        for evaluator in evaluators:
            evaluator.value(vertices)

    ruler.measure(benchmark, step)
