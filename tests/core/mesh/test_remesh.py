"""Subdivision and decimation."""

import threading

import numpy as np
import pytest

from core import load_mesh
from core.mesh import MeshError, TriangleMesh, geometry, primitives, remesh
from core.mesh.remesh import (
    barycentric_subdivision,
    decimated,
    decimation_steps,
    midpoint_subdivision,
)

MESHES = [primitives.torus(), primitives.grid(), primitives.sphere(1)]


def test_triangle_in_six_by_hand():
    mesh = barycentric_subdivision(primitives.grid(1, 1))
    assert len(mesh.faces) == 12
    assert len(mesh.vertices) == 4 + 5 + 2
    assert mesh.vertices[9].tolist() == pytest.approx([2 / 3, 1 / 3, 0])


@pytest.mark.parametrize("mesh", MESHES)
@pytest.mark.parametrize(
    ("split", "factor"), [(barycentric_subdivision, 6), (midpoint_subdivision, 4)]
)
def test_subdivision_keeps_the_shape(mesh, split, factor):
    fine = split(mesh)
    assert len(fine.faces) == factor * len(mesh.faces)
    assert np.array_equal(fine.vertices[: len(mesh.vertices)], mesh.vertices)
    assert fine.euler_characteristic == mesh.euler_characteristic
    assert fine.genus == mesh.genus
    assert fine.topology.is_consistently_wound
    assert geometry.face_areas(fine).sum() == pytest.approx(geometry.face_areas(mesh).sum())
    assert geometry.volume(fine) == pytest.approx(geometry.volume(mesh), abs=1e-12)


def test_barycentric_degrees():
    """Old vertices double their degree, midpoints get 4, centroids 6."""
    mesh = primitives.sphere(1)
    degrees = barycentric_subdivision(mesh).degrees
    m, e = len(mesh.vertices), len(mesh.edges)
    assert degrees[:m].tolist() == (2 * mesh.degrees).tolist()
    assert set(degrees[m : m + e]) == {4}
    assert set(degrees[m + e :]) == {6}


def test_decimation_keeps_topology_and_nearly_the_volume():
    mesh = primitives.sphere(4)
    coarse = decimated(mesh, 0.25)
    assert len(coarse.faces) == pytest.approx(len(mesh.faces) / 4, rel=0.02)
    assert coarse.genus == 0
    assert geometry.volume(coarse) == pytest.approx(geometry.volume(mesh), rel=0.01)


def test_camel_comes_out_as_in_the_thesis(shared_models):
    """A quarter of the camel has the thesis' 7,326 edges."""
    coarse = decimated(load_mesh(shared_models / "camel_9770.off"), 0.25)
    assert len(coarse.edges) == 7326


def test_decimation_of_a_small_model_far_away():
    mesh = primitives.sphere(3)
    there = mesh.with_vertices(1e-3 * mesh.vertices + 100)
    coarse = decimated(there, 0.5)
    assert np.abs(coarse.vertices - 100).max() < 1.1e-3
    assert coarse.genus == 0


def test_in_another_process_it_is_the_same(monkeypatch):
    mesh = primitives.sphere(3)
    here = decimated(mesh, 0.3)
    monkeypatch.setattr(remesh, "_LONG", -1)
    there = decimated(mesh, 0.3)
    assert np.array_equal(there.vertices, here.vertices)
    assert np.array_equal(there.faces, here.faces)


def test_a_fan_of_a_hundred_thousand_faces_can_be_left_at_any_time():
    """The library alone takes eight seconds, and keeps the interpreter lock meanwhile."""
    after = np.arange(1, 100_001)
    faces = np.stack([0 * after, after, after % 100_000 + 1], axis=1)
    fan = TriangleMesh(np.random.default_rng(0).random((100_001, 3)), faces)
    steps = decimation_steps(fan, 0.5)
    assert [next(steps) for _ in range(10)] == [None] * 10
    steps.close()
    assert "burnish-apart" not in [thread.name for thread in threading.enumerate()]


def test_keeping_everything_changes_nothing():
    mesh = primitives.torus()
    assert decimated(mesh, 1.0) is mesh


@pytest.mark.parametrize("share", [0, -1, 1.5, float("nan")])
def test_other_shares_are_refused(share):
    with pytest.raises(MeshError, match="use a number above 0 and up to 1"):
        decimated(primitives.torus(), share)
