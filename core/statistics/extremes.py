"""The smallest and largest eigenvalues of a Laplacian, exact, by sparse Lanczos methods."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, csr_array, eye_array
from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh, splu

from core.arrays import FloatArray, IntArray
from core.mesh import TriangleMesh
from core.statistics.errors import StatisticsError
from core.statistics.progress import Progress

Solve = Callable[[FloatArray], FloatArray]
"""Solves a linear system for a right-hand side."""

_SHIFT = 1e-4
_ROUGH = 1e-3
_FACTORISED = 0.4
# Meshes need a few dozen. Where one vertex has thousands of neighbours its eigenvalue stands so far
# from all others that they cannot be told apart beside it; without an end that takes for ever.
_MOST_RESTARTS = 300


def largest_steps(matrix: csr_array, count: int) -> Iterator[Progress[FloatArray]]:
    """Find the `count` largest eigenvalues of a positive semidefinite matrix, ascending.

    On a regular mesh they lie so close together that Lanczos on the matrix itself takes minutes:
    it runs on the inverse of the matrix shifted just beyond them.

    Yields
    ------
    Progress of ndarray
        The eigenvalues at the end.

    Raises
    ------
    StatisticsError
        If the Lanczos method does not converge.
    """
    start = _start(matrix)
    with _convergence():
        rough = eigsh(matrix, 1, which="LA", v0=start, tol=_ROUGH, return_eigenvectors=False)
        beyond = float(rough[0]) * (1 + 2 * _ROUGH) + _SHIFT
        solve = _solver(matrix, beyond)
        yield Progress(None, _FACTORISED)
        yield Progress(_nearest(matrix, count, beyond, solve, start), 1.0)


def smallest_steps(
    mesh: TriangleMesh, matrix: csr_array, count: int, *, normalized: bool
) -> Iterator[Progress[FloatArray]]:
    """Find the `count` smallest eigenvalues of a mesh's Laplacian, ascending.

    The vectors that are constant on a component (times √d for the normalised Laplacian) span the
    eigenvalue zero exactly. They are projected out, so that the method finds the next eigenvalues
    however many components there are.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh; its components are the zero eigenvalues.
    matrix : (m, m) csr_array
        Its Laplacian, or its normalised Laplacian where `normalized`.
    count : int
        Number of eigenvalues, less than m/2.

    Yields
    ------
    Progress of ndarray
        The eigenvalues at the end.

    Raises
    ------
    StatisticsError
        If the Lanczos method does not converge.
    """
    zeros = min(mesh.topology.component_count, count)
    if zeros == count:
        yield Progress(np.zeros(count), 1.0)
        return
    kernel = _Kernel.of(mesh, normalized=normalized)
    solve = _solver(matrix, -_SHIFT)
    yield Progress(None, _FACTORISED)

    def solve_beside(x: FloatArray) -> FloatArray:
        return kernel.project_out(solve(kernel.project_out(x)))

    with _convergence():
        start = kernel.project_out(_start(matrix))
        positive = _nearest(matrix, count - zeros, -_SHIFT, solve_beside, start)
    yield Progress(np.concatenate([np.zeros(zeros), positive]), 1.0)


@dataclass(frozen=True, eq=False)
class _Kernel:
    """The eigenvectors of the eigenvalue zero: `weights` on each component, nothing elsewhere."""

    components: IntArray
    weights: FloatArray
    norms: FloatArray

    @classmethod
    def of(cls, mesh: TriangleMesh, *, normalized: bool) -> "_Kernel":
        components = mesh.topology.vertex_components
        degrees = mesh.degrees if normalized else np.ones(len(components))
        weights = np.sqrt(np.maximum(degrees, 1.0))
        norms = np.bincount(components, weights**2).astype(np.float64)
        return cls(components, weights, norms)

    def project_out(self, x: FloatArray) -> FloatArray:
        """Return the part of a vector that is orthogonal to the kernel."""
        shares = np.bincount(self.components, self.weights * x.ravel()) / self.norms
        rest: FloatArray = x.ravel() - self.weights * shares[self.components]
        return rest


@contextmanager
def _convergence() -> Iterator[None]:
    try:
        yield
    except ArpackNoConvergence as error:
        raise StatisticsError(
            "The extreme eigenvalues do not converge on this mesh; a vertex with very many "
            "neighbours is the usual reason."
        ) from error


def _start(matrix: csr_array) -> FloatArray:
    """A fixed start, which makes the last digits the same at every call."""
    return np.random.default_rng(0).standard_normal(matrix.shape[0])


def _solver(matrix: csr_array, shift: float) -> Solve:
    """Factorise A − shift·I, which is definite, so that no rows need to be exchanged."""
    shifted = csc_array(matrix - shift * eye_array(matrix.shape[0]))
    options = {"SymmetricMode": True}
    solve: Solve = splu(shifted, diag_pivot_thresh=0.0, options=options).solve
    return solve


def _nearest(
    matrix: csr_array, count: int, shift: float, solve: Solve, start: FloatArray
) -> FloatArray:
    """Eigenvalues nearest to a shift, ascending, by Lanczos on the inverse."""
    inverse = LinearOperator(matrix.shape, solve, dtype=np.float64)
    values: FloatArray = eigsh(
        matrix,
        count,
        sigma=shift,
        OPinv=inverse,
        v0=start,
        maxiter=_MOST_RESTARTS,
        return_eigenvectors=False,
    )
    return np.sort(values)
