"""Long work in steps: a generator that yields wherever it may be left, and returns its result."""

from collections.abc import Callable, Generator
from functools import wraps
from typing import ParamSpec, TypeAlias, TypeVar

P = ParamSpec("P")
T = TypeVar("T")
Stepwise: TypeAlias = Generator[None, None, T]
"""Work that whoever iterates may leave after any step; closing it then cleans up."""

__all__ = ["Stepwise", "at_once", "carried_out"]


def carried_out(steps: Stepwise[T]) -> T:
    """Take all steps and return the result."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            result: T = end.value
            return result


def at_once(work: Callable[P, T]) -> Callable[P, Stepwise[T]]:
    """Make stepwise work of what takes a moment."""

    @wraps(work)
    def steps(*args: P.args, **kwargs: P.kwargs) -> Stepwise[T]:
        yield
        return work(*args, **kwargs)

    return steps
