"""The matrices of chapter 1, by hand, against networkx, and through files."""

import networkx as nx
import numpy as np
import pytest
from scipy.io import mmread
from scipy.sparse import load_npz

from core.mesh import MeshError, TriangleMesh, primitives
from core.mesh.matrices import MATRICES, laplacian_matrix, normalized_laplacian_matrix, save_matrix

TRIANGLE = TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        ("adjacency", [[0, 1, 1], [1, 0, 1], [1, 1, 0]]),
        ("edge", [[0, 3, 4], [3, 0, 5], [4, 5, 0]]),
        ("degree", [[2, 0, 0], [0, 2, 0], [0, 0, 2]]),
        ("laplacian", [[2, -1, -1], [-1, 2, -1], [-1, -1, 2]]),
        ("normalized_laplacian", [[1, -0.5, -0.5], [-0.5, 1, -0.5], [-0.5, -0.5, 1]]),
    ],
)
def test_triangle_by_hand(name, rows):
    assert np.allclose(MATRICES[name](TRIANGLE).toarray(), rows, atol=1e-15)


def test_traces_of_the_thesis():
    """|ℰ| = trace(D)/2 = trace(A²)/2, §1.2.3."""
    mesh = primitives.sphere(2)
    adjacency = MATRICES["adjacency"](mesh)
    assert MATRICES["degree"](mesh).trace() / 2 == len(mesh.edges)
    assert (adjacency @ adjacency).trace() / 2 == len(mesh.edges)


def test_laplacians_agree_with_networkx():
    mesh = TriangleMesh(np.eye(6, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    graph = nx.from_scipy_sparse_array(mesh.topology.adjacency)
    theirs = nx.laplacian_matrix(graph, weight=None).toarray()
    assert np.array_equal(laplacian_matrix(mesh).toarray(), theirs)
    theirs = nx.normalized_laplacian_matrix(graph, weight=None).toarray()
    assert np.allclose(normalized_laplacian_matrix(mesh).toarray(), theirs, atol=1e-15)


def test_edge_without_length_is_kept():
    mesh = TriangleMesh([[0, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, 1, 2]])
    assert MATRICES["edge"](mesh).nnz == 6


@pytest.mark.parametrize("name", MATRICES)
@pytest.mark.parametrize("suffix", [".mtx", ".npz"])
def test_files_bring_the_matrix_back(tmp_path, name, suffix):
    matrix = MATRICES[name](primitives.torus())
    path = tmp_path / f"matrix{suffix}"
    save_matrix(matrix, path)
    read = mmread(path) if suffix == ".mtx" else load_npz(path)
    assert np.allclose(read.toarray(), matrix.toarray(), rtol=1e-14)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_other_suffix_is_refused(tmp_path):
    with pytest.raises(MeshError, match=r"matrix.txt: .* use .mtx .npz"):
        save_matrix(MATRICES["degree"](TRIANGLE), tmp_path / "matrix.txt")


def test_folder_that_is_not_there_is_one_sentence(tmp_path):
    with pytest.raises(MeshError, match="cannot be written: No such file"):
        save_matrix(MATRICES["degree"](TRIANGLE), tmp_path / "gone" / "matrix.npz")
