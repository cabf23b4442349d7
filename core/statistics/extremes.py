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
# Meshes need a dozen restarts. Where eigenvalues are far closer to each other than to the shift,
# as on a long strip or around a vertex of thousands of neighbours, more restarts do not help: the
# shift has to come closer.
_RESTARTS, _SHIFTS, _CLOSER = 20, 12, 2e-2
# A component of so few vertices has all its eigenvalues found in a fraction of a second.
_DENSE = 300
# Eigenvalues are counted where two are further apart than this share of the way to the shift.
_DISTINCT = 1e-6
_NO_CONVERGENCE = (
    "The extreme eigenvalues do not converge on this mesh; a vertex with very many neighbours is "
    "the usual reason."
)


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
    with _convergence():
        yield from _outermost(matrix, count, _beyond(matrix))


def _beyond(matrix: "csr_array") -> float:
    """A shift just beyond the largest eigenvalue."""
    rough = scipy.sparse.linalg.eigsh(
        matrix, 1, which="LA", v0=_start(matrix), tol=_ROUGH, return_eigenvectors=False
    )
    return float(rough[0]) * (1 + 2 * _ROUGH) + _SHIFT


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
    with _convergence():
        kernel = _Kernel.of(components, weights)
        for values, share in _outermost(-matrix, count - zeros, _SHIFT, kernel):
            found = None if values is None else np.concatenate([np.zeros(zeros), -values[::-1]])
            yield found, share


def _outermost(
    matrix: "csr_array", count: int, shift: float, kernel: "_Kernel | None" = None
) -> Iterator[Found]:
    """Find the `count` largest eigenvalues, ascending, from a shift just beyond them.

    Where the method does not converge, or overlooks copies of an eigenvalue, the components are
    taken one by one, if there are several: eigenvalues that are equal because components are have
    then fewer copies. Else the shift moves to just beyond the first eigenvalue that is missing. It
    may pass some on its way; how many is known from the factors, and these are found from where the
    shift was before.
    """
    found: list[FloatArray] = []
    place = _Place.at(matrix, shift, kernel)
    while place.passed:  # the rough value was not the largest one's
        place = _Place.at(matrix, 2 * place.shift, kernel)
    for attempt in range(_SHIFTS):
        yield None, _FACTORISED
        try:
            values, known = place.nearest(count - place.passed), 0
            if place.has_all(values):
                found.append(values)
                break
        except scipy.sparse.linalg.ArpackNoConvergence as error:
            known = len(error.eigenvalues)
        except scipy.sparse.linalg.ArpackError:  # there are few different eigenvalues
            known = 0
        if attempt == 0 and len(parts := _components(matrix)) > 1:
            yield from _outermost_of(parts, matrix, count, kernel)
            return
        closer = place.closer(known)
        if closer.passed - place.passed > known:  # copies of one eigenvalue were overlooked
            closer = place.closer(0)
        if closer.passed > place.passed:
            values = place.nearest(min(closer.passed, count) - place.passed)
            if values[0] <= closer.shift or not place.has_all(values):
                raise ValueError(_NO_CONVERGENCE)
            found.append(values)
        if closer.passed >= count:
            break
        place = closer
    else:
        raise ValueError(_NO_CONVERGENCE)
    yield np.concatenate(found[::-1]), 1.0


def _components(matrix: "csr_array") -> list[NDArray[np.int64]]:
    """Rows of each component of a matrix that falls apart into blocks."""
    _, labels = scipy.sparse.csgraph.connected_components(matrix, directed=False)
    ends = np.cumsum(np.bincount(labels))[:-1]
    return np.split(np.argsort(labels, kind="stable"), ends)


def _outermost_of(
    parts: list[NDArray[np.int64]], matrix: "csr_array", count: int, kernel: "_Kernel | None"
) -> Iterator[Found]:
    """Find the `count` largest eigenvalues, ascending, from those of each component."""
    values = np.zeros(0)
    for done, rows in enumerate(parts):
        yield None, _FACTORISED + (1 - _FACTORISED) * done / len(parts)
        own = _outermost_alone(matrix[rows][:, rows], count, kernel and kernel.of_component(rows))
        values = np.sort(np.concatenate([values, own]))[-count:]
    yield values, 1.0


def _outermost_alone(block: "csr_array", count: int, kernel: "_Kernel | None") -> FloatArray:
    """Find the `count` largest eigenvalues of one component, or all it has."""
    if block.shape[0] <= _DENSE:
        values: FloatArray = np.linalg.eigvalsh(block.toarray())
        return values[:-1] if kernel else values  # the kernel's eigenvalue, zero, is the largest
    steps = _outermost(block, count, _SHIFT if kernel else _beyond(block), kernel)
    return next(values for values, _ in steps if values is not None)


