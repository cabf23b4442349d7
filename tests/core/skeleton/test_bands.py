"""The compiled bands against a slow reference that joins pieces of faces one by one."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.fields import normalise, scalar_field
from core.mesh import TriangleMesh, primitives
from core.mesh.geometry import face_areas
from core.parameters import ParameterError
from core.skeleton import band_levels, cut_surface, graph_of, level_rule, skeletal_graph
from core.skeleton.levels import area_below, vertex_bands

MESHES = {
    "ball": primitives.sphere(1),
    "torus": primitives.torus(9, 5),
    "grid": primitives.grid(5, 4),
    "pinched": TriangleMesh(np.eye(7, 3), [[0, 1, 2], [0, 3, 4], [4, 5, 6]]),
    "book": TriangleMesh(np.eye(6, 3), [[0, 1, 2], [0, 1, 3], [1, 0, 4], [3, 4, 5]]),
    "parts": TriangleMesh(np.eye(10, 3), [[0, 1, 2], [2, 1, 3], [4, 5, 6], [7, 8, 9]]),
}


def pieces_of_faces(mesh, bands):
    """Components and arcs by definition: pieces of a band join across edges and at vertices."""
    pieces, touching = nx.Graph(), set()
    for t, face in enumerate(mesh.faces.tolist()):
        low, high = bands[face].min(), bands[face].max()
        for band in range(low, high + 1):
            pieces.add_edge((t, band), ("face", t, band))
            if band < high:
                touching.add(((t, band), (t, band + 1)))
        for i, j in ((face[0], face[1]), (face[1], face[2]), (face[2], face[0])):
            pieces.add_edge((t, bands[i]), ("vertex", i, bands[i]))
            for band in range(min(bands[i], bands[j]), max(bands[i], bands[j]) + 1):
                pieces.add_edge((t, band), ("edge", min(i, j), max(i, j), band))
    components = list(nx.connected_components(pieces))
    number = {piece: k for k, component in enumerate(components) for piece in component}
    arcs = {(number[a], number[b]) for a, b in touching}
    return number, arcs, len(components)


@settings(deadline=None, max_examples=150)
@given(
    st.sampled_from(list(MESHES)),
    st.integers(0, 10**6),
    st.integers(1, 9),
    st.sampled_from([4, 8, 1000]),
)
def test_exact_bands_are_those_of_the_definition(kind, seed, resolution, steps):
    mesh = MESHES[kind]
    # Few steps put many vertices on the levels and make plateaus.
    values = np.random.default_rng(seed).integers(0, steps + 1, len(mesh.vertices)) / steps
    field = normalise(mesh, values)
    levels = band_levels(mesh, field, resolution)
    graph = graph_of(mesh, field, levels)
    bands = vertex_bands(field.values, levels)
    number, arcs, count = pieces_of_faces(mesh, bands)
    assert len(graph.nodes) == count
    owners, members = graph.pieces.faces, graph.pieces.nodes
    first = bands[mesh.faces[owners]].min(axis=1)
    piece_bands = first + np.arange(len(members)) - graph.pieces.starts[owners]
    assert np.array_equal(graph.band[members], piece_bands)
    same = {
        number[t, band]: node for t, band, node in zip(owners, piece_bands, members, strict=True)
    }
    assert all(
        same[number[t, band]] == node
        for t, band, node in zip(owners, piece_bands, members, strict=True)
    )
    assert {(same[a], same[b]) for a, b in arcs} == set(map(tuple, graph.arcs.tolist()))


def test_a_triangle_in_three_bands_by_hand():
    # The field is x on the triangle (0,0), (3,0), (0,3), which has the area 4.5.
    mesh = TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]])
    graph = skeletal_graph(mesh, "height", 3, x=1, z=0)
    assert graph.band.tolist() == [0, 1, 2]
    assert graph.arcs.tolist() == [[0, 1], [1, 2]]
    assert graph.area == pytest.approx([2.5, 1.5, 0.5])
    # Below x = 1 there are two triangles: (0,0), (1,0), (0,3) and (1,0), (1,2), (0,3).
    assert graph.nodes[0] == pytest.approx([(1.5 / 3 + 2 / 3) / 2.5, (1.5 + 5 / 3) / 2.5, 0])
    assert graph.nodes[2] == pytest.approx([7 / 3, 1 / 3, 0])


@pytest.mark.parametrize("kind", ["ball", "torus", "grid"])
@pytest.mark.parametrize("resolution", [1, 2, 7, 30])
def test_areas_and_centroids_are_those_of_the_cut_surface(kind, resolution):
    mesh = MESHES[kind]
    field = normalise(mesh, np.random.default_rng(3).random(len(mesh.vertices)))
    graph = graph_of(mesh, field, band_levels(mesh, field, resolution))
    cut = cut_surface(mesh, field, graph)
    corners = cut.points[cut.triangles]
    area = (
        np.linalg.norm(np.cross(*(corners[:, 1:] - corners[:, :1]).transpose(1, 0, 2)), axis=1) / 2
    )
    assert np.bincount(cut.nodes, area) == pytest.approx(graph.area)
    assert graph.area.sum() == pytest.approx(face_areas(mesh).sum())
    moments = [np.bincount(cut.nodes, area * x) for x in corners.mean(axis=1).T]
    assert np.stack(moments, axis=1) / graph.area[:, None] == pytest.approx(graph.nodes)
    node = len(graph.nodes) // 2
    alone = cut_surface(mesh, field, graph, node)
    assert set(alone.nodes) == {node}
    assert len(alone.triangles) == np.count_nonzero(cut.nodes == node)


def test_a_vertex_on_a_level_belongs_to_the_band_above():
    levels = np.array([0.25, 0.5])
    assert vertex_bands(np.array([0, 0.25, 0.3, 0.5, 1]), levels).tolist() == [0, 1, 1, 2, 2]
    # A peak exactly on a level is a node without area, at its place.
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2], [1, 2, 3]])
    field = normalise(mesh, np.array([0.5, 0, 0.4, 1]))
    graph = graph_of(mesh, field, levels)
    peak = graph.pieces.vertex_nodes[0]
    assert graph.area[peak] == 0
    assert graph.nodes[peak] == pytest.approx([0, 0, 0])
    assert graph.degrees[peak] == 1


def test_area_below_by_hand():
    faces = np.array([[0, 1, 2]], np.int32)
    values = np.array([0.0, 0.5, 1.0])
    samples = np.array([0.0, 0.25, 0.5, 0.75, 1.0])
    assert area_below(values, faces, np.array([2.0]), samples) == pytest.approx(
        [0, 0.25, 1, 1.75, 2]
    )


def test_spacings():
    mesh = primitives.sphere(4).with_vertices(primitives.sphere(4).vertices * [3, 2, 1])
    field = scalar_field(mesh, "euclidean")
    assert band_levels(mesh, field, 4) == pytest.approx([0.25, 0.5, 0.75])
    roots = np.sqrt(field.raw(band_levels(mesh, field, 4, "distance")))
    assert roots == pytest.approx([1.5, 2, 2.5])
    rule = level_rule(mesh, field, "area")
    for resolution in (2, 5, 20):
        graph = graph_of(mesh, field, rule(resolution))
        shares = np.bincount(graph.band, graph.area) / graph.area.sum()
        assert shares == pytest.approx(1 / resolution, abs=2e-3)
    height = scalar_field(mesh, "height")
    assert np.array_equal(
        band_levels(mesh, height, 6, "distance"), band_levels(mesh, height, 6, "value")
    )


def test_errors_say_what_is_allowed():
    mesh = primitives.tetrahedron()
    field = scalar_field(mesh, "height")
    for resolution in (0, -3, 1025):
        with pytest.raises(ParameterError, match=f"resolution={resolution} is not allowed; use 1"):
            band_levels(mesh, field, resolution)
    with pytest.raises(ParameterError, match="value, distance, area"):
        band_levels(mesh, field, 4, "random")
