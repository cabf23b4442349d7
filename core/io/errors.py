"""What goes wrong with a file, each in one sentence that a person can act on."""


class LoadError(ValueError):
    """Raised when a file cannot be read as a mesh; names the file and says why."""


def quoted(text: str, most: int = 40) -> str:
    """Return what a file says, fit for a sentence: in quotation marks, printable and not long."""
    shown = repr(text[:most])
    return shown if len(shown) <= most + 2 else f"{shown[:most]}…'"


def printable(text: str, instead: str = "\ufffd") -> str:
    """Return text with a mark in place of line ends, control characters and broken letters."""
    return "".join(letter if letter.isprintable() else instead for letter in text)


def one_line(text: str, most: int = 200) -> str:
    """Return text fit for a sentence: in one line, without control characters and not long."""
    line = " ".join(printable(text[: 2 * most], " ").split())
    return line if len(line) <= most else f"{line[:most]}…"


class SaveError(ValueError):
    """Raised when a mesh cannot be written; names the file and says why."""
