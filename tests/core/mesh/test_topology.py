"""Connectivity, against cases solved by hand and against trimesh and networkx."""

import networkx as nx
import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from core.mesh import MeshError, TriangleMesh, primitives

MOEBIUS = [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)]


def test_two_triangles_by_hand():
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    topology = mesh.topology
    assert mesh.edges.tolist() == [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]
    assert mesh.degrees.tolist() == [3, 2, 3, 2]
    assert topology.vertex_ring.row(0).tolist() == [1, 2, 3]
    assert topology.vertex_faces.row(2).tolist() == [0, 1]
    assert topology.face_ring.row(0).tolist() == [1]
    assert topology.face_edges.tolist() == [[0, 3, 1], [1, 4, 2]]
    assert topology.edge_corners.row(1).tolist() == [1, 5]
    assert topology.boundary_edges.tolist() == [True, False, True, True, True]
    assert mesh.euler_characteristic == 1
    assert mesh.genus is None


@pytest.mark.parametrize(
    ("mesh", "euler", "genus"),
    [
        (primitives.tetrahedron(), 2, 0),
        (primitives.icosahedron(), 2, 0),
        (primitives.sphere(2), 2, 0),
        (primitives.torus(), 0, 1),
        (primitives.grid(), 1, None),
    ],
)
def test_euler_characteristic_and_genus(mesh, euler, genus):
    assert mesh.euler_characteristic == euler
    assert mesh.genus == genus
    assert mesh.topology.is_consistently_wound


def test_moebius_strip_is_not_orientable():
    mesh = TriangleMesh(np.eye(5, 3), MOEBIUS)
    assert not mesh.topology.is_orientable
    assert mesh.topology.is_manifold
    assert mesh.genus is None


def test_two_cones_that_share_a_tip_are_pinched():
    one, other = primitives.tetrahedron(), primitives.tetrahedron()
    faces = np.concatenate([one.faces, np.where(other.faces == 0, 0, other.faces + 3)])
    mesh = TriangleMesh(np.concatenate([one.vertices, other.vertices[1:]]), faces)
    assert mesh.topology.pinched_vertices.tolist() == [True] + [False] * 6
    assert mesh.topology.component_count == 1
    assert mesh.genus is None


def test_three_pages_of_a_book_are_not_manifold():
    mesh = TriangleMesh(np.eye(5, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert mesh.topology.nonmanifold_edges.sum() == 1
    assert not mesh.topology.is_manifold


def test_genus_adds_up_over_components():
    ring = primitives.torus()
    faces = np.concatenate([ring.faces, ring.faces + len(ring.vertices)])
    mesh = TriangleMesh(np.concatenate([ring.vertices, ring.vertices + 5]), faces)
    assert mesh.topology.component_count == 2
    assert mesh.genus == 2


def test_isolated_vertex_has_an_empty_ring():
    mesh = TriangleMesh(np.eye(4, 3), [[0, 1, 2]])
    assert mesh.degrees.tolist() == [2, 2, 2, 0]
    assert mesh.topology.component_count == 2


def test_rings_agree_with_networkx_and_trimesh():
    mesh = primitives.torus(9, 7)
    graph = nx.from_scipy_sparse_array(mesh.topology.adjacency)
    theirs = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    assert sorted(map(tuple, mesh.edges.tolist())) == sorted(map(tuple, theirs.edges_unique))
    assert [graph.degree(i) for i in range(63)] == mesh.degrees.tolist()


def test_face_ring_against_a_plain_search():
    mesh = primitives.grid(3, 3)
    for t in range(len(mesh.faces)):
        touching = np.isin(mesh.faces, mesh.faces[t]).any(axis=1)
        touching[t] = False
        assert mesh.topology.face_ring.row(t).tolist() == np.flatnonzero(touching).tolist()


SOUPS = st.lists(st.permutations(range(7)).map(lambda order: order[:3]), min_size=1, max_size=14)
"""Faces at random: doubled ones, edges with many faces, pinched vertices, all of it."""


@given(SOUPS)
def test_tables_of_any_soup_against_a_plain_search(faces):
    topology = TriangleMesh(np.eye(7, 3), faces).topology
    for t, face in enumerate(faces):
        touching = [u for u, other in enumerate(faces) if u != t and set(face) & set(other)]
        assert topology.face_ring.row(t).tolist() == touching
    for i in range(7):
        around = [face for face in faces if i in face]
        link = nx.Graph([[j for j in face if j != i] for face in around])
        assert topology.vertex_ring.row(i).tolist() == sorted(link)
        assert topology.pinched_vertices[i] == (nx.number_connected_components(link) > 1)
    graph = nx.Graph(map(tuple, topology.edges.tolist()))
    graph.add_nodes_from(range(7))
    assert topology.component_count == nx.number_connected_components(graph)


@given(st.lists(st.booleans(), min_size=20, max_size=20))
def test_turned_faces_can_be_turned_back(turned):
    ball = primitives.icosahedron()
    faces = np.where(np.array(turned)[:, None], ball.faces[:, ::-1], ball.faces)
    topology = TriangleMesh(ball.vertices, faces).topology
    assert topology.is_orientable
    assert topology.is_consistently_wound == (all(turned) or not any(turned))
    assert topology.genus == 0


@given(st.permutations(range(12)), st.integers(0, 2))
def test_renumbering_changes_nothing_that_counts(order, turn):
    ball = primitives.icosahedron()
    order = np.array(order)
    renumbered = TriangleMesh(
        ball.vertices[np.argsort(order)], np.roll(order[ball.faces], turn, axis=1)
    )
    assert renumbered.genus == 0
    assert renumbered.topology.is_consistently_wound
    assert len(renumbered.edges) == 30


def test_with_vertices_shares_topology():
    mesh = primitives.torus()
    moved = mesh.with_vertices(mesh.vertices + 1)
    assert moved.topology is mesh.topology


def test_arrays_are_read_only():
    mesh = primitives.torus()
    for array in (mesh.vertices, mesh.faces, mesh.edges, mesh.topology.vertex_ring.items):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


@pytest.mark.parametrize(
    ("vertices", "faces", "message"),
    [
        ([[0, 0]], [[0, 0, 0]], r"vertices have the shape \(1, 2\)"),
        (np.eye(3), [[0, 1]], r"faces have the shape \(1, 2\)"),
        (np.eye(3), [[0, 1, 3]], "names the vertices .* allowed are 0 to 2"),
        (np.eye(3), [[0, -1, 2]], "allowed are 0 to 2"),
        (np.eye(3), [[0, 1, 1]], "names a vertex twice"),
        (np.eye(3), [[0.0, 1.0, 2.0]], "must be integers"),
        ([[np.nan, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], "must be finite"),
    ],
)
def test_bad_arrays_are_refused_in_one_sentence(vertices, faces, message):
    with pytest.raises(MeshError, match=message):
        TriangleMesh(vertices, faces)


def test_wrong_number_of_vertices_is_refused():
    with pytest.raises(MeshError, match="2 vertices given; the mesh has 4"):
        primitives.tetrahedron().with_vertices(np.zeros((2, 3)))
