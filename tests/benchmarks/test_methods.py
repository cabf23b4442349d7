"""Cost of an iteration, of a metric, of the guard, and of all of them together, in units.

All is measured as a study runs it, in numbers that follow the surface.
"""

from itertools import islice

import pytest

from core.comparison import Comparison
from core.lanes import WIDTH, side_by_side
from core.metrics import METRICS
from core.noise import add_noise
from core.smoothing import METHODS, DivergenceGuard
from core.snapshots import iterations
from core.study import MethodChoice


@pytest.fixture(scope="module")
def comparison(original):
    return Comparison(original, add_noise(original))


@pytest.fixture
def noisy(noisy):
    return noisy.along_surface()


@pytest.mark.parametrize("method", list(METHODS))
def test_iteration(benchmark, ruler, noisy, method):
    spec = METHODS[method]
    steps = spec.steps(noisy, spec.params())
    ruler.measure(benchmark, lambda: next(steps))


@pytest.fixture
def snapshots(noisy):
    """Eight iterations, as a run measures them together."""
    spec = METHODS["laplacian"]
    return list(islice(spec.steps(noisy, spec.params()), WIDTH))


@pytest.mark.parametrize("metric", list(METRICS))
def test_metric(benchmark, ruler, original, snapshots, metric):
    evaluator = METRICS[metric].evaluator(original.along_surface())
    positions = side_by_side(snapshots)
    ruler.measure(benchmark, lambda: evaluator.values(positions), of=WIDTH)


@pytest.mark.parametrize("metric", list(METRICS))
def test_metric_of_one(benchmark, ruler, original, noisy, metric):
    evaluator = METRICS[metric].evaluator(original.along_surface())
    ruler.measure(benchmark, lambda: evaluator.value(noisy.vertices))


def test_side_by_side(benchmark, ruler, snapshots):
    room = side_by_side(snapshots)
    ruler.measure(benchmark, lambda: side_by_side(snapshots, room), of=WIDTH)


def test_divergence_guard(benchmark, ruler, noisy):
    guard = DivergenceGuard(noisy)
    ruler.measure(benchmark, lambda: guard.allows(noisy.vertices))


def take(steps):
    """Go on until so many iterations are there as are measured together."""
    there = 0
    while there < WIDTH:
        there += next(steps) is not None


@pytest.mark.parametrize("method", list(METHODS))
def test_iteration_with_errors(benchmark, ruler, comparison, method):
    """What a run for the plot costs: an iteration, the guard and every metric.

    Also how many times as long it takes as without the metrics, in turns.
    """
    choice = MethodChoice(method=method)
    plain, full = iterations(comparison.noisy, choice), comparison.snapshots(choice, lambda: 10**6)
    take(plain)
    ruler.measure(benchmark, lambda: take(full), of=WIDTH)
    ruler.compare(benchmark, "without errors", lambda: take(full), lambda: take(plain))
