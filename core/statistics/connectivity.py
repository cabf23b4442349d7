"""Degree, average neighbour degree and clustering of every vertex, in one pass over the rings."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core.arrays import FloatArray, IntArray, frozen
from core.kernels import kernel, parallel_kernel, prange

if TYPE_CHECKING:
    from core.mesh import TriangleMesh


@dataclass(frozen=True, eq=False)
class Connectivity:
    """How each vertex is connected.

    Attributes
    ----------
    degrees : (m,) int32 ndarray
        Number of neighbours dᵢ.
    neighbour_degrees : (m,) float64 ndarray
        Average neighbour degree K_nn(vᵢ), 0 for an isolated vertex.
    clustering : (m,) float64 ndarray
        Clustering coefficient C(vᵢ), 0 where a vertex has fewer than two neighbours.
    assortativity_coefficient : float
        Correlation of the degrees at the two ends of an edge, −1 to 1; nan where all are equal.
    """

    degrees: IntArray
    neighbour_degrees: FloatArray
    clustering: FloatArray
    assortativity_coefficient: float


def connectivity(mesh: "TriangleMesh") -> Connectivity:
    """Degree, average neighbour degree and clustering coefficient of every vertex.

    K_nn(vᵢ) = (1/dᵢ) Σ dⱼ over vⱼ ∈ vᵢ*, thesis ch. 3 eq. (2).
    C(vᵢ) = 2·(edges between neighbours of vᵢ) / (dᵢ(dᵢ − 1)).

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh: closed or not, manifold or not, connected or not.

    Returns
    -------
    Connectivity
        One value a vertex for each quantity.

    Notes
    -----
    The printed C(vᵢ) = 2/(dᵢ − 1), eq. (4), is this one where the neighbours form a single closed
    ring without further edges. On a boundary the ring is open and C(vᵢ) = 2/dᵢ; where three
    vertices are joined without a face between them it is larger.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §3.3.1–3.3.4. Watts and Strogatz,
    *Collective dynamics of "small-world" networks*, 1998, for C. Newman, *Assortative mixing in
    networks*, 2002, for the coefficient.
    """
    starts, items = mesh.topology.vertex_ring
    neighbour_degrees, clustering = _ring_averages(starts, items)
    frozen(neighbour_degrees)
    frozen(clustering)
    coefficient = _degree_correlation(mesh.degrees, mesh.edges)
    return Connectivity(mesh.degrees, neighbour_degrees, clustering, coefficient)


@parallel_kernel
def _ring_averages(starts: IntArray, items: IntArray) -> tuple[FloatArray, FloatArray]:
    """K_nn and C of each vertex."""
    m = len(starts) - 1
    neighbour_degrees = np.zeros(m)
    clustering = np.zeros(m)
    for i in prange(m):
        ring = items[starts[i] : starts[i + 1]]
        d = len(ring)
        total, links = 0, 0
        for j in ring:
            other = items[starts[j] : starts[j + 1]]
            total += len(other)
            links += _common(ring, other)
        if d > 0:
            neighbour_degrees[i] = total / d
        if d > 1:
            # Every edge between two neighbours is met from both of its ends.
            clustering[i] = links / (d * (d - 1.0))
    return neighbour_degrees, clustering


@kernel
def _common(one: IntArray, other: IntArray) -> int:
    """Number of common entries of two ascending rows."""
    short, long = (one, other) if len(one) < len(other) else (other, one)
    count = 0
    for entry in short:
        # Searching keeps a vertex with very many neighbours from costing their square.
        place = np.searchsorted(long, entry)
        count += place < len(long) and long[place] == entry
    return count


def _degree_correlation(degrees: IntArray, edges: IntArray) -> float:
    """Pearson correlation of the degrees over all edges, each taken in both directions."""
    ends = degrees[edges].astype(np.float64)
    if not len(ends):
        return float("nan")
    centred = ends - ends.mean()
    variance = float((centred**2).mean())
    return float((centred[:, 0] * centred[:, 1]).mean() / variance) if variance else float("nan")
