"""Finding a name from a few of its letters."""

_WORD, _RUN, _START = 8, 5, 4
_NO_LETTER = 1


def score(wanted: str, name: str) -> int | None:
    """How well a name fits what is typed; None if it does not.

    All typed letters must occur in order. Letters that begin a word or follow each other count
    more, so that "sd" finds "Save Denoised" before "Compare Sides". The best placing counts.

    Examples
    --------
    >>> score("sd", "Save Denoised") > score("sd", "Used")
    True
    >>> score("xyz", "Save") is None
    True
    """
    letters = wanted.lower().replace(" ", "")
    text = name.lower()
    best: dict[int, int] = {-1: 0}
    for letter in letters:
        best = _placed(letter, text, best)
        if not best:
            return None
    return max(best.values()) - _NO_LETTER * len(text) // 8


def ranked(wanted: str, names: list[str]) -> list[int]:
    """Return the places of the names that fit, the best first; without letters all in order."""
    if not wanted.strip():
        return list(range(len(names)))
    scores = {place: score(wanted, name) for place, name in enumerate(names)}
    fitting = [place for place, value in scores.items() if value is not None]
    return sorted(fitting, key=lambda place: -scores[place])


def _placed(letter: str, text: str, best: dict[int, int]) -> dict[int, int]:
    """Best score for each place of a letter, given those of the letter before it."""
    result: dict[int, int] = {}
    reach = None
    for place, found in enumerate(text):
        if place - 1 in best:
            before = best[place - 1]
            reach = before if reach is None else max(reach, before)
        if found == letter and reach is not None:
            follows = best.get(place - 1, reach - _RUN) + _RUN if place else reach
            result[place] = max(reach, follows) + _bonus(text, place)
    return result


def _bonus(text: str, place: int) -> int:
    if place == 0:
        return _WORD + _START
    return 0 if text[place - 1].isalnum() else _WORD
