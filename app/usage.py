"""Words of the command line that do not fit."""


class UsageError(ValueError):
    """Raised when the words of a command do not fit; one sentence says how."""
