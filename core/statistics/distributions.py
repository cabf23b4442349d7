"""How a quantity is distributed over the vertices: by degree, and as a histogram."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core.arrays import FloatArray, IntArray, frozen
from core.statistics.connectivity import Connectivity

if TYPE_CHECKING:
    from numpy.typing import NDArray

_BINS = 24


@dataclass(frozen=True)
class AxisLabels:
    """What the two axes of a plot say."""

    x: str
    y: str


@dataclass(frozen=True, eq=False)
class Histogram:
    """Counts of values in bins of equal width.

    Attributes
    ----------
    edges : (b + 1,) float64 ndarray
        Ends of the bins; a value on an inner end belongs to the bin above it.
    counts : (b,) int64 ndarray
        Number of values in each bin.
    """

    edges: FloatArray
    counts: "NDArray[np.int64]"

    @property
    def shares(self) -> FloatArray:
        """Share of all values in each bin, (b,)."""
        shares: FloatArray = self.counts / max(int(self.counts.sum()), 1)
        return shares

    @property
    def centres(self) -> FloatArray:
        """Middle of each bin, (b,)."""
        centres: FloatArray = (self.edges[1:] + self.edges[:-1]) / 2
        return centres


@dataclass(frozen=True, eq=False)
class ByDegree(Mapping[int, float]):
    """A quantity for each degree that occurs, read like a dictionary from degree to value.

    Attributes
    ----------
    degrees : (k,) int32 ndarray
        The degrees that occur, ascending.
    quantity : (k,) float64 ndarray
        The quantity at each of them.
    counts : (k,) int64 ndarray
        Number m_k of vertices of each degree.
    labels : AxisLabels
        Labels of its plot.
    histogram : Histogram or None
        How the quantity is spread over the vertices; None where the values are shares already.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> from core.statistics.connectivity import connectivity
    >>> dict(degree_distribution(connectivity(primitives.icosahedron())))
    {5: 1.0}
    """

    degrees: IntArray
    quantity: FloatArray
    counts: "NDArray[np.int64]"
    labels: AxisLabels
    histogram: Histogram | None = None

    def __getitem__(self, degree: int) -> float:
        """Return the quantity at a degree."""
        place = int(np.searchsorted(self.degrees, degree))
        if place == len(self.degrees) or self.degrees[place] != degree:
            raise KeyError(degree)
        return float(self.quantity[place])

    def __iter__(self) -> Iterator[int]:
        """Iterate over the degrees."""
        return iter(self.degrees.tolist())

    def __len__(self) -> int:
        """Return the number of degrees that occur."""
        return len(self.degrees)


def degree_distribution(vertices: Connectivity) -> ByDegree:
    """Share p_k = m_k/m of the vertices of each degree k, thesis §3.3.2."""
    degrees, counts, _ = _degrees(vertices)
    labels = AxisLabels("degree k", "share of vertices p(k)")
    return ByDegree(degrees, counts / max(int(counts.sum()), 1), counts, labels)


def assortativity(vertices: Connectivity) -> ByDegree:
    """Assortativity function K_nn(k), thesis ch. 3 eq. (3), with the histogram of K_nn(v).

    K_nn(k) = (1/m_k) Σ K_nn(vᵢ) over the vertices of degree k.
    """
    labels = AxisLabels("degree k", "average neighbour degree K_nn(k)")
    return _averaged(vertices, vertices.neighbour_degrees, labels)


def clustering(vertices: Connectivity) -> ByDegree:
    """Average clustering coefficient C(k), thesis ch. 3 eq. (5), with the histogram of C(v).

    C(k) = (1/m_k) Σ C(vᵢ) over the vertices of degree k.
    """
    labels = AxisLabels("degree k", "clustering coefficient C(k)")
    return _averaged(vertices, vertices.clustering, labels)


def value_histogram(values: FloatArray, bins: int = _BINS) -> Histogram:
    """Histogram of values between their ends; a single value gets a bin around it."""
    counts, edges = np.histogram(values, bins if len(values) else 1)
    frozen(counts)
    frozen(edges)
    return Histogram(edges.astype(np.float64), counts.astype(np.int64))


def _averaged(vertices: Connectivity, quantity: FloatArray, labels: AxisLabels) -> ByDegree:
    degrees, counts, places = _degrees(vertices)
    means = np.bincount(places, quantity, len(degrees)) / np.maximum(counts, 1)
    frozen(means)
    return ByDegree(degrees, means, counts, labels, value_histogram(quantity))


def _degrees(vertices: Connectivity) -> tuple[IntArray, "NDArray[np.int64]", "NDArray[np.intp]"]:
    """Degrees that occur, how often, and the place of each vertex among them."""
    degrees, places, counts = np.unique(vertices.degrees, return_inverse=True, return_counts=True)
    frozen(degrees)
    frozen(counts)
    return degrees, counts, places
