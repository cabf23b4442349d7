"""Parts that a mesh is drawn in: together they are the mesh, and hardly more vertices."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

from app.scene import parts
from app.scene.parts import parts_of
from core.mesh import TriangleMesh, primitives


def faces_of(part):
    cells = vtk_to_numpy(part.cells.GetConnectivityArray()).reshape(-1, 3)
    return part.vertices[cells]


@pytest.mark.parametrize("mesh", [primitives.torus(), primitives.sphere(2)])
@pytest.mark.parametrize("size", [1, 7, 80, 10_000])
def test_parts_are_the_mesh(monkeypatch, mesh, size):
    monkeypatch.setattr(parts, "_FACES", size)
    cut = parts_of(mesh.topology)
    chosen = np.concatenate([part.faces for part in cut])
    assert sorted(chosen) == list(range(len(mesh.faces)))
    assert np.array_equal(np.concatenate([faces_of(p) for p in cut]), mesh.faces[chosen])
    assert len(cut) <= 64


def test_a_vertex_without_faces_is_in_no_part():
    mesh = TriangleMesh([[9, 9, 9], [0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 2, 3]])
    (part,) = parts_of(mesh.topology)
    assert part.vertices.tolist() == [1, 2, 3]


def test_numbers_without_order_cost_few_vertices_more():
    ball = primitives.sphere(6)
    shuffled = np.random.default_rng(1).permutation(len(ball.faces))
    cut = parts_of(TriangleMesh(ball.vertices, ball.faces[shuffled]).topology)
    assert len(cut) == 5
    assert sum(len(part.vertices) for part in cut) < 1.1 * len(ball.vertices)


def test_no_faces_have_no_parts():
    assert parts_of(TriangleMesh(np.zeros((2, 3)), np.zeros((0, 3), int)).topology) == ()
