"""What the statistics cannot be computed for."""

from collections.abc import Iterator
from contextlib import contextmanager


class StatisticsError(ValueError):
    """Raised when a statistic does not exist for a mesh; one sentence says why."""


@contextmanager
def refusals() -> Iterator[None]:
    """Make the refusals of files that import nothing of the project, ValueErrors, ours."""
    try:
        yield
    except ValueError as error:
        raise StatisticsError(str(error)) from error
