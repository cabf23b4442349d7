"""Cost of an iteration, a metric and the set-up, as multiples of one unit.

The unit is one product of the mesh's CSR adjacency matrix with its (m, 3) array of vertices by
scipy, on the same mesh in the same run: ``make bench`` prints the ratios as ``units``.
"""

import time
from pathlib import Path

import pytest

from core.io import load_mesh
from core.mesh import TriangleMesh, primitives
from core.metrics import METRICS
from core.noise import add_noise
from core.smoothing import METHODS, DivergenceGuard

_ROUNDS = 30


@pytest.fixture(scope="module")
def noisy():
    """The thesis' cow where it is at hand, else a sphere of about the same size."""
    path = Path(__file__).resolve().parents[3] / "shared" / "models" / "cow_92864.ply"
    return add_noise(load_mesh(path) if path.exists() else primitives.sphere(6))


def unit_seconds(mesh: TriangleMesh) -> float:
    """Lower quartile of the unit's time: what it costs when nothing else disturbs it."""
    adjacency, vertices = mesh.topology.adjacency, mesh.vertices
    times = []
    for _ in range(_ROUNDS):
        started = time.perf_counter()
        adjacency @ vertices
        times.append(time.perf_counter() - started)
    return sorted(times)[_ROUNDS // 4]


def measure(benchmark, mesh, call):
    """Run a call many times and note its lower quartile in units."""
    call()
    benchmark.pedantic(call, rounds=_ROUNDS, iterations=1)
    lower = sorted(benchmark.stats.stats.data)[_ROUNDS // 4]
    benchmark.extra_info["units"] = round(lower / unit_seconds(mesh), 2)


@pytest.mark.parametrize("method", list(METHODS))
def test_iteration(benchmark, noisy, method):
    spec = METHODS[method]
    steps = spec.steps(noisy, spec.params())
    measure(benchmark, noisy, lambda: next(steps))


@pytest.mark.parametrize("metric", list(METRICS))
def test_metric(benchmark, noisy, metric):
    evaluator = METRICS[metric].evaluator(noisy)
    moved = noisy.vertices * 1.001
    measure(benchmark, noisy, lambda: evaluator.value(moved))


def test_divergence_guard(benchmark, noisy):
    guard = DivergenceGuard(noisy)
    measure(benchmark, noisy, lambda: guard.allows(noisy.vertices))


def test_set_up(benchmark, noisy):
    def set_up():
        topology = TriangleMesh(noisy.vertices, noisy.faces).topology
        return topology.face_ring, topology.edge_corners, topology.ring_edges, topology.genus

    measure(benchmark, noisy, set_up)
