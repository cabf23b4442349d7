"""How long work will still take, guessed from how fast it has gone lately."""

import math
from collections import deque

_QUIET = 1.0
_WINDOW = 4.0
_MEMORY = 2.0


class Remaining:
    """Estimates the time that is left from the share of the work that is done.

    The speed is the one over the later half of the time so far, so that work that has got company,
    or has lost it, is soon judged anew. Between two changes of the share the time counts down.
    """

    def __init__(self) -> None:
        self._marks: deque[tuple[float, float]] = deque()
        self._begun = 0.0
        self._end: float | None = None

    def update(self, share: float | None, now: float) -> float | None:
        """Take in what is done at a time in seconds; return the seconds left, None if unknown.

        Nothing is said in the first second, nor again where the share has fallen because there is
        more to do.
        """
        if share is None or not self._marks or share < self._marks[-1][1]:
            self._begin(share, now)
        elif share > self._marks[-1][1]:
            self._add(share, now)
        if self._end is None or now - self._begun < _QUIET:
            return None
        return max(self._end - now, 0.0)

    def _begin(self, share: float | None, now: float) -> None:
        self._marks.clear()
        self._begun, self._end = now, None
        if share is not None:
            self._marks.append((now, share))

    def _add(self, share: float, now: float) -> None:
        before = self._marks[-1][0]
        self._marks.append((now, share))
        horizon = now - max(_WINDOW, (now - self._begun) / 2)
        while len(self._marks) > 2 and self._marks[1][0] <= horizon:
            self._marks.popleft()
        since, had = self._marks[0]
        end = now + (1 - share) * (now - since) / (share - had)
        weight = 1 - math.exp((before - now) / _MEMORY)
        self._end = end if self._end is None else self._end + weight * (end - self._end)


def in_words(seconds: float) -> str:
    """Say how much time is left, no finer than it is known."""
    if seconds < 1.5:
        return "a moment left"
    if seconds < 20:
        return f"about {seconds:.0f} s left"
    if seconds < 57.5:
        return f"about {5 * round(seconds / 5)} s left"
    minutes = max(round(seconds / 60), 1)
    return f"about {minutes} min left" if minutes < 60 else f"about {round(minutes / 60)} h left"
