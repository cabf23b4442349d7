"""Spectra: closed forms, the two methods against each other, zero eigenvalues."""

import networkx as nx
import numpy as np
import pytest

from core import load_mesh
from core.mesh import TriangleMesh, primitives
from core.mesh.matrices import laplacian_matrix, normalized_laplacian_matrix
from core.statistics import SpectrumParams, extremes, finished, spectrum_steps
from core.statistics import spectrum as spectrum_module
from core.statistics.extremes import largest_steps

MATRICES = ("laplacian", "normalized_laplacian")


def spectrum(mesh, **params):
    return finished(spectrum_steps(mesh, SpectrumParams(**params)))


def joined(*meshes):
    faces, vertices, count = [], [], 0
    for mesh in meshes:
        faces.append(mesh.faces + count)
        vertices.append(mesh.vertices)
        count += len(mesh.vertices)
    return TriangleMesh(np.concatenate(vertices), np.concatenate(faces))


def torus_eigenvalues(around, across):
    """Closed form: the torus of degree 6 is a lattice with periodic ends."""
    a, b = np.meshgrid(np.arange(around) / around, np.arange(across) / across)
    cosines = np.cos(2 * np.pi * a) + np.cos(2 * np.pi * b) + np.cos(2 * np.pi * (a + b))
    return np.sort((6 - 2 * cosines).ravel())[::-1]


def test_tetrahedron_by_hand():
    """The complete graph of 4 vertices: 0 and three times 4."""
    result = spectrum(primitives.tetrahedron())
    assert result.eigenvalues == pytest.approx([4, 4, 4, 0])
    assert result.ranks == pytest.approx([0.125, 0.375, 0.625, 0.875])
    assert result.algebraic_connectivity == pytest.approx(4)
    assert (result.zero_count, result.exact, result.error) == (1, True, 0)
    normalized = spectrum(primitives.tetrahedron(), matrix="normalized_laplacian")
    assert normalized.eigenvalues == pytest.approx([4 / 3, 4 / 3, 4 / 3, 0])


def test_torus_has_its_closed_form():
    result = spectrum(primitives.torus(12, 7))
    assert np.allclose(result.eigenvalues, torus_eigenvalues(12, 7), atol=1e-10)


def test_approximation_covers_the_closed_form():
    exact = torus_eigenvalues(90, 61)
    result = spectrum(primitives.torus(90, 61))
    assert not result.exact
    ranks = (np.arange(len(exact)) + 0.5) / len(exact)
    true = np.interp(result.ranks, ranks, exact)
    assert np.all((result.low <= true + 1e-9) & (true <= result.high + 1e-9))
    assert np.allclose(result.largest, np.sort(exact)[-12:], atol=1e-8)
    assert np.allclose(result.smallest, np.sort(exact)[:12], atol=1e-8)


@pytest.mark.parametrize("matrix", MATRICES)
def test_two_methods_agree_on_the_camel(shared_models, matrix):
    mesh = load_mesh(shared_models / "camel_2444.ply")
    dense = spectrum(mesh, matrix=matrix)
    other = spectrum(mesh, matrix=matrix, dense_limit=0)
    true = np.interp(other.ranks, dense.ranks, dense.eigenvalues)
    assert np.abs(true - other.eigenvalues).max() < 0.01 * dense.largest[-1]
    assert np.mean((other.low <= true + 1e-9) & (true <= other.high + 1e-9)) > 0.99
    assert np.allclose(other.largest, dense.largest, atol=1e-8)
    assert np.allclose(other.smallest, dense.smallest, atol=1e-8)
    assert np.all(np.diff(other.eigenvalues) <= 1e-12)


@pytest.mark.parametrize("matrix", MATRICES)
@pytest.mark.parametrize("dense_limit", [0, 4000])
def test_zero_eigenvalues_count_the_components(matrix, dense_limit):
    mesh = joined(primitives.sphere(2), primitives.torus(), primitives.grid())
    result = spectrum(mesh, matrix=matrix, dense_limit=dense_limit)
    assert result.zero_count == mesh.topology.component_count == 3
    assert result.algebraic_connectivity == 0
    assert result.smallest[3] > 1e-3


@pytest.mark.parametrize("dense_limit", [0, 4000])
def test_many_components_do_not_confuse_the_lanczos_method(dense_limit):
    mesh = joined(*[primitives.tetrahedron()] * 40)
    result = spectrum(mesh, dense_limit=dense_limit)
    assert result.zero_count == 40
    assert np.all(result.smallest == 0)
    assert np.allclose(result.largest, 4)


@pytest.mark.filterwarnings("ignore::FutureWarning")
def test_eigenvalues_agree_with_networkx():
    mesh = TriangleMesh(np.eye(6, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    graph = nx.from_scipy_sparse_array(mesh.topology.adjacency)
    theirs = nx.normalized_laplacian_matrix(graph).toarray()
    ours = spectrum(mesh, matrix="normalized_laplacian")
    assert np.allclose(ours.eigenvalues[::-1], np.linalg.eigvalsh(theirs), atol=1e-12)
    assert ours.zero_count == 2


def test_sum_is_the_trace():
    mesh = primitives.sphere(3)
    assert spectrum(mesh).eigenvalues.sum() == pytest.approx(2 * len(mesh.edges))


def test_same_seed_same_curve():
    mesh = primitives.sphere(3)
    one, same, other = (spectrum(mesh, dense_limit=0, seed=s).eigenvalues for s in (1, 1, 2))
    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)


def test_progress_grows_and_can_be_left():
    shares = [step.share for step in spectrum_steps(primitives.sphere(3))]
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0, 1)
    steps = spectrum_steps(primitives.sphere(3), SpectrumParams(dense_limit=0))
    assert next(steps).value is None
    steps.close()


