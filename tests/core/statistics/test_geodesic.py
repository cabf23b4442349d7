"""Geodesic distances: known ones on a sphere and a flat grid, pairs without a path, sampling."""

import numpy as np
import pytest

from core import add_noise, load_mesh
from core.mesh import TriangleMesh, primitives
from core.statistics import (
    GeodesicParams,
    StatisticsError,
    distances_from_vertex,
    finished,
    geodesic_steps,
)
from core.statistics.graphs import nearest_neighbour_graph
from core.statistics.tally import Tally

WAYS = ("neighbours", "edges", "surface")


def geodesic(mesh, **params):
    return finished(geodesic_steps(mesh, GeodesicParams(**params)))


def from_vertex(mesh, vertex, along):
    return distances_from_vertex(mesh, vertex, GeodesicParams(along=along))


def two_balls():
    ball = primitives.sphere(1)
    faces = np.concatenate([ball.faces, ball.faces + 42])
    return TriangleMesh(np.concatenate([ball.vertices, ball.vertices + 10]), faces)


def test_square_along_edges_by_hand():
    mesh = primitives.grid(1, 1)
    result = geodesic(mesh, along="edges")
    unit = (4 + np.sqrt(2)) / 5
    assert (result.pairs, result.unreachable_pairs, result.sources) == (12, 0, 4)
    assert result.longest * unit == pytest.approx(2)
    assert result.mean * unit == pytest.approx((8 * 1 + 2 * np.sqrt(2) + 2 * 2) / 12)


@pytest.mark.parametrize(("along", "worst"), [("neighbours", 0.14), ("edges", 0.2),
                                              ("surface", 0.03)])  # fmt: skip
def test_sphere_against_great_circles(along, worst):
    mesh = primitives.sphere(4)
    true = np.arccos(np.clip(mesh.vertices @ mesh.vertices[0], -1, 1))
    found = from_vertex(mesh, 0, along)
    far = true > 0.5
    assert np.abs(found[far] / true[far] - 1).max() < worst


@pytest.mark.parametrize(("along", "worst"), [("neighbours", 0.09), ("edges", 0.42),
                                              ("surface", 0.06)])  # fmt: skip
def test_flat_grid_against_straight_lines(along, worst):
    """Along the edges of this grid one diagonal costs √2, the other 2."""
    mesh = primitives.grid(30, 30)
    centre = 15 * 31 + 15
    true = np.linalg.norm(mesh.vertices - mesh.vertices[centre], axis=1)
    found = from_vertex(mesh, centre, along)
    far = true > 5
    assert np.abs(found[far] / true[far] - 1).max() < worst
    if along != "surface":
        assert np.all(found >= true - 1e-9)


@pytest.mark.parametrize("along", WAYS)
def test_pairs_without_a_path_are_counted(along):
    result = geodesic(two_balls(), along=along, neighbours=6)
    assert result.pairs == 84 * 83
    assert result.unreachable_pairs == 2 * 42 * 42
    assert result.histogram.counts.sum() == result.pairs - result.unreachable_pairs
    assert np.isfinite(result.longest)


@pytest.mark.parametrize("along", WAYS)
def test_isolated_vertex_has_no_path(along):
    ball = primitives.sphere(1)
    far_away = np.concatenate([ball.vertices, [[1e3, 0, 0]]])
    result = geodesic(TriangleMesh(far_away, ball.faces), along=along, neighbours=3)
    # The nearest neighbours of a lonely point join it to the rest all the same.
    assert result.unreachable_pairs == (0 if along == "neighbours" else 2 * 42)


@pytest.mark.parametrize("along", WAYS)
def test_scale_changes_nothing_in_mean_edge_lengths(along):
    # On an even mesh it is chance which of two equally near vertices is a neighbour.
    mesh = add_noise(primitives.torus(), 0.2)
    large = mesh.with_vertices(1000 * mesh.vertices + 5)
    one, other = geodesic(mesh, along=along), geodesic(large, along=along)
    assert other.mean == pytest.approx(one.mean, rel=1e-6)
    assert other.longest == pytest.approx(one.longest, rel=1e-6)


def test_vertices_at_one_place_are_joined():
    points = np.array([[0.0, 0, 0], [0, 0, 0], [1, 0, 0], [3, 0, 0]])
    graph = nearest_neighbour_graph(points, 1)
    # Which of two equal places is whose neighbour is open; that all are joined is not.
    assert graph[0, 1] == 0
    assert graph.nnz == 6
    mesh = TriangleMesh(points, [[0, 2, 3]])
    found = from_vertex(mesh, 0, "neighbours")
    assert found == pytest.approx([0, 0, 1, 3])


def test_sampling_comes_near_all_pairs():
    mesh = primitives.torus(40, 20)
    every, some = geodesic(mesh, sources=800), geodesic(mesh, sources=100, seed=3)
    assert (every.sources, some.sources) == (800, 100)
    assert some.mean == pytest.approx(every.mean, rel=0.02)
    assert geodesic(mesh, sources=100, seed=3).mean == some.mean
    assert geodesic(mesh, sources=100, seed=4).mean != some.mean


def test_progress_shows_the_distribution_growing():
    steps = list(geodesic_steps(primitives.sphere(4), GeodesicParams(sources=100)))
    assert steps[0].value is None
    sources = [step.value.sources for step in steps[1:]]
    assert sources == sorted(sources)
    assert (len(sources) > 3, sources[-1], steps[-1].share) == (True, 100, 1)


def test_surface_without_faces_is_refused():
    mesh = TriangleMesh(np.eye(3), np.zeros((0, 3), int))
    with pytest.raises(StatisticsError, match="without faces"):
        geodesic(mesh, along="surface")


@pytest.mark.parametrize("along", WAYS)
@pytest.mark.parametrize(
    "name",
    [
        "awkward/bunny_res2_nonmanifold.ply",
        "foot_bones_2154.ply",
        "awkward/degenerate_faces.off",
        "spider_4670.ply",
    ],
)
def test_awkward_models_have_distances(shared_models, name, along):
    mesh = load_mesh(shared_models / name)
    result = geodesic(mesh, along=along, sources=5)
    assert np.isfinite(result.longest)
    assert result.longest > 0
    if along != "neighbours":
        apart = mesh.topology.component_count > 1
        assert (result.unreachable_pairs > 0) == apart


def test_tally_keeps_count_when_its_range_doubles():
    tally = Tally()
    tally.add(np.array([0.0, 0.0]))
    tally.add(np.array([1.0, 2.0, np.inf]))
    tally.add(np.array([100.0]))
    histogram = tally.histogram(10)
    assert (tally.finite, tally.infinite, tally.longest, tally.mean) == (5, 1, 100, 20.6)
    assert histogram.counts.sum() == 5
    assert histogram.counts[0] == 4
    assert histogram.counts[-1] == 1
    assert histogram.edges[-1] >= 100


def test_two_far_apart_groups_give_two_modes():
    values = np.random.default_rng(0).normal(5, 0.4, 20_000)
    tally = Tally()
    tally.add(np.concatenate([values, values + 10]))
    result = geodesic(primitives.torus())
    both = type(result)(result.params, tally.histogram(72), 1, 1, 0, 1.0, 1.0, 1.0)
    assert both.modes == pytest.approx([5, 15], abs=0.4)
