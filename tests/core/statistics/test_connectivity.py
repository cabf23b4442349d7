"""Degree, neighbour degree and clustering, by hand and against networkx."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core import load_mesh
from core.mesh import TriangleMesh, primitives
from core.statistics import assortativity, clustering, connectivity, degree_distribution

BOOK = TriangleMesh(np.eye(5, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
"""Three pages that share the edge from 0 to 1."""


def agrees_with_networkx(mesh):
    graph = nx.from_scipy_sparse_array(mesh.topology.adjacency)
    ours = connectivity(mesh)
    nodes = range(len(mesh.vertices))
    neighbours, theirs = nx.average_neighbor_degree(graph), nx.clustering(graph)
    assert [graph.degree(i) for i in nodes] == ours.degrees.tolist()
    assert np.abs(ours.neighbour_degrees - [neighbours[i] for i in nodes]).max() < 1e-12
    assert np.abs(ours.clustering - [theirs[i] for i in nodes]).max() < 1e-12
    return ours, graph


def test_book_of_three_pages_by_hand():
    ours = connectivity(BOOK)
    assert ours.degrees.tolist() == [4, 4, 2, 2, 2]
    assert ours.neighbour_degrees.tolist() == [2.5, 2.5, 4, 4, 4]
    assert ours.clustering.tolist() == [0.5, 0.5, 1, 1, 1]
    assert dict(degree_distribution(ours)) == {2: 0.6, 4: 0.4}
    assert dict(assortativity(ours)) == {2: 4.0, 4: 2.5}
    assert dict(clustering(ours)) == {2: 1.0, 4: 0.5}


def test_boundary_leaves_the_printed_formula():
    """Inside C = 2/(d − 1), on the boundary C = 2/d."""
    mesh = primitives.grid(6, 5)
    ours, rim = connectivity(mesh), mesh.topology.boundary_vertices
    assert np.allclose(ours.clustering[~rim], 2 / (ours.degrees[~rim] - 1), atol=1e-15)
    assert np.allclose(ours.clustering[rim], 2 / ours.degrees[rim], atol=1e-15)


def test_closed_surface_has_the_printed_formula():
    ours = connectivity(primitives.sphere(2))
    assert np.allclose(ours.clustering, 2 / (ours.degrees - 1), atol=1e-15)


def test_empty_triangle_counts():
    """On a tube of three, the ring around it is a triangle without a face."""
    ours, _ = agrees_with_networkx(primitives.torus(8, 3))
    assert np.all(ours.clustering > 2 / (ours.degrees - 1))


@pytest.mark.parametrize(
    "mesh",
    [
        BOOK,
        primitives.tetrahedron(),
        primitives.grid(4, 3),
        TriangleMesh(np.eye(4, 3), [[0, 1, 2]]),
        TriangleMesh(np.eye(3), np.zeros((0, 3), int)),
    ],
    ids=["non-manifold", "closed", "boundary", "isolated vertex", "no faces"],
)
def test_small_meshes_agree_with_networkx(mesh):
    agrees_with_networkx(mesh)


@pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")
@pytest.mark.parametrize(
    "name",
    [
        "camel_2444.ply",
        "double_torus_820_open.obj",
        "spider_4670.ply",
        "awkward/nonmanifold_hole.ply",
        "awkward/bunny_res2_nonmanifold.ply",
        "foot_bones_2154.ply",
    ],
)
def test_real_models_agree_with_networkx(shared_models, name):
    ours, graph = agrees_with_networkx(load_mesh(shared_models / name))
    coefficient = nx.degree_assortativity_coefficient(graph)
    assert ours.assortativity_coefficient == pytest.approx(coefficient, abs=1e-9)


def test_vertex_with_very_many_neighbours_is_cheap():
    """A fan of 30,000 faces; taking the square of its degree would run for minutes."""
    count = 30_000
    around = np.arange(1, count + 1)
    faces = np.stack([np.zeros_like(around), around, np.roll(around, -1)], axis=1)
    vertices = np.random.default_rng(0).standard_normal((count + 1, 3))
    ours = connectivity(TriangleMesh(vertices, faces))
    assert ours.clustering[0] == pytest.approx(2 / (count - 1))
    assert ours.clustering[1] == 1.0 * 2 / 3


def test_equal_degrees_have_no_correlation():
    assert np.isnan(connectivity(primitives.torus()).assortativity_coefficient)


@given(st.permutations(range(20)))
def test_renumbering_moves_the_values_along(order):
    mesh = primitives.grid(4, 3)
    order = np.array(order)
    renumbered = TriangleMesh(mesh.vertices[np.argsort(order)], order[mesh.faces])
    before, after = connectivity(mesh), connectivity(renumbered)
    assert np.allclose(after.clustering[order], before.clustering, atol=1e-15)
    assert np.allclose(after.neighbour_degrees[order], before.neighbour_degrees, atol=1e-15)
    assert dict(degree_distribution(after)) == dict(degree_distribution(before))


def test_shares_and_histograms_add_up():
    ours = connectivity(primitives.grid(9, 7))
    shares = degree_distribution(ours)
    assert sum(shares.values()) == pytest.approx(1)
    mean = sum(k * share for k, share in shares.items())
    assert mean == pytest.approx(ours.degrees.mean())
    for result in (assortativity(ours), clustering(ours)):
        assert result.histogram.counts.sum() == 80
        assert result.histogram.shares.sum() == pytest.approx(1)
    assert 99 not in shares
    with pytest.raises(KeyError):
        shares[99]


def test_results_are_read_only():
    ours = connectivity(primitives.torus())
    with pytest.raises(ValueError, match="read-only"):
        ours.clustering[0] = 1
