"""Finding a name from a few of its letters, or from a word of its description."""

import re

_WORD, _RUN, _START = 8, 10, 4
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


def ranked(
    wanted: str,
    names: list[str],
    others: list[str] | None = None,
    tips: list[str] | None = None,
) -> list[int]:
    """Return the places of the names that fit, the best first; without letters all in order.

    `others` has a second name of each, of which the better one counts. `tips` has a sentence of
    each, in which words are looked for as they are typed: such a find comes after names with these
    words and before names with the letters here and there.
    """
    if not wanted.strip():
        return list(range(len(names)))
    tips = tips or [""] * len(names)
    scores = {}
    for place, (name, other, tip) in enumerate(zip(names, others or names, tips, strict=True)):
        value = _better(wanted, (name, other))
        literal = (begins_a_word(wanted, name), len(wanted) > 2 and begins_a_word(wanted, tip))
        if value is not None or literal[1]:
            scores[place] = (*literal, value or 0)
    return sorted(scores, key=lambda place: scores[place], reverse=True)


def begins_a_word(wanted: str, text: str) -> bool:
    """Whether what is typed stands in a text from the beginning of a word on."""
    return re.search(rf"\b{re.escape(wanted.strip())}", text, re.IGNORECASE) is not None


def _better(wanted: str, names: tuple[str, str]) -> int | None:
    known = [value for value in (score(wanted, name) for name in names) if value is not None]
    return max(known, default=None)


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
