"""The Reeb graph: by hand, against VTK's, and its simplification."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.fields import critical_vertices, normalise, scalar_field
from core.mesh import MeshError, TriangleMesh, primitives
from core.skeleton import reeb_graph
from core.skeleton.simplify import simplified_arcs

ORACLE = [
    "cow_2903.obj",
    "cow_2904.off",
    "double_torus_820_open.obj",
    "double_torus_eight_766.off",
    "elephant_2775.off",
    "fertility_4494.off",
    "skull_5154.obj",
    "spider_4670.ply",
    "teapot_3644.obj",
    "awkward/bunny_res2_nonmanifold.ply",
    "awkward/elephant_with_holes.off",
    "awkward/knot2_2comps.off",
    "awkward/many_small_holes.ply",
    "awkward/nonmanifold_hole.ply",
]
"""Models on which VTK's Reeb graph is compared: closed, open, pinched, non-manifold."""


def vtk_loops_and_components(mesh, values):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import (
        vtkCellArray,
        vtkEdgeListIterator,
        vtkPolyData,
        vtkReebGraph,
    )

    points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.array(mesh.vertices), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(mesh.faces.ravel().astype(np.int64), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(cells)
    scalars = numpy_to_vtk(np.array(values), deep=True)
    scalars.SetName("field")
    surface.GetPointData().SetScalars(scalars)
    graph, arcs, net = vtkReebGraph(), vtkEdgeListIterator(), nx.MultiGraph()
    graph.Build(surface, scalars)
    graph.GetEdges(arcs)
    net.add_nodes_from(range(graph.GetNumberOfVertices()))
    while arcs.HasNext():
        arc = arcs.NextGraphEdge()
        net.add_edge(arc.GetSource(), arc.GetTarget())
    components = nx.number_connected_components(net)
    return net.number_of_edges() - net.number_of_nodes() + components, components


@pytest.mark.parametrize("name", ORACLE)
def test_loops_and_components_agree_with_vtk(model, name):
    mesh = model(name)
    for field_name in ("mixture", "height"):
        field = scalar_field(mesh, field_name)
        graph = reeb_graph(mesh, field)
        expected = vtk_loops_and_components(mesh, field.values)
        assert (graph.loops, graph.components) == expected


def test_as_many_loops_as_the_genus(model, closed):
    mesh = model(closed)
    for name in ("mixture", "euclidean", "affine", "height"):
        field = scalar_field(mesh, name)
        graph = reeb_graph(mesh, field)
        assert graph.loops == mesh.genus
        assert graph.components == mesh.topology.component_count
        found = critical_vertices(mesh, field.values)
        ends = graph.vertices[graph.down_degrees == 0], graph.vertices[graph.up_degrees == 0]
        assert set(ends[0]) == set(found.minima)
        assert set(ends[1]) == set(found.maxima)
        assert set(graph.vertices) <= {*found.minima, *found.maxima, *found.saddles}
        balance = len(found.minima) - found.multiplicity.sum() + len(found.maxima)
        assert balance == mesh.euler_characteristic


def test_a_torus_on_its_side_by_hand():
    mesh = primitives.torus(48, 16)
    field = scalar_field(mesh, "height", x=1, y=0.001, z=0.0001)
    graph = reeb_graph(mesh, field)
    assert graph.kinds.tolist() == ["minimum", "split", "merge", "maximum"]
    # The hole reaches from −0.6 to 0.6, the torus from −1.4 to 1.4.
    assert graph.values == pytest.approx([0, 0.8 / 2.8, 2 / 2.8, 1], abs=2e-3)
    assert graph.arcs.tolist() == [[0, 1], [1, 2], [1, 2], [2, 3]]
    assert graph.lengths == pytest.approx([0.286, 0.429, 0.429, 0.286], abs=2e-3)
    assert (graph.loops, graph.components) == (1, 1)
    assert np.array_equal(graph.nodes, mesh.vertices[graph.vertices])
    assert graph.to_networkx().number_of_edges(1, 2) == 2
    assert graph.simplified(0.42).loops == 1
    assert graph.simplified(0.44).arcs.tolist() == [[0, 1]]


def level_set_components(mesh, values, level):
    """Components of one level set, by definition: crossed edges joined by crossed faces."""
    above = values > level
    net = nx.Graph()
    for face in mesh.faces:
        ends = [
            tuple(sorted((int(face[c]), int(face[c - 1]))))
            for c in range(3)
            if above[face[c]] != above[face[c - 1]]
        ]
        if ends:
            net.add_edge(*ends)
    return nx.number_connected_components(net)


BOOK = TriangleMesh(np.eye(7, 3), [[0, 1, 2], [0, 1, 3], [1, 0, 4], [3, 4, 5], [2, 5, 6]])
MESHES = {
    "ball": primitives.sphere(2),
    "torus": primitives.torus(14, 9),
    "grid": primitives.grid(8, 6),
    "book": BOOK,
}


@settings(deadline=None, max_examples=60)
@given(st.sampled_from(list(MESHES)), st.integers(0, 10**6))
def test_its_arcs_are_the_components_of_every_level_set(kind, seed):
    mesh = MESHES[kind]
    values = np.random.default_rng(seed).permutation(len(mesh.vertices)).astype(float)
    graph = reeb_graph(mesh, normalise(mesh, values))
    heights = values[graph.vertices]
    for level in np.linspace(0.5, len(values) - 1.5, 12).round() + 0.5:
        crossed = (heights[graph.arcs[:, 0]] < level) & (heights[graph.arcs[:, 1]] > level)
        assert crossed.sum() == level_set_components(mesh, values, level)
    if kind in ("ball", "torus"):
        assert graph.loops == mesh.genus


@settings(deadline=None, max_examples=30)
@given(st.integers(0, 10**6), st.floats(0, 1))
def test_simplifying_keeps_components_and_only_removes(seed, share):
    mesh = MESHES["torus"]
    graph = reeb_graph(mesh, normalise(mesh, np.random.default_rng(seed).random(126)))
    less = graph.simplified(share)
    assert less.components == graph.components
    assert less.loops <= graph.loops
    assert set(less.vertices) <= set(graph.vertices)
    assert len(less.simplified(share).arcs) == len(less.arcs)
    branches = (less.down_degrees[less.arcs[:, 1]] > 1) & (less.down_degrees[less.arcs[:, 0]] == 0)
    assert np.all(less.lengths[branches] > share)


def test_plateaus_leave_nothing_after_simplifying():
    mesh = primitives.grid(9, 9)
    steps = np.minimum(mesh.vertices[:, 0], 5)
    graph = reeb_graph(mesh, normalise(mesh, steps))
    assert graph.simplified(0).arcs.tolist() == [[0, 1]]


def simplified(values, arcs, limit):
    return simplified_arcs(np.array(values, float), np.array(arcs, np.int32), limit).tolist()


def test_the_shorter_branch_goes_first():
    # Minima at 0 and 3 meet at 4; the shorter one is 1 long.
    arcs = [[0, 2], [1, 2], [2, 3]]
    assert simplified([0, 3, 4, 9], arcs, 0.5) == arcs
    assert simplified([0, 3, 4, 9], arcs, 1) == [[0, 3]]


def test_a_loop_inside_a_loop():
    # 0 –1 splits– (2 splits and merges at 3) … 4 merges – 5
    arcs = [[0, 1], [1, 2], [1, 4], [2, 3], [2, 3], [3, 4], [4, 5]]
    values = [0, 1, 2, 3, 6, 7]
    assert simplified(values, arcs, 1) == [[0, 1], [1, 4], [1, 4], [4, 5]]
    assert simplified(values, arcs, 5) == [[0, 5]]


def test_a_short_loop_between_long_branches_closes_without_them():
    # Two long legs (nodes 0 and 1), two long arms (6 and 7), and a ring 2-4-3-5 that zigzags.
    arcs = [[0, 2], [1, 3], [2, 4], [2, 5], [3, 4], [3, 5], [4, 6], [5, 7]]
    values = [-100, -99, 0, 1, 2, 3, 99, 100]
    assert simplified(values, arcs, 2) == arcs
    assert simplified(values, arcs, 3) == [[0, 3], [1, 3], [3, 4], [4, 6], [4, 7]]


def test_the_last_arc_stays():
    assert simplified([0, 1], [[0, 1]], 5) == [[0, 1]]


def test_errors():
    empty = TriangleMesh(np.eye(3), np.zeros((0, 3), int))
    with pytest.raises(MeshError, match="has no faces"):
        reeb_graph(empty, normalise(empty, np.arange(3.0)))
