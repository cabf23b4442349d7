"""The last few values by key, as far as memory allows."""

import math
from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

from core.stepwise import Stepwise

T = TypeVar("T")


class Kept(Generic[T]):
    """Values by key, the least recently used dropped first; the newest always stays.

    Parameters
    ----------
    limit : int
        Number of values.
    weigh : callable
        Returns the memory of a value in bytes.
    budget : callable
        Returns the memory that all values may take in bytes.
    """

    def __init__(
        self,
        limit: int,
        weigh: Callable[[T], int] = lambda _: 0,
        budget: Callable[[], float] = lambda: math.inf,
    ) -> None:
        self._limit, self._weigh, self._budget = limit, weigh, budget
        self._values: OrderedDict[Hashable, T] = OrderedDict()

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """Return the value under a key, made if it is not there."""
        if key not in self._values:
            self._values[key] = make()
        self._values.move_to_end(key)
        while len(self._values) > 1 and self._is_full:
            self._values.popitem(last=False)
        return self._values[key]

    def get_stepwise(self, key: Hashable, make: Callable[[], Stepwise[T]]) -> Stepwise[T]:
        """Return the value under a key, made step by step if it is not there."""
        value = self._values[key] if key in self._values else (yield from make())
        return self.get(key, lambda: value)

    @property
    def _is_full(self) -> bool:
        taken = sum(self._weigh(value) for value in self._values.values())
        return len(self._values) > self._limit or taken > self._budget()