def fan(rim):
    """A vertex in the middle of a ring of others: the wheel graph."""
    angle = 2 * np.pi * np.arange(rim) / rim
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(rim)], axis=1)
    i = np.arange(rim)
    faces = np.stack([np.zeros(rim, int), 1 + i, 1 + (i + 1) % rim], axis=1)
    return TriangleMesh(np.concatenate([[[0, 0, 1]], ring]), faces)


@pytest.mark.parametrize("matrix", MATRICES)
def test_a_vertex_with_very_many_neighbours_has_its_closed_form(matrix):
    """Its eigenvalue is far from all others, and these are closer together than 1e-5."""
    rim = 1500
    cosines = np.cos(2 * np.pi * np.arange(1, rim) / rim)
    waves, two = (
        (3 - 2 * cosines, [0, rim + 1])
        if matrix == "laplacian"
        else (1 - 2 / 3 * cosines, [0, 4 / 3])
    )
    exact = np.sort([*waves, *two])
    result = spectrum(fan(rim), matrix=matrix, dense_limit=0)
    assert np.allclose(result.largest, exact[-12:], rtol=1e-10, atol=1e-10)
    assert np.allclose(result.smallest, exact[:12], rtol=0, atol=1e-10)


def test_eigenvalues_that_crowd_together_are_told_apart(shared_models):
    """The dense method finds these; the last two are 1e-7 beyond hundreds that are 1.5."""
    strip = load_mesh(shared_models / "thin_strip_8231_open.off")
    *_, (largest, _) = largest_steps(normalized_laplacian_matrix(strip), 12)
    dense = [
        1.500000136260,
        1.500000141433,
        1.500002873399,
        1.500002924147,
        1.500029468483,
        1.500029653157,
        1.500049576620,
        1.500049633103,
        1.529907005606,
        1.529907005606,
        1.529907005606,
        1.529907005606,
    ]
    assert np.allclose(largest, dense, rtol=0, atol=1e-10)


@pytest.mark.parametrize("matrix", MATRICES)
def test_every_copy_of_an_eigenvalue_is_found(matrix):
    ball = primitives.sphere(2)
    top = spectrum(ball, matrix=matrix).largest[-1]
    result = spectrum(joined(*[ball] * 40), matrix=matrix)
    assert np.allclose(result.largest, top, rtol=0, atol=1e-10)


@pytest.mark.parametrize("matrix", MATRICES)
def test_no_copy_at_the_cutoff_is_overlooked(matrix):
    """Each copy of five equal ones; a Lanczos method alone gave others beyond them instead."""
    ball, copies = primitives.sphere(1), 13
    one = spectrum(ball, matrix=matrix).eigenvalues
    result = spectrum(joined(*[ball] * copies), matrix=matrix, dense_limit=0, extremes=30)
    assert np.allclose(result.smallest, np.sort(np.repeat(one, copies))[:30], rtol=0, atol=1e-9)


def test_a_heap_of_tetrahedra_has_two_eigenvalues():
    """A Lanczos method may come to an end before it has as many as are asked for."""
    heap = laplacian_matrix(joined(*[primitives.tetrahedron()] * 21))
    for _ in range(10):  # by rounding, one time out of three
        *_, (largest, _) = largest_steps(heap, 30)
        assert largest == pytest.approx(4)


def test_copies_of_one_surface_are_counted_too():
    result = spectrum(primitives.torus(8, 8), dense_limit=0, extremes=13)
    assert np.allclose(result.smallest, torus_eigenvalues(8, 8)[::-1][:13], rtol=0, atol=1e-9)


@pytest.mark.parametrize("matrix", MATRICES)
def test_equal_fans_are_taken_one_by_one(matrix, monkeypatch):
    """Crowds of eigenvalues with eight copies each; in this process, to see how it is done."""
    monkeypatch.setattr(spectrum_module, "_SMALL", 10**9)
    parts = []
    alone = extremes._outermost_of
    monkeypatch.setattr(
        extremes,
        "_outermost_of",
        lambda found, *rest: parts.append(len(found)) or alone(found, *rest),
    )
    one = spectrum(fan(400), matrix=matrix).eigenvalues
    ball = spectrum(primitives.sphere(2), matrix=matrix).eigenvalues
    exact = np.sort(np.concatenate([one, one, one, one, ball]))
    mesh = joined(*[fan(400)] * 4, primitives.sphere(2))
    result = spectrum(mesh, matrix=matrix, dense_limit=0)
    assert np.allclose(result.largest, exact[-12:], rtol=1e-10, atol=1e-10)
    assert np.allclose(result.smallest, exact[:12], rtol=0, atol=1e-10)
    assert set(parts) == {5}


def test_a_shift_that_falls_short_moves_beyond_all_eigenvalues(monkeypatch):
    """The rough value is promised to be near an eigenvalue, not near the largest."""
    monkeypatch.setattr(extremes, "_ROUGH", -0.2)
    *_, (largest, _) = largest_steps(laplacian_matrix(primitives.torus(12, 7)), 5)
    assert np.allclose(largest, torus_eigenvalues(12, 7)[4::-1], atol=1e-10)
