"""What goes wrong with a file, each in one sentence that a person can act on."""


class LoadError(ValueError):
    """Raised when a file cannot be read as a mesh; names the file and says why."""


class SaveError(ValueError):
    """Raised when a mesh cannot be written; names the file and says why."""
