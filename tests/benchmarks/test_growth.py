"""Cost a face of one iteration on a mesh of over a million faces, against one of 92,864.

Both are measured as a study runs them, in numbers that follow the surface. The large mesh is the
small one with every face split in sixteen, numbered as splitting leaves it: far from the surface.
"""

from dataclasses import replace
from statistics import median
from time import process_time
from timeit import repeat

import pytest

from core.lanes import WIDTH, side_by_side
from core.mesh.remesh import midpoint_subdivision
from core.metrics import METRICS
from core.noise import add_noise
from core.smoothing import METHODS

_ROUNDS = 9


@pytest.fixture(scope="module")
def large(original):
    return midpoint_subdivision(midpoint_subdivision(original))


@pytest.fixture(scope="module")
def pair(original, large):
    """Noisy meshes of both sizes."""
    return add_noise(original).along_surface(), add_noise(large).along_surface()


@pytest.fixture
def measure_growth(benchmark, ruler, pair):
    """Measure what is made of either mesh, and note the cost a face against the small one.

    Once by the clock, and once in processor time, which other programs disturb less.
    """

    def measure(prepare):
        small, large = pair
        faces = len(large.faces) / len(small.faces)
        call, larger = prepare(small), prepare(large)
        replace(ruler, mesh=large, units=[]).measure(benchmark, larger, _ROUNDS)
        few = min(repeat(call, number=1, repeat=5 * _ROUNDS))
        growth = min(benchmark.stats.stats.data) / few / faces
        few, many = processor_time(call, 5 * _ROUNDS), processor_time(larger, _ROUNDS)
        benchmark.extra_info["growth"] = round(growth, 2)
        benchmark.extra_info["growth of processor time"] = round(many / few / faces, 2)

    return measure


def processor_time(call, rounds):
    """Median time of a call on all processors together."""
    return median(repeat(call, timer=process_time, number=1, repeat=rounds))


@pytest.mark.parametrize("method", list(METHODS))
def test_growth_of_an_iteration(measure_growth, method):
    spec = METHODS[method]

    def prepare(mesh):
        # A long iteration comes in parts, with None between them.
        iterations = filter(lambda step: step is not None, spec.steps(mesh, spec.params()))
        return lambda: next(iterations)

    measure_growth(prepare)


@pytest.mark.parametrize("metric", list(METRICS))
def test_growth_of_a_metric(measure_growth, metric):
    def prepare(mesh):
        evaluator = METRICS[metric].evaluator(mesh)
        positions = side_by_side([mesh.vertices * 1.001] * WIDTH)
        return lambda: evaluator.values(positions)

    measure_growth(prepare)
