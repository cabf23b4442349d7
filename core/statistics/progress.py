"""Progress of long work: what is there so far, and how much of it that is."""

from collections.abc import Generator, Iterator
from typing import Any, Generic, NamedTuple, TypeVar

T = TypeVar("T")


class Progress(NamedTuple, Generic[T]):
    """One step of long work; whoever iterates may stop after any of them.

    Attributes
    ----------
    value : T or None
        The result so far, None while there is nothing to show.
    share : float
        Share of the work that is done, 1 at the end.
    """

    value: T | None
    share: float


def finished(steps: Iterator[Progress[T]]) -> T:
    """Carry long work out and return its result."""
    value: T | None = None
    for step in steps:
        value = step.value
    if value is None:
        raise ValueError("The work ended without a result.")
    return value


def part_of(
    steps: Iterator[Progress[T]], begin: float, end: float
) -> Generator[Progress[Any], None, T]:
    """Carry out a part of longer work that goes from one share to another; return its result."""
    value: T | None = None
    for step in steps:
        value = step.value
        yield Progress(None, begin + (end - begin) * step.share)
    if value is None:
        raise ValueError("The work ended without a result.")
    return value
