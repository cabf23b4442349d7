"""Critical vertices of a field that is linear on each face.

Whether a vertex is critical is read from its link, the edges opposite it in its faces: the lower
link is the part with smaller values, the upper link the part with larger ones. Equal values are
told apart by the vertex number (simulation of simplicity), so that every vertex is either
regular or isolated.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange
from core.mesh import TriangleMesh


def vertex_ranks(values: FloatArray) -> IntArray:
    """Position of each vertex in the order of values, ties by vertex number, (m,) int32."""
    ranks = np.zeros(len(values), np.int32)
    ranks[np.argsort(values, kind="stable")] = np.arange(len(values), dtype=np.int32)
    return ranks


@kernel
def _find(parent: IntArray, x: int) -> int:
    while parent[x] != x:
        parent[x] = parent[parent[x]]
        x = parent[x]
    return x


@kernel
def _vertex_pieces(
    v: int, ranks: IntArray, faces: IntArray, ring: IntArray, around: IntArray
) -> tuple[int, int, int]:
    """Pieces of the lower and of the upper link of vertex v, and χ of the lower link."""
    parent = np.arange(len(ring)).astype(np.int32)
    lower = 0
    for j in ring:
        lower += ranks[j] < ranks[v]
    pieces = np.array([lower, len(ring) - lower])
    euler = lower
    for t in around:
        a, b, c = faces[t]
        i, j = (b, c) if a == v else ((a, c) if b == v else (a, b))
        upper = ranks[i] > ranks[v]
        if upper != (ranks[j] > ranks[v]):
            continue
        euler -= not upper
        x = _find(parent, np.searchsorted(ring, i))
        y = _find(parent, np.searchsorted(ring, j))
        if x != y:
            parent[x] = y
            pieces[int(upper)] -= 1
    return pieces[0], pieces[1], euler


@parallel_kernel
def link_pieces(
    ranks: IntArray,
    faces: IntArray,
    ring_starts: IntArray,
    ring_items: IntArray,
    face_starts: IntArray,
    face_items: IntArray,
) -> IntArray:
    """Pieces of the lower link, pieces of the upper link and index of each vertex, (m, 3)."""
    result = np.zeros((len(ranks), 3), np.int32)
    for v in prange(len(ranks)):
        ring = ring_items[ring_starts[v] : ring_starts[v + 1]]
        around = face_items[face_starts[v] : face_starts[v + 1]]
        lower, upper, euler = _vertex_pieces(v, ranks, faces, ring, around)
        result[v, 0], result[v, 1], result[v, 2] = lower, upper, 1 - euler
    return result


@dataclass(frozen=True, eq=False)
class CriticalVertices:
    """Critical vertices of a field, in ascending vertex order.

    Attributes
    ----------
    minima, maxima : (k,) int32 ndarray
        Vertices whose neighbours are all higher, or all lower.
    saddles : (s,) int32 ndarray
        Vertices whose lower or upper link falls into several pieces.
    multiplicity : (s,) int32 ndarray
        How often each saddle counts: −index, 1 for a simple saddle, 2 for a monkey saddle.
    index : (m,) int32 ndarray
        Index of every vertex, 1 − χ(lower link): 1 at a minimum or at a maximum inside the
        surface, −multiplicity at a saddle, 0 at a regular vertex.
    """

    minima: IntArray
    maxima: IntArray
    saddles: IntArray
    multiplicity: IntArray
    index: IntArray

    @property
    def index_sum(self) -> int:
        """Sum of all indices: the Euler characteristic of the mesh."""
        return int(self.index.sum())


def critical_vertices(mesh: TriangleMesh, values: FloatArray) -> CriticalVertices:
    """Find the minima, maxima and saddles of the field that is linear on each face.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh.
    values : (m,) float64 ndarray
        One value per vertex; equal ones are ordered by vertex number.

    Returns
    -------
    CriticalVertices
        On a closed surface #minima − Σ multiplicity + #maxima = χ. On any mesh, with boundary,
        pinched or non-manifold, the indices of all vertices sum to χ.

    Notes
    -----
    On a boundary a vertex counts by its lower link, like everywhere: a boundary minimum counts
    1, a boundary saddle as often as its lower link has pieces, less one. A boundary maximum, and
    a boundary saddle whose upper link alone is split, count 0, because adding them does not
    change the topology of the part below.

    References
    ----------
    Banchoff, "Critical points and curvature for embedded polyhedral surfaces", 1970; Edelsbrunner
    and Mücke, "Simulation of simplicity", 1990.
    """
    topology = mesh.topology
    lower, upper, index = link_pieces(
        vertex_ranks(values), mesh.faces, *topology.vertex_ring, *topology.vertex_faces
    ).T
    saddles = np.flatnonzero((lower > 1) | (upper > 1)).astype(np.int32)
    return CriticalVertices(
        minima=np.flatnonzero((lower == 0) & (upper > 0)).astype(np.int32),
        maxima=np.flatnonzero((upper == 0) & (lower > 0)).astype(np.int32),
        saddles=saddles,
        multiplicity=-index[saddles],
        index=index.copy(),
    )
