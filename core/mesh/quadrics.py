"""Collapsing edges by quadric errors.

This file imports nothing of the project: :mod:`core.apart` loads it in a process of its own,
because fast_simplification keeps the interpreter lock and cannot be interrupted.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Collapsed = tuple[NDArray[np.float64], NDArray[np.signedinteger]]
"""Vertices (m, 3), and faces (n, 3) that may name a vertex twice."""


def collapse_steps(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], target: int
) -> Iterator[Collapsed]:
    """Collapse edges, the least noticeable first, until about `target` faces are left."""
    from fast_simplification import simplify  # noqa: PLC0415 - only where something is collapsed

    # The compiled code writes to neither array, but takes only writeable ones.
    yield simplify(vertices.copy(), faces.copy(), target_count=target)
