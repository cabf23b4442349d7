"""The kernel polynomial method: how eigenvalues are distributed, from random vectors."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy

from core.arrays import FloatArray
from core.statistics.progress import Progress

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_GRID = 4000
_SIGMAS = 2.0
_MARGIN = 1.01


def moment_steps(
    matrix: "csr_array", top: float, count: int, probes: int, seed: int
) -> Iterator[Progress[FloatArray]]:
    """Chebyshev moments μ_k = zᵀ T_k(H) z / m of random sign vectors z.

    H is the matrix with its spectrum, 0 to `top`, mapped into [−1, 1]. Each product with H gives
    two moments, because T_{2k} = 2 T_k² − 1.

    Parameters
    ----------
    matrix : (m, m) csr_array
        Symmetric.
    top : float
        Largest eigenvalue.
    count : int
        Number of moments; rounded up to an even one.
    probes : int
        Number of random vectors.
    seed : int
        Seed of the random vectors.

    Yields
    ------
    Progress of ndarray
        Without a value until the end; then the moments, (probes, count) float64.
    """
    m = matrix.shape[0]
    half = top * _MARGIN / 2
    H = scipy.sparse.csr_array(matrix / half - scipy.sparse.eye_array(m))
    before = np.random.default_rng(seed).choice([-1.0, 1.0], (m, probes))
    now = H @ before
    first, second = before, now
    first_moment = _dots(first, second)
    moments = [np.ones(probes), first_moment]
    for k in range(1, -(-count // 2)):
        before, now = now, 2 * (H @ now) - before
        moments.append(2 * _dots(before, before) - 1)
        moments.append(2 * _dots(now, before) - first_moment)
        if k % 8 == 0:
            yield Progress(None, 2 * k / count)
    yield Progress(np.stack(moments, axis=1), 1.0)


def _dots(one: FloatArray, other: FloatArray) -> FloatArray:
    dots: FloatArray = np.einsum("ip,ip->p", one, other) / len(one)
    return dots


@dataclass(frozen=True, eq=False)
class SpectralCounts:
    """Share of the eigenvalues above λ, with its error.

    Attributes
    ----------
    eigenvalues : (g,) float64 ndarray
        Values λ, descending.
    above : (g,) float64 ndarray
        Share of the eigenvalues above each.
    error : (g,) float64 ndarray
        Standard error of that share over the random vectors.
    blur : (g,) float64 ndarray
        Width (standard deviation) of the kernel at each λ: nothing finer can be told apart.
    """

    eigenvalues: FloatArray
    above: FloatArray
    error: FloatArray
    blur: FloatArray

    @classmethod
    def of(cls, moments: FloatArray, top: float) -> "SpectralCounts":
        """Sum the moments to counts, damped by Jackson's kernel.

        N(x) = (1/π) [ (π − θ) μ₀ − 2 Σ g_k μ_k sin(kθ)/k ] is the share below x = cos θ.
        """
        probes, count = moments.shape
        k = np.arange(1, count)
        theta = np.linspace(0, np.pi, _GRID)
        sines = np.sin(np.outer(theta, k)) / k
        below = (np.pi - theta - 2 * (moments[:, 1:] * _jackson(count)[1:]) @ sines.T) / np.pi
        above = np.clip(1 - below, 0, 1)
        half = top * _MARGIN / 2
        return cls(
            eigenvalues=half * (np.cos(theta) + 1),
            above=np.maximum.accumulate(above.mean(axis=0)),
            error=above.std(axis=0, ddof=1) / np.sqrt(probes),
            blur=half * _jackson_width(np.cos(theta), count),
        )

    def at_ranks(self, ranks: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Eigenvalues at normalised ranks, and the lower and upper end of their error bars.

        The bar is two standard errors of the random vectors and one width of the kernel wide to
        either side.
        """
        slack = _SIGMAS * self.error
        middle = self._inverse(ranks, self.above)
        blur = np.interp(-middle, -self.eigenvalues, self.blur)
        low = self._inverse(ranks, np.maximum.accumulate(self.above - slack)) - blur
        high = self._inverse(ranks, np.maximum.accumulate(self.above + slack)) + blur
        return middle, low, high

    def _inverse(self, ranks: FloatArray, above: FloatArray) -> FloatArray:
        return np.interp(ranks, above, self.eigenvalues)


def _jackson(count: int) -> FloatArray:
    """Damping factors g_k of Jackson's kernel."""
    k, step = np.arange(count), np.pi / (count + 1)
    damping: FloatArray = ((count - k + 1) * np.cos(k * step) + np.sin(k * step) / np.tan(step)) / (
        count + 1
    )
    return damping


def _jackson_width(x: FloatArray, count: int) -> FloatArray:
    """Standard deviation of Jackson's kernel at x."""
    variance = (count - x**2 * (count - 1)) / (2 * (count + 1))
    width: FloatArray = np.sqrt(variance * (1 - np.cos(2 * np.pi / (count + 1))))
    return width
