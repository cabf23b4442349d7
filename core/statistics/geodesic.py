"""Distribution of the geodesic distances between the vertices, thesis §3.3.5."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from core.arrays import FloatArray, IntArray
from core.mesh import TriangleMesh
from core.parameters import Params, param
from core.statistics.distributions import AxisLabels, Histogram
from core.statistics.geodesic_sources import (
    Chunks,
    Rows,
    along_edges,
    along_neighbours,
    along_surface,
)
from core.statistics.modes import modes
from core.statistics.progress import Progress, finished
from core.statistics.tally import Tally

_BINS, _FEWEST_BINS = 72, 8
_CHUNK = 60_000


class GeodesicParams(Params):
    """How geodesic distances are measured, and between which vertices."""

    along: Literal["neighbours", "edges", "surface"] = param(
        "neighbours",
        help="Paths: the thesis' graph of nearest neighbours, the mesh's edges, or the surface.",
    )
    neighbours: int = param(
        8,
        low=1,
        high=100,
        step=1,
        help="Nearest neighbours k of a vertex in the graph; more cut corners, fewer leave gaps.",
    )
    sources: int = param(
        200,
        low=1,
        high=100_000,
        step=50,
        help="Random vertices that distances are taken from; more is slower and less noisy.",
    )
    seed: int = param(0, low=0, high=2**31 - 1, step=1, help="Seed of the random vertices.")


@dataclass(frozen=True, eq=False)
class GeodesicDistances:
    """Distribution of the distances from some vertices to all others.

    Attributes
    ----------
    params : GeodesicParams
        How they were measured.
    histogram : Histogram
        Counts of the finite distances; its edges are in units of ℓ̄.
    sources : int
        Number of vertices the distances were taken from.
    pairs : int
        Number of ordered pairs of different vertices that were looked at.
    unreachable_pairs : int
        Pairs without a path between them.
    mean, longest : float
        Of the finite distances, in units of ℓ̄.
    mean_edge_length : float
        ℓ̄ in model units.
    """

    params: GeodesicParams
    histogram: Histogram
    sources: int
    pairs: int
    unreachable_pairs: int
    mean: float
    longest: float
    mean_edge_length: float

    @property
    def labels(self) -> AxisLabels:
        """Labels of its plot."""
        return AxisLabels("geodesic distance (ℓ̄)", "share of pairs")

    @property
    def modes(self) -> FloatArray:
        """Distances at which the smoothed distribution has a peak, in units of ℓ̄, ascending."""
        return modes(self.histogram)


def geodesic_steps(
    mesh: TriangleMesh, params: GeodesicParams | None = None
) -> Iterator[Progress[GeodesicDistances]]:
    """Measure geodesic distances, a few source vertices at a time.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh; pairs of vertices without a path between them are counted apart.
    params : GeodesicParams, optional
        How to measure; the thesis' way if not given.

    Yields
    ------
    Progress of GeodesicDistances
        The distribution so far. Never more than a few rows of distances are kept.

    Raises
    ------
    StatisticsError
        If the heat method does not work on this mesh.

    Notes
    -----
    ``neighbours`` is the thesis' way, after Isomap: paths may leave the surface where two parts
    come near each other. ``edges`` stays on the surface but zigzags, so it never falls short of
    the true distance. ``surface`` is the heat method: smooth, and a few per cent off where the
    triangles are large.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §3.3.5.
    """
    settings = params or GeodesicParams()
    yield Progress(None, 0.0)
    sources = source_vertices(mesh, settings)
    chunks = np.array_split(sources, _chunk_count(len(sources), len(mesh.vertices)))
    progress: Progress[GeodesicDistances] = Progress(None, 0.0)
    tally, done, to_come = Tally(), 0, iter(chunks)
    for rows in _rows(mesh, settings, chunks):
        if rows is not None:
            chunk = next(to_come)
            _add(tally, rows, chunk)
            done += len(chunk)
            progress = Progress(_result(mesh, settings, tally, done), done / max(len(sources), 1))
        yield progress


def source_vertices(mesh: TriangleMesh, params: GeodesicParams) -> IntArray:
    """Choose the random subset of vertices that distances are taken from."""
    m = len(mesh.vertices)
    chosen = np.random.default_rng(params.seed).permutation(m)[: params.sources]
    return chosen.astype(np.int32)


def distances_from_vertex(mesh: TriangleMesh, vertex: int, params: GeodesicParams) -> FloatArray:
    """Distance from one vertex to every other in model units, (m,); inf where there is no path."""
    return finished(vertex_distance_steps(mesh, vertex, params))


def vertex_distance_steps(
    mesh: TriangleMesh, vertex: int, params: GeodesicParams
) -> Iterator[Progress[FloatArray]]:
    """Find what :func:`distances_from_vertex` returns, step by step."""
    for rows in _rows(mesh, params, [np.array([vertex], np.int32)]):
        yield Progress(None, 0.0) if rows is None else Progress(rows[0], 1.0)


def _rows(mesh: TriangleMesh, params: GeodesicParams, chunks: Chunks) -> Rows:
    if params.along == "neighbours":
        return along_neighbours(mesh, chunks, params.neighbours)
    return along_edges(mesh, chunks) if params.along == "edges" else along_surface(mesh, chunks)


def _chunk_count(sources: int, vertices: int) -> int:
    """Number of chunks so that none takes long, whatever the size of the mesh, or is empty."""
    return max(min(-(-sources * vertices // _CHUNK), sources), 1)


def _add(tally: Tally, rows: FloatArray, sources: IntArray) -> None:
    """Count the distances, without those from a source to itself."""
    others = np.ones(rows.shape, np.bool_)
    others[np.arange(len(sources)), sources] = False
    tally.add(rows[others])


def _result(
    mesh: TriangleMesh, params: GeodesicParams, tally: Tally, sources: int
) -> GeodesicDistances:
    unit = mesh.mean_edge_length or 1.0
    # Bins narrower than an edge would show the steps of the mesh instead of its shape.
    histogram = tally.histogram(int(np.clip(tally.longest / unit, _FEWEST_BINS, _BINS)))
    return GeodesicDistances(
        params=params,
        histogram=Histogram(histogram.edges / unit, histogram.counts),
        sources=sources,
        pairs=tally.finite + tally.infinite,
        unreachable_pairs=tally.infinite,
        mean=tally.mean / unit,
        longest=tally.longest / unit,
        mean_edge_length=mesh.mean_edge_length,
    )
