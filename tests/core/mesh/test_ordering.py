"""Numbers that follow the surface: a walk by hand, the way there and back, what does not change."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.mesh import TriangleMesh, geometry, ordering, primitives

STRIP = TriangleMesh(np.eye(5, 3), [[4, 1, 3], [0, 2, 1], [1, 4, 2]])
"""Three faces in a row: 0–2–1, 1–4–2, 4–1–3."""


def shuffled(mesh, seed=0):
    """The same mesh with vertices and faces in any order."""
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(mesh.vertices))
    ranks = np.argsort(order)
    return TriangleMesh(mesh.vertices[order], ranks[rng.permutation(mesh.faces)])


@pytest.fixture
def always(monkeypatch):
    """Renumber every mesh, also the small ones of tests."""
    monkeypatch.setattr("core.mesh.topology.follows_surface", lambda faces, count: False)


def test_walk_by_hand():
    vertices, faces = ordering.walk(STRIP.faces, *STRIP.topology.vertex_faces)
    # Face 1 has vertex 0; of its corners, 2 and then 1 are met. Face 2 touches 2, face 0 touches 1.
    assert vertices.tolist() == [0, 2, 1, 4, 3]
    assert faces.tolist() == [1, 2, 0]


def test_walk_reaches_every_component_and_isolated_vertices():
    mesh = TriangleMesh(np.eye(8, 3), [[7, 6, 4], [1, 2, 3]])
    vertices, faces = ordering.walk(mesh.faces, *mesh.topology.vertex_faces)
    assert vertices.tolist() == [0, 1, 2, 3, 4, 7, 6, 5]
    assert faces.tolist() == [1, 0]


def test_mean_step_by_hand():
    # 4→1→3→0→2→1→1→4→2 is 3 + 2 + 3 + 2 + 1 + 0 + 3 + 2 over nine corners.
    assert ordering.mean_step(STRIP.faces) == pytest.approx(16 / 9)
    assert ordering.mean_step(np.zeros((0, 3), np.int32)) == 0


def test_no_new_numbers_for_small_meshes_and_for_good_orders():
    assert shuffled(primitives.torus()).topology.ordering.vertices.order is None
    good = primitives.grid(200, 200)
    assert good.topology.along_surface is good.topology
    assert good.along_surface() is good


def test_new_numbers_bring_neighbours_together():
    mesh = shuffled(primitives.grid(200, 200))
    along = mesh.along_surface()
    assert ordering.mean_step(along.faces) < ordering.mean_step(mesh.faces) / 20
    assert along.topology.along_surface is along.topology
    assert along.topology.is_along_surface


def test_every_mesh_of_a_topology_shares_its_order(always):
    mesh = shuffled(primitives.torus())
    moved = mesh.with_vertices(mesh.vertices + 1)
    assert moved.topology.ordering is mesh.topology.ordering
    assert moved.along_surface().topology is mesh.along_surface().topology


@pytest.mark.usefixtures("always")
def test_same_triangles_in_the_new_order():
    mesh = shuffled(primitives.torus())
    along, order = mesh.along_surface(), mesh.topology.ordering
    corners = mesh.vertices[mesh.faces]
    assert np.array_equal(along.vertices[along.faces], corners[order.faces.order])
    normals = order.faces.outward(geometry.face_normals(along))
    assert np.array_equal(normals, geometry.face_normals(mesh))
    with pytest.raises(ValueError, match="read-only"):
        along.vertices[0] = 0


@given(st.permutations(range(9)))
def test_outward_undoes_inward(order):
    numbering = ordering.Numbering(np.array(order, np.int32))
    values = np.arange(27.0).reshape(9, 3)
    assert np.array_equal(numbering.outward(numbering.inward(values)), values)


def test_numbering_without_an_order_changes_nothing():
    values = np.arange(3.0)
    assert ordering.Numbering().inward(values) is values
    assert ordering.Numbering().outward(values) is values


def _facts(mesh):
    topology = mesh.topology
    return (
        *(topology.genus, topology.component_count, topology.euler_characteristic),
        *(topology.is_closed, topology.is_manifold, topology.is_orientable),
        topology.is_consistently_wound,
    )


def _pages():
    return TriangleMesh(np.eye(5, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]])


def _moebius_strip():
    return TriangleMesh(np.eye(5, 3), [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])


def _turned_face():
    ball = primitives.sphere(1)
    return TriangleMesh(ball.vertices, [ball.faces[0][::-1], *ball.faces[1:]])


def _two_and_a_point():
    ring = primitives.torus()
    faces = np.concatenate([ring.faces, ring.faces + len(ring.vertices) + 1])
    return TriangleMesh(np.concatenate([ring.vertices, np.eye(1, 3), ring.vertices + 5]), faces)


@pytest.mark.parametrize(
    "make",
    [primitives.torus, primitives.grid, _pages, _moebius_strip, _turned_face, _two_and_a_point],
)
def test_facts_do_not_depend_on_the_numbers(make, always):
    mesh = make()
    order = mesh.topology.ordering.vertices.order
    assert sorted(order.tolist()) == list(range(len(mesh.vertices)))
    plain = TriangleMesh(mesh.vertices, mesh.faces)
    plain.topology.__dict__["ordering"] = ordering.Ordering()
    assert _facts(mesh) == _facts(plain) == _facts(shuffled(mesh))
    assert mesh.mean_edge_length == pytest.approx(plain.mean_edge_length, rel=1e-14)
