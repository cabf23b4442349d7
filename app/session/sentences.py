"""What a person is told when a piece of work fails for a reason outside the program."""

from pathlib import Path

_NO_MEMORY = (
    "There is not enough memory for that. What was open is as it was; a smaller model, or fewer "
    "iterations, may fit."
)


def sentence_of(error: Exception) -> str | None:
    """Say what went wrong, or return None where it is a fault of the program."""
    if isinstance(error, MemoryError):
        return _NO_MEMORY
    if isinstance(error, OSError):
        name = f"{Path(str(error.filename)).name}: " if error.filename else ""
        return f"{name}{error.strerror or error or type(error).__name__}."
    if isinstance(error, ValueError):
        return str(error) or type(error).__name__
    return None
