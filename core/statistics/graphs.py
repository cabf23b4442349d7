"""Weighted graphs on the vertices, whose shortest paths stand for geodesics."""

from typing import TYPE_CHECKING

import numpy as np
import scipy

from core.arrays import FloatArray, first_rows
from core.mesh import TriangleMesh
from core.mesh.matrices import edge_matrix

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def nearest_neighbour_graph(points: FloatArray, neighbours: int) -> "csr_array":
    """Join each point with its k nearest others, in either direction, by Euclidean length.

    Thesis §3.3.5, step (i).

    Parameters
    ----------
    points : (m, 3) float64 ndarray
        Positions.
    neighbours : int
        k, at least 1; a larger one leaves fewer points apart and cuts more corners.

    Returns
    -------
    (m, m) csr_array
        Symmetric weights; points at the same place are joined by an explicit zero.
    """
    m = len(points)
    k = min(neighbours + 1, m)
    _, nearest = scipy.spatial.KDTree(points).query(points, k=np.arange(1, k + 1))
    pairs = np.stack([np.repeat(np.arange(m), k), nearest.ravel()], axis=1)
    pairs.sort(axis=1)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    one, other = pairs[first_rows(pairs)].T
    lengths = np.linalg.norm(points[one] - points[other], axis=1)
    rows, columns = np.concatenate([one, other]), np.concatenate([other, one])
    return scipy.sparse.csr_array((np.tile(lengths, 2), (rows, columns)), shape=(m, m))


def edge_graph(mesh: TriangleMesh) -> "csr_array":
    """Join the vertices along the edges of the mesh, by their lengths."""
    return edge_matrix(mesh)
