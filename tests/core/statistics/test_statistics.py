"""All statistics at once, and the summary."""

import math
from dataclasses import FrozenInstanceError

import numpy as np
import pytest

from core import load_mesh, mesh_statistics
from core.mesh import TriangleMesh, primitives
from core.statistics import (
    GeodesicParams,
    Progress,
    SpectrumParams,
    StatisticsError,
    spectrum_steps,
    statistics_steps,
    summarise,
)


def test_cube_by_hand():
    corners = np.array([[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)], float)
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [f for a, b, c, d in squares for f in ((a, b, c), (a, c, d))]
    summary = summarise(TriangleMesh(corners, faces))
    assert (summary.vertices, summary.edges, summary.faces) == (8, 18, 12)
    assert (summary.components, summary.boundary_loops, summary.genus) == (1, 0, 0)
    assert summary.euler_characteristic == 2
    assert summary.area == pytest.approx(24)
    assert summary.volume == pytest.approx(8)
    assert (summary.shortest_edge, summary.longest_edge) == pytest.approx((2, math.sqrt(8)))
    assert summary.mean_edge_length == pytest.approx((12 * 2 + 6 * math.sqrt(8)) / 18)
    assert (summary.smallest_angle, summary.largest_angle) == pytest.approx((45, 90))
    assert summary.average_degree == 4.5


def test_annulus_has_two_boundary_loops_and_no_volume():
    mesh = primitives.grid(5, 5)
    middle = np.all((mesh.vertices[mesh.faces][:, :, :2] >= 2)
                    & (mesh.vertices[mesh.faces][:, :, :2] <= 3), axis=(1, 2))  # fmt: skip
    summary = summarise(TriangleMesh(mesh.vertices, mesh.faces[~middle]))
    assert (summary.boundary_loops, summary.volume, summary.genus) == (2, None, None)


def test_what_is_awkward_is_counted():
    vertices = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 1]]
    summary = summarise(TriangleMesh(vertices, [[0, 1, 2], [0, 1, 3], [0, 1, 4]]))
    assert (summary.degenerate_faces, summary.nonmanifold_edges) == (1, 1)
    assert summary.components == 2


def test_thesis_counts(shared_models):
    """Thesis §3.4: the bunny agrees; the camel has the same edges and one vertex more."""
    bunny = summarise(load_mesh(shared_models / "bunny_34834.ply"))
    camel = summarise(load_mesh(shared_models / "camel_2444.ply"))
    assert (bunny.vertices, bunny.edges) == (34834, 104288)
    assert (camel.vertices, camel.edges) == (2444, 7326)
    assert camel.average_degree == pytest.approx(5.99509, abs=1e-5)
    assert bunny.average_degree == pytest.approx(5.98771, abs=1e-5)


def test_everything_at_once():
    mesh = primitives.torus(30, 16)
    result = mesh_statistics(mesh)
    assert (result.vertices, result.edges, result.average_degree) == (480, 1440, 6.0)
    assert dict(result.degree) == {6: 1.0}
    assert dict(result.assortativity) == {6: 6.0}
    assert dict(result.clustering) == {6: pytest.approx(0.4)}
    assert result.spectrum.matrix == "laplacian"
    assert result.normalized_spectrum.matrix == "normalized_laplacian"
    assert result.normalized_spectrum.eigenvalues == pytest.approx(
        result.spectrum.eigenvalues / 6, abs=1e-12
    )
    assert result.geodesic.pairs == 200 * 479
    with pytest.raises(FrozenInstanceError):
        result.summary = None


@pytest.mark.parametrize(
    "part", ["degree", "assortativity", "clustering", "spectrum", "geodesic"]
)  # fmt: skip
def test_every_result_has_its_axis_labels(part):
    labels = getattr(mesh_statistics(primitives.tetrahedron()), part).labels
    assert labels.x
    assert labels.y


def test_settings_reach_the_parts():
    result = mesh_statistics(
        primitives.sphere(3),
        GeodesicParams(along="edges", sources=3),
        SpectrumParams(dense_limit=100),
    )
    assert (result.geodesic.sources, result.geodesic.params.along) == (3, "edges")
    assert not result.spectrum.exact
    assert not result.normalized_spectrum.exact


def test_progress_grows_to_the_end():
    shares = [step.share for step in statistics_steps(primitives.sphere(2))]
    assert shares == sorted(shares)
    assert shares[-1] == 1


def test_what_is_refused_leaves_the_rest(monkeypatch):
    def refuse_one(mesh, params):
        yield Progress(None, 0.0)
        if params.matrix == "normalized_laplacian":
            raise StatisticsError("It does not converge.")
        yield from spectrum_steps(mesh, params)

    monkeypatch.setattr("core.statistics.statistics.spectrum_steps", refuse_one)
    *steps, last = statistics_steps(primitives.sphere(1))
    result = last.value
    assert result.normalized_spectrum is None
    assert dict(result.refusals) == {"normalized_spectrum": "It does not converge."}
    assert result.spectrum.zero_count == 1
    assert result.geodesic.pairs > 0
    assert [step.share for step in steps] == sorted(step.share for step in steps)


def test_mesh_without_vertices_is_refused():
    with pytest.raises(StatisticsError, match="without vertices"):
        mesh_statistics(TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int)))


@pytest.mark.parametrize(
    "mesh",
    [
        TriangleMesh([[0, 0, 0]], np.zeros((0, 3), int)),
        TriangleMesh(np.eye(3), [[0, 1, 2]]),
        TriangleMesh(np.zeros((3, 3)), [[0, 1, 2]]),
    ],
    ids=["point", "triangle", "triangle without size"],
)
def test_tiniest_meshes_have_statistics(mesh):
    result = mesh_statistics(mesh)
    assert result.spectrum.zero_count == 1
    assert result.geodesic.unreachable_pairs == 0
