"""What several checks need of the same mesh, computed once."""

import weakref
from collections.abc import Callable
from functools import wraps
from typing import TypeVar

from core.mesh import TriangleMesh

T = TypeVar("T")


def remembered(compute: Callable[[TriangleMesh], T]) -> Callable[[TriangleMesh], T]:
    """Keep the result for the last mesh, as long as that mesh is there."""
    results: weakref.WeakKeyDictionary[TriangleMesh, T] = weakref.WeakKeyDictionary()

    @wraps(compute)
    def once(mesh: TriangleMesh) -> T:
        result = results.get(mesh)
        if result is None:
            result = compute(mesh)
            results.clear()
            results[mesh] = result
        return result

    return once
