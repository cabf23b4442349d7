"""Every method, metric, field and statistic is defined on every defect that the doctor knows."""

from itertools import islice

import numpy as np
import pytest

from core import mesh_statistics, scalar_field, skeletal_graph
from core.fields import FIELDS
from core.mesh import TriangleMesh, primitives
from core.metrics import METRICS
from core.noise import add_noise
from core.smoothing import METHODS

CASES = (
    "needle", "cap", "twice", "torn", "isolated", "book", "bow_tie", "turned", "inside_out",
    "moebius", "speck", "holed",
)  # fmt: skip
every_case = pytest.mark.parametrize("case", CASES)
every_method = pytest.mark.parametrize("method", METHODS)


def last(mesh, method, iterations=3):
    steps = METHODS[method].steps(mesh, METHODS[method].params())
    return list(islice(steps, iterations))[-1]


@every_case
@every_method
@pytest.mark.parametrize("sigma", [0.0, 0.1])
def test_methods_stay_finite(defective, case, method, sigma):
    assert np.isfinite(last(add_noise(defective(case), sigma), method)).all()


@every_method
def test_a_vertex_without_neighbours_stays_where_it_is(defective, method):
    mesh = defective("isolated")
    assert np.array_equal(last(mesh, method)[-2:], mesh.vertices[-2:])


@pytest.mark.parametrize("method", [id_ for id_ in METHODS if id_ != "diffusion"])
def test_a_vertex_without_neighbours_does_not_move_the_others(defective, method):
    alone = primitives.tetrahedron()
    together = last(defective("isolated"), method)[:4]
    assert np.allclose(together, last(alone, method), atol=1e-12)


@every_method
def test_the_side_that_faces_outwards_makes_no_difference(defective, method):
    mesh = add_noise(primitives.sphere(1), 0.1)
    turned = TriangleMesh(mesh.vertices, defective("inside_out").faces)
    assert np.allclose(last(turned, method), last(mesh, method), atol=1e-12)


@pytest.mark.parametrize("method", ["laplacian", "weighted_laplacian", "diffusion"])
def test_mixed_winding_makes_no_difference_where_no_normals_are_used(defective, method):
    mesh = add_noise(primitives.sphere(1), 0.1)
    mixed = TriangleMesh(mesh.vertices, defective("turned").faces)
    assert np.allclose(last(mixed, method), last(mesh, method), atol=1e-12)


@every_case
@pytest.mark.parametrize("metric", METRICS)
def test_metrics_stay_finite(defective, case, metric):
    original = defective(case)
    noisy = add_noise(original, 0.1)
    evaluator = METRICS[metric].evaluator(original)
    assert np.isfinite(evaluator.value(noisy.vertices))
    assert np.isfinite(evaluator.elements(noisy.vertices)).all()
    assert evaluator.value(original.vertices) == pytest.approx(0, abs=1e-6)


@every_case
@pytest.mark.parametrize("field", FIELDS)
def test_fields_and_graphs_are_defined(defective, case, field):
    mesh = defective(case)
    assert np.isfinite(scalar_field(mesh, field).values).all()
    graph = skeletal_graph(mesh, field, 5)
    assert np.isfinite(graph.nodes).all()


@every_case
def test_statistics_are_defined(defective, case):
    statistics = mesh_statistics(defective(case))
    assert statistics is not None


@every_case
@pytest.mark.parametrize(
    ("method", "params"),
    [
        ("weighted_laplacian", {"clamp_negative": False}),
        ("diffusion", {"form": "printed"}),
        ("diffusion", {"form": "printed", "raw_units": True}),
        ("bilateral", {"sigma_c": 0.5, "sigma_s": 0.1}),
    ],
)
def test_other_forms_stay_finite_too(defective, case, method, params):
    mesh, spec = add_noise(defective(case), 0.1), METHODS[method]
    positions = next(iter(spec.steps(mesh, spec.params(**params))))
    assert np.isfinite(positions).all()
    alone = mesh.degrees == 0
    assert np.allclose(positions[alone], mesh.vertices[alone], atol=1e-12)
