"""Text parted into lines that fit a width."""

from app.scene.caption import text_width

_INCH = 2.54
_POINTS = 72


def width_of(text: str, size: float) -> float:
    """Width of a line in centimetres, with letters of a size in points."""
    return text_width(text, size) / _POINTS * _INCH


def wrapped(text: str, width: float, size: float) -> list[str]:
    """Part a text into lines, between words where that is possible.

    Parameters
    ----------
    text : str
        The text; line breaks of its own stay.
    width : float
        Room in centimetres.
    size : float
        Size of the letters in points.
    """
    room = width / _INCH * _POINTS
    return [line for part in text.split("\n") for line in _lines(part, room, size)]


def _lines(text: str, room: float, size: float) -> list[str]:
    lines = [""]
    # A no-break space keeps words together.
    for word in filter(None, text.split(" ")):
        joined = f"{lines[-1]} {word}".strip()
        if text_width(joined, size) <= room:
            lines[-1] = joined
        else:
            pieces = _pieces(word, room, size)
            lines = [*lines, *pieces] if lines[-1] else pieces
    return lines


def _pieces(word: str, room: float, size: float) -> list[str]:
    """Part a word that is wider than the room itself."""
    pieces = [word[:1]]
    for letter in word[1:]:
        if text_width(pieces[-1] + letter, size) <= room:
            pieces[-1] += letter
        else:
            pieces.append(letter)
    return pieces
