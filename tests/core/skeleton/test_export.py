"""Every format gives back the graph that was written, and refuses what it cannot hold."""

import networkx as nx
import numpy as np
import pytest

from core.mesh import TriangleMesh, primitives
from core.skeleton import FORMATS, GraphError, read_graph, skeletal_graph, write_graph

PARTS = TriangleMesh(
    np.random.default_rng(5).random((9, 3)) / 3, [[0, 1, 2], [2, 1, 3], [4, 5, 6], [6, 7, 8]]
)


def graphs():
    torus = primitives.torus(30, 14)
    return {
        "loops": skeletal_graph(torus, "height", 9, x=1, y=0.1, z=0),
        "rooted": skeletal_graph(torus, "mixture", 7, root=True),
        "tree": skeletal_graph(primitives.sphere(2), "height", 12),
        "rooted tree": skeletal_graph(primitives.tetrahedron(), "height", 4, root=True),
        "parts": skeletal_graph(PARTS, "euclidean", 5, spacing="distance"),
        "printed": skeletal_graph(torus, "affine", 4, bands="vertices"),
        "one node": skeletal_graph(torus, resolution=1),
    }


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("kind", graphs())
def test_round_trip(tmp_path, suffix, kind):
    graph = graphs()[kind]
    path = tmp_path / f"graph{suffix}"
    if suffix == ".swc" and kind in ("loops", "rooted", "printed"):
        with pytest.raises(GraphError, match=r"SWC holds trees only; this graph has \d+ loops"):
            write_graph(graph, path)
        assert not path.exists()
        return
    write_graph(graph, path)
    again = read_graph(path)
    for name in ("nodes", "arcs", "band", "area", "component"):
        assert np.array_equal(getattr(graph, name), getattr(again, name)), name
    for name in ("root", "resolution", "field", "bands", "loops", "components"):
        assert getattr(graph, name) == getattr(again, name), name
    with pytest.raises(GraphError, match="read from a file"):
        again.member_faces(0)


def test_other_programs_read_the_files(tmp_path):
    graph = graphs()["tree"]
    for suffix in FORMATS:
        write_graph(graph, tmp_path / f"graph{suffix}")
    net = nx.read_graphml(tmp_path / "graph.graphml")
    assert net.number_of_edges() == len(graph.arcs)
    lines = (tmp_path / "graph.obj").read_text().splitlines()
    assert sum(line.startswith("v ") for line in lines) == len(graph.nodes)
    assert sum(line.startswith("l ") for line in lines) == len(graph.arcs)
    samples = np.loadtxt(tmp_path / "graph.swc")
    assert np.array_equal(samples[:, 0], np.arange(1, len(graph.nodes) + 1))
    assert np.all(samples[:, 6] < samples[:, 0])


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("content", ["", "{}", "v 1 2", "l 1 2\n", "\0"])
def test_broken_files_are_refused_in_one_sentence(tmp_path, suffix, content):
    path = tmp_path / f"broken{suffix}"
    path.write_text(content)
    with pytest.raises(GraphError, match=f"broken{suffix} is not a graph in the format"):
        read_graph(path)


def test_unknown_suffixes_are_named(tmp_path):
    for action in (lambda path: write_graph(graphs()["tree"], path), read_graph):
        with pytest.raises(GraphError, match=r"ends in one of \.graphml, \.json, \.obj"):
            action(tmp_path / "graph.dwg")
