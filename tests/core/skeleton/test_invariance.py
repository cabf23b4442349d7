"""A similarity transform of the model changes nothing but where the nodes are."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial.transform import Rotation

from core.mesh import primitives
from core.skeleton import skeletal_graph

similarities = st.tuples(
    hnp.arrays(np.float64, 3, elements=st.floats(-3, 3)),
    hnp.arrays(np.float64, 3, elements=st.floats(-5, 5)),
    st.floats(1e-3, 1e3),
    st.booleans(),
)


def check_invariance(mesh, similarity, resolution):
    turn, shift, scale, mirror = similarity
    size = np.ptp(mesh.vertices, axis=0).max()
    matrix = scale * Rotation.from_rotvec(turn).as_matrix() @ np.diag([1, 1, -1 if mirror else 1])

    def move(points):
        return points @ matrix.T + shift * scale * size

    before = skeletal_graph(mesh, resolution=resolution)
    after = skeletal_graph(mesh.with_vertices(move(mesh.vertices)), resolution=resolution)
    # The vertices keep their numbers, and so do the nodes: isomorphic by the identity.
    assert np.array_equal(before.arcs, after.arcs)
    assert np.array_equal(before.band, after.band)
    assert np.abs(after.nodes - move(before.nodes)).max() <= 1e-6 * size * scale


@settings(deadline=None, max_examples=25)
@given(similarities, st.integers(1, 64))
def test_primitives(similarity, resolution):
    for mesh in (primitives.torus(30, 14), primitives.grid(9, 7), primitives.tetrahedron()):
        check_invariance(mesh, similarity, resolution)


def check_model(mesh):
    @settings(deadline=None, max_examples=4)
    @given(similarities, st.sampled_from([5, 22, 64]))
    def check(similarity, resolution):
        check_invariance(mesh, similarity, resolution)

    check()


def test_closed_models(model, closed):
    check_model(model(closed))


def test_awkward_models(model, awkward):
    check_model(model(awkward))


@settings(deadline=None, max_examples=15)
@given(st.integers(0, 10**6))
def test_the_order_of_vertices_and_faces_does_not_count(seed):
    rng = np.random.default_rng(seed)
    mesh = primitives.torus(24, 11)
    # Dents, so that no two vertices have the same distance.
    mesh = mesh.with_vertices(mesh.vertices * (1 + 0.1 * np.sin(np.arange(264)))[:, None])
    place = rng.permutation(len(mesh.vertices))
    vertices = np.zeros_like(mesh.vertices)
    vertices[place] = mesh.vertices
    shuffled = type(mesh)(vertices, rng.permutation(place[mesh.faces]))
    before, after = (skeletal_graph(m, resolution=12).to_networkx() for m in (mesh, shuffled))
    assert nx.is_isomorphic(
        before,
        after,
        lambda a, b: a["band"] == b["band"] and a["area"] == pytest.approx(b["area"]),
    )
