"""What a place in a plot counts, and the picture of a matrix."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from app.export.statistics_matrix import CELLS, draw_matrix, matrix_density, matrix_words
from app.export.statistics_selection import Spot, select
from app.export.statistics_series import Series
from app.scene.colours import LIGHT
from core import mesh_statistics
from core.mesh import primitives
from core.mesh.matrices import laplacian_matrix

MESH = primitives.grid(9, 9)


@pytest.fixture(scope="module")
def series():
    return Series.of_statistics("grid", mesh_statistics(MESH))


@pytest.mark.parametrize("plot", ["degree", "assortativity", "clustering"])
def test_a_degree_counts_its_vertices(series, plot):
    found = select(Spot(plot, 4.3, 0.0), series, None)
    assert np.array_equal(found.vertices, MESH.degrees == 4)
    assert found.span == (3.5, 4.5)
    assert "degree 4: 32 vertices (32 %)" in found.words


def test_a_degree_that_does_not_occur_counts_none(series):
    found = select(Spot("degree", 9, 0.0), series, None)
    assert not found.vertices.any()
    assert "no vertex" in found.words


def test_bins_beside_count_every_vertex_once(series):
    edges = series.clustering.histogram.edges
    counts = np.zeros(len(MESH.vertices))
    for place in np.flatnonzero(series.clustering.histogram.counts):
        middle = (edges[place] + edges[place + 1]) / 2
        counts += select(Spot("clustering", 0, middle, beside=True), series, None).vertices
    assert counts.tolist() == [1] * 100


def test_thin_bin_is_found_from_beside_it(series):
    near = select(Spot("clustering", 0, 1.01, beside=True), series, None)
    assert near.vertices.sum() == 2
    assert select(Spot("clustering", 0, 2.0, beside=True), series, None).vertices is None


def test_distances_are_counted_from_the_picked_vertex(series):
    distances = np.linalg.norm(MESH.vertices, axis=1)
    found = select(Spot("geodesic", 5.0, 0.0), series, distances)
    low, high = found.span
    assert np.array_equal(found.vertices, (distances >= low) & (distances < high))


def test_relative_distances_span_their_own_scale(series):
    relative = Series(**{**vars(series), "relative": True})
    whole = select(Spot("geodesic", 5.0, 0.0), series, None).span
    share = select(Spot("geodesic", 5.0 / series.geodesic.longest, 0.0), relative, None).span
    assert np.array(share) * series.geodesic.longest == pytest.approx(whole)


def test_eigenvalue_is_read_off(series):
    found = select(Spot("spectrum", 0.5, 0.0), series, None)
    assert found.vertices is None
    assert found.words.startswith("50.0 % of the eigenvalues are above")


def test_density_of_a_small_matrix_is_its_pattern():
    matrix = laplacian_matrix(primitives.tetrahedron())
    assert np.array_equal(matrix_density(matrix), np.ones((4, 4)))


def test_density_of_a_large_matrix_keeps_all_entries():
    matrix = laplacian_matrix(primitives.sphere(4))
    density = matrix_density(matrix)
    assert density.shape == (CELLS, CELLS)
    m = matrix.shape[0]
    sizes = np.bincount(np.arange(m) * CELLS // m)
    assert (density * np.outer(sizes, sizes)).sum() == pytest.approx(matrix.nnz)


def test_matrix_is_drawn_and_described():
    matrix = laplacian_matrix(primitives.sphere(3))
    figure = Figure(layout="constrained")
    axes = draw_matrix(figure, matrix, LIGHT)
    figure.canvas.draw()
    assert axes.images[0].get_array().shape == (320, 320)
    assert "642 × 642, 4,482 entries" in matrix_words(matrix)
