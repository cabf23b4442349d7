"""The skeletal graph: by hand, its root and kinds, and the printed algorithm's false loops."""

import networkx as nx
import numpy as np
import pytest

from core.fields import normalise, scalar_field
from core.mesh import MeshError, TriangleMesh, primitives
from core.parameters import ParameterError
from core.skeleton import GraphError, band_levels, cut_surface, graph_of, skeletal_graph


def test_a_tetrahedron_is_a_line():
    graph = skeletal_graph(primitives.tetrahedron(), "height", 5, x=0.3, y=0.2)
    assert (len(graph.nodes), len(graph.arcs), graph.loops, graph.components) == (5, 4, 0, 1)
    assert graph.kinds.tolist() == ["end", "regular", "regular", "regular", "end"]
    assert graph.band.tolist() == [0, 1, 2, 3, 4]


def test_one_band_is_one_node_at_the_centroid_of_the_surface():
    graph = skeletal_graph(primitives.sphere(2), "height", 1)
    assert graph.nodes == pytest.approx(np.zeros((1, 3)), abs=1e-12)
    assert graph.kinds.tolist() == ["end"]


def test_a_torus_on_its_side_has_one_loop():
    mesh = primitives.torus(48, 16)
    graph = skeletal_graph(mesh, "height", 9, x=1, z=0)
    assert graph.loops == 1
    kinds = dict(zip(*np.unique(graph.kinds, return_counts=True), strict=True))
    assert kinds == {"end": 2, "branch": 2, "regular": len(graph.nodes) - 4}
    # Lying flat it is cut into rings, inner and outer ones only where it is highest and lowest.
    assert skeletal_graph(mesh, "height", 9).loops == 1
    assert skeletal_graph(mesh, "height", 1, x=1, z=0).loops == 0


def test_a_grid_is_a_line_of_its_columns():
    graph = skeletal_graph(primitives.grid(4, 3), "height", 4, x=1, z=0)
    assert graph.arcs.tolist() == [[0, 1], [1, 2], [2, 3]]
    assert graph.area == pytest.approx([3, 3, 3, 3])
    assert graph.nodes[:, 0] == pytest.approx([0.5, 1.5, 2.5, 3.5])
    assert graph.nodes[:, 1] == pytest.approx([1.5] * 4)


def test_a_plateau_stays_whole():
    mesh = primitives.grid(6, 6)
    top = np.abs(mesh.vertices[:, :2] - 3).max(axis=1) <= 2
    for level in (0.5, 1.0):
        graph = graph_of(mesh, normalise(mesh, top.astype(float)), np.array([level]))
        assert graph.band.tolist() == [0, 1]
        assert graph.area[1] == pytest.approx(16 + (level == 0.5) * (25 - 16), abs=0.6)


def test_a_constant_field_gives_one_node_for_each_part():
    mesh = TriangleMesh(np.eye(6, 3), [[0, 1, 2], [3, 4, 5]])
    graph = graph_of(mesh, normalise(mesh, np.ones(6)), np.array([0.3, 0.6]))
    assert (len(graph.nodes), len(graph.arcs), graph.components) == (2, 0, 2)


@pytest.mark.parametrize("bands", ["exact", "vertices"])
def test_the_root_joins_the_first_band_and_does_not_count(bands):
    mesh = primitives.torus(24, 12)
    plain = skeletal_graph(mesh, "euclidean", 6, bands)
    rooted = skeletal_graph(mesh, "euclidean", 6, bands, root=True)
    assert rooted.root == len(plain.nodes)
    assert rooted.nodes[rooted.root] == pytest.approx([0, 0, 0], abs=1e-12)
    assert (rooted.loops, rooted.components) == (plain.loops, plain.components)
    spokes = rooted.arcs[len(plain.arcs) :]
    assert set(spokes[:, 0]) == {rooted.root}
    assert np.array_equal(spokes[:, 1], np.flatnonzero(plain.band == 0))
    assert rooted.band[rooted.root] == rooted.component[rooted.root] == -1


def test_members_light_up_the_surface_of_a_node():
    mesh = primitives.torus(24, 12)
    field = scalar_field(mesh, "height", x=1, y=0.1, z=0)
    graph = graph_of(mesh, field, band_levels(mesh, field, 6))
    for node in range(len(graph.nodes)):
        inside = graph.member_vertices(node)
        assert np.all(np.floor(field.values[inside] * 6).clip(max=5) == graph.band[node])
        faces = graph.member_faces(node)
        assert set(np.flatnonzero(np.isin(mesh.faces, inside).any(axis=1))) <= set(faces)
        cut = cut_surface(mesh, field, graph, node)
        assert cut.points.min() >= mesh.vertices.min() - 1e-12
    whole = np.unique(np.concatenate([graph.member_faces(k) for k in range(len(graph.nodes))]))
    assert len(whole) == len(mesh.faces)


def test_vertex_bands_are_means_of_vertices():
    mesh = primitives.grid(5, 2)
    graph = skeletal_graph(mesh, "height", 3, "vertices", x=1, z=0)
    assert graph.nodes[:, 0] == pytest.approx([0.5, 2.5, 4.5])
    assert graph.area == pytest.approx([3, 4, 3])
    assert graph.member_vertices(0).tolist() == [0, 1, 6, 7, 12, 13]
    assert graph.member_faces(0).tolist() == [0, 1, 5, 6, 10, 11, 15, 16]


def test_vertex_bands_make_false_loops_where_exact_bands_make_none(model):
    # The number that stands in the design for the 5,804-face cow at R = 22.
    cow = model("cow_2903.obj")
    assert skeletal_graph(cow, bands="vertices").loops == 530
    assert skeletal_graph(cow).loops == 0


def test_networkx_form():
    graph = skeletal_graph(primitives.torus(), "euclidean", 5, root=True)
    net = graph.to_networkx()
    assert net.number_of_nodes() == len(graph.nodes)
    assert net.number_of_edges() == len(graph.arcs)
    assert net.graph == {
        "field": "euclidean",
        "bands": "exact",
        "resolution": 5,
        "root": graph.root,
    }
    assert net.nodes[0]["x"] == graph.nodes[0, 0]
    assert nx.number_connected_components(net.subgraph(set(net) - {graph.root})) == graph.components


def test_arrays_are_read_only():
    graph = skeletal_graph(primitives.torus())
    for array in (graph.nodes, graph.arcs, graph.band, graph.area, graph.component, *graph.pieces):
        assert not array.flags.writeable


def test_errors_say_what_is_allowed():
    mesh = primitives.tetrahedron()
    with pytest.raises(ParameterError, match="bands=round is not one of exact, vertices"):
        skeletal_graph(mesh, bands="round")
    with pytest.raises(MeshError, match="has no faces"):
        skeletal_graph(TriangleMesh(np.eye(3), np.zeros((0, 3), int)))
    with pytest.raises(MeshError, match="4 values; the mesh has"):
        graph_of(primitives.torus(), scalar_field(mesh, "height"), np.array([0.5]))
    graph = skeletal_graph(mesh)
    with pytest.raises(GraphError, match="node 99 does not exist"):
        graph.member_faces(99)
    loose = skeletal_graph(mesh, bands="vertices")
    with pytest.raises(GraphError, match="use exact bands"):
        cut_surface(mesh, scalar_field(mesh, "mixture"), loose)
