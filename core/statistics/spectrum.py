"""Spectra of the Laplacian L = D − A and of the normalised Laplacian, thesis §3.2 and §3.4."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from core.apart import run_apart
from core.arrays import FloatArray
from core.mesh import TriangleMesh
from core.mesh.matrices import laplacian_matrix, normalized_laplacian_matrix
from core.parameters import Params, param
from core.statistics.distributions import AxisLabels
from core.statistics.errors import refusals
from core.statistics.extremes import Found, all_steps, largest_steps, smallest_steps
from core.statistics.kernel_polynomial import SpectralCounts, moment_steps
from core.statistics.progress import Progress, part_of

if TYPE_CHECKING:
    from scipy.sparse import csr_array

MatrixName = Literal["laplacian", "normalized_laplacian"]

_SYMBOLS = {"laplacian": "L", "normalized_laplacian": "ℒ"}
_POINTS = 1000
_PROBE_ENTRIES = 400_000
_ROUNDING = 1e-9
_FADE = 0.01
# A mesh of so few vertices takes less time than starting a process does.
_SMALL = 1200


class SpectrumParams(Params):
    """Of which matrix, and where the exact method gives way to the one of linear cost."""

    matrix: Literal["laplacian", "normalized_laplacian"] = param(
        "laplacian", help="The Laplacian L = D − A, or the normalised one."
    )
    dense_limit: int = param(
        4000,
        low=0,
        high=30_000,
        step=500,
        help="Most vertices for all eigenvalues one by one; time grows with the third power.",
    )
    moments: int = param(
        600,
        low=16,
        high=20_000,
        step=100,
        help="Chebyshev moments of the approximation; more is sharper and slower.",
    )
    extremes: int = param(
        12, low=1, high=200, step=1, help="Eigenvalues at each end that are computed exactly."
    )
    seed: int = param(0, low=0, high=2**31 - 1, step=1, help="Seed of the random vectors.")


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Eigenvalues in descending order against their normalised rank.

    Attributes
    ----------
    matrix : {"laplacian", "normalized_laplacian"}
        Whose eigenvalues.
    count : int
        Number m of eigenvalues.
    ranks : (s,) float64 ndarray
        Normalised ranks (i − ½)/m, ascending; all of them where `exact`.
    eigenvalues : (s,) float64 ndarray
        The eigenvalue at each of these ranks, descending.
    low, high : (s,) float64 ndarray
        Error bar of each; equal to `eigenvalues` where they are exact.
    exact : bool
        Whether all eigenvalues were computed.
    smallest, largest : float64 ndarray
        The smallest and the largest eigenvalues, exact, ascending.
    zero_count : int
        Number of eigenvalues that are zero, which is the number of components.
    """

    matrix: MatrixName
    count: int
    ranks: FloatArray
    eigenvalues: FloatArray
    low: FloatArray
    high: FloatArray
    exact: bool
    smallest: FloatArray
    largest: FloatArray
    zero_count: int

    @property
    def labels(self) -> AxisLabels:
        """Labels of its plot."""
        return AxisLabels("normalised rank", f"eigenvalue of {_SYMBOLS[self.matrix]}")

    @property
    def algebraic_connectivity(self) -> float:
        """Second smallest eigenvalue λ₂, exact; 0 where the mesh is not connected."""
        return float(self.smallest[1]) if len(self.smallest) > 1 else 0.0

    @property
    def error(self) -> float:
        """Widest half of the error bar, 0 where all eigenvalues are exact."""
        return float((self.high - self.low).max(initial=0) / 2)


def spectrum_steps(
    mesh: TriangleMesh, params: SpectrumParams | None = None
) -> Iterator[Progress[Spectrum]]:
    """Compute the spectrum of a Laplacian.

    Up to ``dense_limit`` vertices every eigenvalue is computed. Above that the distribution comes
    from Chebyshev moments of random vectors, at a cost linear in the number of edges, and the
    ends of the spectrum are replaced by eigenvalues from a sparse Lanczos method.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh with a vertex.
    params : SpectrumParams, optional
        Matrix and accuracy.

    Yields
    ------
    Progress of Spectrum
        Without a value until the end.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §3.2. Weiße et al., *The kernel
    polynomial method*, Rev. Mod. Phys. 78, 2006.
    """
    settings = params or SpectrumParams()
    yield Progress(None, 0.0)
    if len(mesh.vertices) <= max(settings.dense_limit, 2 * settings.extremes + 2):
        everything = _eigenvalues(all_steps, _matrix(mesh, settings.matrix))
        ascending = yield from part_of(everything, 0.0, 1.0)
        yield Progress(_exact(mesh, settings, ascending), 1.0)
    else:
        yield from _approximate(mesh, settings)


