"""Eigenvalues of a Laplacian: all of them, or the smallest and largest by Lanczos methods.

This file imports nothing of the project: :mod:`core.apart` loads it in a process of its own,
because none of these computations can be interrupted.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy.sparse import csr_array

FloatArray = NDArray[np.float64]
Found = tuple[FloatArray | None, float]
"""The eigenvalues, None until the end, and the share of the work that is done."""
Solve = Callable[[FloatArray], FloatArray]
"""Solves a linear system for a right-hand side."""

_SHIFT = 1e-4
_ROUGH = 1e-3
_FACTORISED = 0.4
# Meshes need a few dozen. Where one vertex has thousands of neighbours its eigenvalue stands so far
# from all others that they cannot be told apart beside it; without an end that takes for ever.
_MOST_RESTARTS = 300


def all_steps(matrix: "csr_array") -> Iterator[Found]:
    """Find all eigenvalues of a symmetric matrix, ascending; time grows with the third power."""
    yield np.linalg.eigvalsh(matrix.toarray()), 1.0


def largest_steps(matrix: "csr_array", count: int) -> Iterator[Found]:
    """Find the `count` largest eigenvalues of a positive semidefinite matrix, ascending.

    On a regular mesh they lie so close together that Lanczos on the matrix itself takes minutes:
    it runs on the inverse of the matrix shifted just beyond them.

    Raises
    ------
    ValueError
        If the Lanczos method does not converge.
    """
    start = _start(matrix)
    with _convergence():
        rough = scipy.sparse.linalg.eigsh(
            matrix, 1, which="LA", v0=start, tol=_ROUGH, return_eigenvectors=False
        )
        beyond = float(rough[0]) * (1 + 2 * _ROUGH) + _SHIFT
        solve = _solver(matrix, beyond)
        yield None, _FACTORISED
        yield _nearest(matrix, count, beyond, solve, start), 1.0


def smallest_steps(
    matrix: "csr_array", components: NDArray[np.int32], weights: FloatArray, count: int
) -> Iterator[Found]:
    """Find the `count` smallest eigenvalues of a mesh's Laplacian, ascending.

    The vectors that are constant on a component (times √d for the normalised Laplacian) span the
    eigenvalue zero exactly. They are projected out, so that the method finds the next eigenvalues
    however many components there are.

    Parameters
    ----------
    matrix : (m, m) csr_array
        Laplacian or normalised Laplacian.
    components : (m,) int32 ndarray
        Component of each vertex.
    weights : (m,) float64 ndarray
        The eigenvector of the eigenvalue zero, component by component.
    count : int
        Number of eigenvalues, less than m/2.

    Raises
    ------
    ValueError
        If the Lanczos method does not converge.
    """
    zeros = min(int(components.max()) + 1, count)
    if zeros == count:
        yield np.zeros(count), 1.0
        return
    kernel = _Kernel.of(components, weights)
    solve = _solver(matrix, -_SHIFT)
    yield None, _FACTORISED

    def solve_beside(x: FloatArray) -> FloatArray:
        return kernel.project_out(solve(kernel.project_out(x)))

    with _convergence():
        start = kernel.project_out(_start(matrix))
        positive = _nearest(matrix, count - zeros, -_SHIFT, solve_beside, start)
    yield np.concatenate([np.zeros(zeros), positive]), 1.0


@dataclass(frozen=True, eq=False)
class _Kernel:
    """The eigenvectors of the eigenvalue zero: `weights` on each component, nothing elsewhere."""

    components: NDArray[np.int32]
    weights: FloatArray
    norms: FloatArray

    @classmethod
    def of(cls, components: NDArray[np.int32], weights: FloatArray) -> "_Kernel":
        return cls(components, weights, np.bincount(components, weights**2).astype(np.float64))

    def project_out(self, x: FloatArray) -> FloatArray:
        """Return the part of a vector that is orthogonal to the kernel."""
        shares = np.bincount(self.components, self.weights * x.ravel()) / self.norms
        rest: FloatArray = x.ravel() - self.weights * shares[self.components]
        return rest


@contextmanager
def _convergence() -> Iterator[None]:
    try:
        yield
    except scipy.sparse.linalg.ArpackNoConvergence as error:
        raise ValueError(
            "The extreme eigenvalues do not converge on this mesh; a vertex with very many "
            "neighbours is the usual reason."
        ) from error


def _start(matrix: "csr_array") -> FloatArray:
    """A fixed start, which makes the last digits the same at every call."""
    return np.random.default_rng(0).standard_normal(matrix.shape[0])


def _solver(matrix: "csr_array", shift: float) -> Solve:
    """Factorise A − shift·I, which is definite, so that no rows need to be exchanged."""
    shifted = scipy.sparse.csc_array(matrix - shift * scipy.sparse.eye_array(matrix.shape[0]))
    options = {"SymmetricMode": True}
    solve: Solve = scipy.sparse.linalg.splu(shifted, diag_pivot_thresh=0.0, options=options).solve
    return solve


def _nearest(
    matrix: "csr_array", count: int, shift: float, solve: Solve, start: FloatArray
) -> FloatArray:
    """Eigenvalues nearest to a shift, ascending, by Lanczos on the inverse."""
    inverse = scipy.sparse.linalg.LinearOperator(matrix.shape, solve, dtype=np.float64)
    values: FloatArray = scipy.sparse.linalg.eigsh(
        matrix,
        count,
        sigma=shift,
        OPinv=inverse,
        v0=start,
        maxiter=_MOST_RESTARTS,
        return_eigenvectors=False,
    )
    return np.sort(values)
