"""Studies in numbers that follow the surface give, in the file's order, what they gave without."""

import numpy as np
import pytest

from core.comparison import Comparison, run_method
from core.io import LoadedMesh, load_mesh
from core.mesh import TriangleMesh, primitives
from core.models import matched
from core.noise import add_noise
from core.parameters import ParameterError
from core.smoothing import METHODS
from core.study import MethodChoice

MODELS = (
    *("spider_4670.ply", "foot_bones_2154.ply", "teapot_3644.obj", "fandisk_6475.off"),
    *("awkward/nonmanifold_hole.ply", "camelhead_11381_open.off"),
)


def together(*meshes):
    """Several meshes as the components of one."""
    starts = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    faces = [mesh.faces + start for mesh, start in zip(meshes, starts, strict=False)]
    vertices = [mesh.vertices + 3 * k for k, mesh in enumerate(meshes)]
    return TriangleMesh(np.concatenate(vertices), np.concatenate(faces))


def compared(mesh, monkeypatch, *, renumbered):
    """A comparison of the mesh with a noisy one, with or without numbers along the surface."""
    monkeypatch.setattr("core.mesh.topology.follows_surface", lambda f, m: not renumbered)
    mesh = TriangleMesh(mesh.vertices, mesh.faces)
    assert (mesh.topology.ordering.vertices.order is not None) == renumbered
    return Comparison(mesh, add_noise(mesh, 0.1, seed=3))


def assert_equal_results(mesh, monkeypatch):
    """All methods, metrics and heat maps agree."""
    along = compared(mesh, monkeypatch, renumbered=True)
    plain = compared(mesh, monkeypatch, renumbered=False)
    assert along.noisy.vertices == pytest.approx(plain.noisy.vertices, rel=1e-13)
    assert along.noisy_errors == pytest.approx(plain.noisy_errors, rel=1e-12)
    extent = np.ptp(mesh.vertices, axis=0).max()
    for method in METHODS:
        choice = MethodChoice(method=method, iterations=3)
        one, other = run_method(along, choice), run_method(plain, choice)
        assert one.mesh.vertices == pytest.approx(other.mesh.vertices, rel=0, abs=1e-12 * extent)
        for id_, errors in one.errors.items():
            assert errors == pytest.approx(other.errors[id_], rel=1e-11), (method, id_)
            elements = along.evaluators[id_].elements(one.mesh.vertices)
            theirs = plain.evaluators[id_].elements(other.mesh.vertices)
            assert elements == pytest.approx(theirs, rel=1e-6, abs=1e-10)


@pytest.mark.parametrize(
    "mesh",
    [
        primitives.grid(7, 9),
        together(primitives.torus(), primitives.sphere(2), primitives.grid(5, 5)),
        TriangleMesh(np.vstack([np.eye(3), -np.eye(2, 3)]), [[0, 1, 2], [1, 0, 3], [0, 1, 4]]),
    ],
    ids=["open", "three components", "three pages"],
)
def test_results_of_primitives(mesh, monkeypatch):
    assert_equal_results(mesh, monkeypatch)


@pytest.mark.parametrize("name", MODELS)
def test_results_of_models(name, shared_models, monkeypatch):
    assert_equal_results(load_mesh(shared_models / name), monkeypatch)


def test_snapshots_leave_in_the_order_of_the_file(monkeypatch):
    along = compared(primitives.torus(), monkeypatch, renumbered=True)
    snapshot = next(along.snapshots(MethodChoice(method="laplacian", iterations=1)))
    inward = along.noisy.topology.ordering.vertices.inward(snapshot.vertices)
    assert np.array_equal(inward, snapshot.along_surface)
    assert snapshot.errors == pytest.approx(along.errors(snapshot.vertices), rel=1e-14)


def test_a_run_without_iterations_gives_the_noisy_mesh(monkeypatch):
    along = compared(primitives.torus(), monkeypatch, renumbered=True)
    assert run_method(along, MethodChoice(method="mean", iterations=0)).mesh is along.noisy


def test_a_noisy_file_may_list_its_faces_in_another_order():
    ring = primitives.torus()
    noisy = TriangleMesh(ring.vertices + 1, np.roll(ring.faces[::-1], 1, axis=1))
    assert matched(ring, LoadedMesh("noisy", noisy)).topology is ring.topology


def test_a_noisy_file_with_other_faces_is_refused():
    ring = primitives.torus()
    faces = ring.faces.copy()
    faces[0, 0] = next(i for i in range(len(ring.vertices)) if i not in faces[0])
    with pytest.raises(ParameterError, match="joins its vertices to other faces"):
        matched(ring, LoadedMesh("noisy", TriangleMesh(ring.vertices, faces)))