def _eigenvalues(
    steps: Callable[..., Iterator[Found]], matrix: "csr_array", *arguments: object
) -> Iterator[Progress[FloatArray]]:
    """Compute eigenvalues, those of a large matrix in a process of its own."""
    apart = matrix.shape[0] > _SMALL
    value, share = None, 0.0
    with refusals():
        for found in run_apart(steps, matrix, *arguments) if apart else steps(matrix, *arguments):
            value, share = found or (value, share)
            yield Progress(value, share)


def _exact(mesh: TriangleMesh, params: SpectrumParams, ascending: FloatArray) -> Spectrum:
    ascending[: mesh.topology.component_count] = 0.0
    eigenvalues, m = ascending[::-1], len(ascending)
    ranks = (np.arange(m) + 0.5) / max(m, 1)
    return Spectrum(
        matrix=params.matrix,
        count=m,
        ranks=ranks,
        eigenvalues=eigenvalues,
        low=eigenvalues,
        high=eigenvalues,
        exact=True,
        smallest=ascending[: params.extremes],
        largest=ascending[-params.extremes :],
        zero_count=int((ascending <= _ROUNDING * max(ascending[-1], 1)).sum()),
    )


def _approximate(mesh: TriangleMesh, params: SpectrumParams) -> Iterator[Progress[Spectrum]]:
    matrix, m = _matrix(mesh, params.matrix), len(mesh.vertices)
    normalized = params.matrix == "normalized_laplacian"
    ends = params.extremes
    largest = yield from part_of(_eigenvalues(largest_steps, matrix, ends), 0.0, 0.35)
    kernel = np.sqrt(np.maximum(mesh.degrees, 1.0)) if normalized else np.ones(m)
    components = mesh.topology.vertex_components
    tail = _eigenvalues(smallest_steps, matrix, components, kernel, ends)
    smallest = yield from part_of(tail, 0.35, 0.65)
    top = 2.0 if normalized else float(largest[-1])
    probes = int(np.clip(_PROBE_ENTRIES // m, 8, 64))
    steps = moment_steps(matrix, top, params.moments, probes, params.seed)
    moments = yield from part_of(steps, 0.65, 0.98)
    counts = SpectralCounts.of(moments, top)
    yield Progress(_joined(counts, smallest, largest, mesh, params), 1.0)


def _joined(
    counts: SpectralCounts,
    smallest: FloatArray,
    largest: FloatArray,
    mesh: TriangleMesh,
    params: SpectrumParams,
) -> Spectrum:
    """Put the exact ends in place of the approximation."""
    m = len(mesh.vertices)
    head, tail = largest[::-1], smallest[::-1]
    inner = np.linspace(len(head), m - len(tail), _POINTS + 1)[:-1] / m + 0.5 / m
    _, low, high = counts.at_ranks(inner)
    middle, _, _ = counts.at_ranks(_fitted(counts, inner, head[-1], tail[0]))
    curves = [
        np.concatenate([head, np.clip(curve, tail[0], head[-1]), tail])
        for curve in (middle, np.minimum(low, middle), np.maximum(high, middle))
    ]
    first = (np.arange(len(head)) + 0.5) / m
    last = 1 - (np.arange(len(tail))[::-1] + 0.5) / m
    return Spectrum(
        matrix=params.matrix,
        count=m,
        ranks=np.concatenate([first, inner, last]),
        eigenvalues=curves[0],
        low=curves[1],
        high=curves[2],
        exact=False,
        smallest=smallest,
        largest=largest,
        zero_count=mesh.topology.component_count,
    )


def _fitted(counts: SpectralCounts, ranks: FloatArray, high: float, low: float) -> FloatArray:
    """Shift ranks near both ends so that the approximation meets the exact eigenvalues there."""
    ends = np.interp([-high, -low], -counts.eigenvalues, counts.above)
    shift = np.zeros_like(ranks)
    for known, found in zip((ranks[0], ranks[-1]), ends, strict=True):
        shift += (found - known) * np.exp(-np.abs(ranks - known) / _FADE)
    fitted: FloatArray = np.maximum.accumulate(ranks + shift)
    return fitted


def _matrix(mesh: TriangleMesh, name: MatrixName) -> "csr_array":
    build = laplacian_matrix if name == "laplacian" else normalized_laplacian_matrix
    return build(mesh)
