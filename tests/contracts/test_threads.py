"""Results do not depend on the number of threads, beyond rounding."""

import numba
import numpy as np
import pytest

from core.doctor import REPAIRS, examine, repair
from core.fields import FIELDS, critical_vertices, scalar_field
from core.mesh import TriangleMesh, primitives
from core.metrics import METRICS
from core.noise import add_noise
from core.skeleton import level_curves, reeb_graph, skeletal_graph
from core.smoothing import METHODS, DivergenceGuard, smooth
from core.statistics import GeodesicParams, mesh_statistics

THREADS = (1, 2)


@pytest.fixture(autouse=True)
def _usual_threads():
    usual = numba.get_num_threads()
    yield
    numba.set_num_threads(usual)


def fresh(name: str) -> TriangleMesh:
    """A mesh whose connectivity is not computed yet: that depends on threads, too."""
    make = {"ball": lambda: primitives.sphere(4), "torus": lambda: primitives.torus(60, 40)}
    mesh = make.get(name, primitives.torus)()
    return TriangleMesh(add_noise(mesh, sigma=0.1, seed=2).vertices, mesh.faces)


def with_each_number_of_threads(compute):
    """Compute with one thread, then with more."""
    if numba.config.NUMBA_NUM_THREADS < 2:
        pytest.skip("this machine has one core")
    results = []
    for count in THREADS:
        numba.set_num_threads(count)
        results.append(compute())
    first, *others = results
    return [(first, other) for other in others]


@pytest.mark.parametrize("name", ["ball", "torus"])
@pytest.mark.parametrize("method", METHODS)
def test_methods(method, name):
    for one, more in with_each_number_of_threads(lambda: smooth(fresh(name), method, 3).vertices):
        assert more == pytest.approx(one, abs=1e-12)


@pytest.mark.parametrize("metric", METRICS)
def test_metrics(metric):
    places = add_noise(fresh("ball"), sigma=0.1, seed=5).vertices

    def measure():
        evaluator = METRICS[metric].evaluator(fresh("ball"))
        return evaluator.value(places), evaluator.elements(places)

    for one, more in with_each_number_of_threads(measure):
        assert more[0] == pytest.approx(one[0], rel=1e-12)
        assert more[1] == pytest.approx(one[1], rel=1e-12)


@pytest.mark.parametrize("field", FIELDS)
def test_fields_and_skeletons(field):
    def draw():
        mesh = fresh("torus")
        values = scalar_field(mesh, field)
        graph, reeb = skeletal_graph(mesh, field, 13), reeb_graph(mesh, values)
        curves = level_curves(mesh, values, np.array([0.25, 0.5]))
        critical = critical_vertices(mesh, values.values)
        exact = (graph.arcs, graph.band, reeb.arcs, reeb.vertices, critical.index, values.values)
        return exact, (graph.nodes, graph.area, curves.points)

    for one, more in with_each_number_of_threads(draw):
        assert all(np.array_equal(a, b) for a, b in zip(one[0], more[0], strict=True))
        for a, b in zip(one[1], more[1], strict=True):
            assert b == pytest.approx(a, abs=1e-12)


def test_statistics():
    def compute():
        found = mesh_statistics(fresh("small"), GeodesicParams(sources=20))
        tables = (found.degree, found.assortativity, found.clustering)
        return [dict(table) for table in tables], found.spectrum, found.geodesic

    for one, more in with_each_number_of_threads(compute):
        for a, b in zip(one[0], more[0], strict=True):
            assert b == pytest.approx(a, rel=1e-12)
        assert arrays_of(one[1:]) == pytest.approx(arrays_of(more[1:]), rel=1e-6, abs=1e-9)


def arrays_of(parts):
    """All numbers of what is made of arrays and numbers."""
    numbers = []
    for part in parts:
        for value in vars(part).values():
            if isinstance(value, np.ndarray) and value.dtype.kind in "fi":
                numbers += value.ravel().tolist()
            elif isinstance(value, int | float):
                numbers.append(value)
    return np.array(numbers, float)


def test_the_doctor():
    def look():
        mesh = fresh("ball")
        holed = TriangleMesh(mesh.vertices, np.delete(mesh.faces, np.s_[::50], axis=0))
        repairs = [repair(holed, id_) for id_ in REPAIRS]
        return examine(holed), [(done.changes, done.mesh.faces.tolist()) for done in repairs]

    for (one, repairs), (more, others) in with_each_number_of_threads(look):
        assert [f.found.text for f in more.findings] == [f.found.text for f in one.findings]
        assert others == repairs


def test_topology_and_the_guard():
    def look():
        mesh = fresh("ball")
        topology = mesh.topology
        tables = (*topology.vertex_ring, *topology.face_ring, topology.edges, topology.face_edges)
        grown = [DivergenceGuard(mesh).allows(mesh.vertices * k) for k in (1, 2, 4)]
        return tables, grown, topology.genus

    for one, more in with_each_number_of_threads(look):
        assert all(np.array_equal(a, b) for a, b in zip(one[0], more[0], strict=True))
        assert one[1:] == more[1:]
