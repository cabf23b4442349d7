"""What the commands share: words that do not fit, and what is said on standard output."""


class UsageError(ValueError):
    """Raised when the words of a command do not fit; one sentence says how."""


def say(text: str) -> None:
    """Print the outcome of a command."""
    print(text)  # noqa: T201
