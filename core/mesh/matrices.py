"""The matrices of a triangle mesh as sparse arrays, thesis §1.2.2–1.2.3, and files of them."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from core.arrays import FloatArray
from core.mesh import geometry
from core.mesh.errors import MeshError
from core.mesh.triangle_mesh import TriangleMesh
from core.whole_files import whole_file

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def adjacency_matrix(mesh: TriangleMesh) -> "csr_array":
    """Adjacency matrix A, (m, m): aᵢⱼ = 1 where vᵢ ~ vⱼ."""
    return mesh.topology.adjacency


def edge_matrix(mesh: TriangleMesh) -> "csr_array":
    """Edge matrix E, (m, m): eᵢⱼ = ‖vᵢ − vⱼ‖ where vᵢ ~ vⱼ, in model units, thesis §1.2.2.

    An edge without length is stored as an explicit zero, so that the edge is not lost.
    """
    ring = mesh.topology.vertex_ring
    lengths = geometry.edge_lengths(mesh)[mesh.topology.ring_edges]
    return scipy.sparse.csr_array(
        (lengths, ring.items, ring.starts), shape=(len(mesh.vertices),) * 2
    )


def degree_matrix(mesh: TriangleMesh) -> "csr_array":
    """Degree matrix D = diag(dᵢ), (m, m)."""
    return scipy.sparse.csr_array(scipy.sparse.diags_array(mesh.degrees.astype(np.float64)))


def laplacian_matrix(mesh: TriangleMesh) -> "csr_array":
    """Laplacian matrix L = D − A, (m, m), thesis §1.2.3; the sum of every row is 0."""
    return scipy.sparse.csr_array(degree_matrix(mesh) - adjacency_matrix(mesh))


def normalized_laplacian_matrix(mesh: TriangleMesh) -> "csr_array":
    """Normalised Laplacian 𝓛 = D^(−1/2) L D^(−1/2), (m, m), thesis §1.2.3.

    The row of an isolated vertex is zero, so that the zero eigenvalues count the components.
    """
    scale = scipy.sparse.diags_array(inverse_root_degrees(mesh))
    return scipy.sparse.csr_array(scale @ laplacian_matrix(mesh) @ scale)


def inverse_root_degrees(mesh: TriangleMesh) -> FloatArray:
    """1/√dᵢ of each vertex, (m,); 0 where a vertex is isolated."""
    degrees = mesh.degrees.astype(np.float64)
    result = np.zeros(len(degrees))
    np.divide(1, np.sqrt(degrees), out=result, where=degrees > 0)
    return result


MATRICES: dict[str, Callable[[TriangleMesh], "csr_array"]] = {
    "adjacency": adjacency_matrix,
    "edge": edge_matrix,
    "degree": degree_matrix,
    "laplacian": laplacian_matrix,
    "normalized_laplacian": normalized_laplacian_matrix,
}
"""The matrices by name, in the order of the thesis."""

MATRIX_SUFFIXES = (".mtx", ".npz")


def save_matrix(matrix: "csr_array", path: str | os.PathLike[str]) -> None:
    """Write a symmetric matrix as Matrix Market (.mtx) or as scipy's NPZ (.npz).

    Raises
    ------
    MeshError
        If the suffix is another, or the file cannot be written.
    """
    file = Path(path)
    writers: dict[str, Callable[[Any, csr_array], None]] = {
        ".mtx": _write_mtx,
        ".npz": scipy.sparse.save_npz,
    }
    if file.suffix.lower() not in writers:
        allowed = " ".join(MATRIX_SUFFIXES)
        raise MeshError(f"{file.name}: matrices are not written in this format; use {allowed}.")
    try:
        # Given a name instead of a file, both writers add a suffix of their own to it.
        with whole_file(file) as stream:
            writers[file.suffix.lower()](stream, matrix)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise MeshError(f"{file} cannot be written: {reason}.") from error


def _write_mtx(stream: Any, matrix: "csr_array") -> None:
    scipy.io.mmwrite(stream, matrix, symmetry="symmetric")