@dataclass(frozen=True, eq=False)
class _Kernel:
    """The eigenvectors of the eigenvalue zero: `weights` on each component, nothing elsewhere."""

    components: NDArray[np.int32]
    weights: FloatArray
    norms: FloatArray

    @classmethod
    def of(cls, components: NDArray[np.int32], weights: FloatArray) -> "_Kernel":
        return cls(components, weights, np.bincount(components, weights**2).astype(np.float64))

    def of_component(self, rows: NDArray[np.int64]) -> "_Kernel":
        """Return what the kernel is on the vertices of one component."""
        return _Kernel.of(np.zeros(len(rows), np.int32), self.weights[rows])

    def project_out(self, x: FloatArray) -> FloatArray:
        """Return the part of a vector that is orthogonal to the kernel."""
        shares = np.bincount(self.components, self.weights * x.ravel()) / self.norms
        rest: FloatArray = x.ravel() - self.weights * shares[self.components]
        return rest


@dataclass(frozen=True, eq=False)
class _Place:
    """A shift σ and the factors of A − σ·I.

    Attributes
    ----------
    matrix : csr_array
        The symmetric matrix A.
    shift : float
        σ.
    kernel : _Kernel or None
        Eigenvectors that are left out.
    solve : callable
        Multiplies by the inverse of A − σ·I.
    passed : int
        How many eigenvalues are larger than σ.
    """

    matrix: "csr_array"
    shift: float
    kernel: _Kernel | None
    solve: Solve
    passed: int

    @classmethod
    def at(cls, matrix: "csr_array", shift: float, kernel: _Kernel | None) -> "_Place":
        """Factorise without exchanging rows.

        The signs of the pivots are then those of the eigenvalues of A − σ·I (Sylvester's law of
        inertia).
        """
        shifted = scipy.sparse.csc_array(matrix - shift * scipy.sparse.eye_array(matrix.shape[0]))
        options = {"SymmetricMode": True}
        factors = scipy.sparse.linalg.splu(shifted, diag_pivot_thresh=0.0, options=options)
        larger = int((factors.U.diagonal() > 0).sum())
        left_out = len(kernel.norms) if kernel and shift < 0 else 0
        return cls(matrix, shift, kernel, factors.solve, larger - left_out)

    def nearest(self, count: int, tolerance: float = 0) -> FloatArray:
        """Return the `count` largest eigenvalues below σ, ascending, by Lanczos on the inverse."""
        shape = self.matrix.shape
        values: FloatArray = scipy.sparse.linalg.eigsh(
            self.matrix,
            count,
            sigma=self.shift,
            which="SA",  # most negative of 1/(λ − σ)
            OPinv=scipy.sparse.linalg.LinearOperator(shape, self._inverse, dtype=np.float64),
            v0=self._beside_kernel(_start(self.matrix)),
            tol=tolerance,
            maxiter=_RESTARTS,
            return_eigenvectors=False,
        )
        return np.sort(values)

    def has_all(self, values: FloatArray) -> bool:
        """Whether there are no more eigenvalues than these, ascending, down to the smallest.

        A Lanczos method meets each eigenvalue once; that it finds copies is owed to rounding. They
        are counted above the lowest gap, where factors are safe: none of the equal values at the
        end is a wrong one.
        """
        gaps = np.flatnonzero(np.diff(values) > _DISTINCT * (self.shift - values[0]))
        if not len(gaps):
            return True
        below = int(gaps[0])
        gap = float(values[below] + values[below + 1]) / 2
        larger = _Place.at(self.matrix, gap, self.kernel).passed
        return larger - self.passed == len(values) - 1 - below

    def closer(self, known: int) -> "_Place":
        """Move to just beyond the first eigenvalue below σ after some that are known."""
        missing = float(self.nearest(known + 1, _CLOSER / 2)[0])
        return _Place.at(self.matrix, missing + _CLOSER * (self.shift - missing), self.kernel)

    def _inverse(self, x: FloatArray) -> FloatArray:
        return self._beside_kernel(self.solve(self._beside_kernel(x)))

    def _beside_kernel(self, x: FloatArray) -> FloatArray:
        return self.kernel.project_out(x) if self.kernel else x


@contextmanager
def _convergence() -> Iterator[None]:
    try:
        yield
    except RuntimeError as error:  # ARPACK's, and SuperLU's where the shift is an eigenvalue
        raise ValueError(_NO_CONVERGENCE) from error


def _start(matrix: "csr_array") -> FloatArray:
    """A fixed start, which makes the last digits the same at every call."""
    return np.random.default_rng(0).standard_normal(matrix.shape[0])
