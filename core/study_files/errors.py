"""What can be wrong with a study file, each in one sentence."""

from core.io.errors import printable


class StudyFileError(ValueError):
    """Raised when a study file cannot be read or written; names the file and says why."""

    def __init__(self, message: str) -> None:
        # Names of files and fields may hold line ends and control characters.
        super().__init__(printable(message, " "))


class ModelError(StudyFileError):
    """Raised when a model of a study is not what the study names.

    Attributes
    ----------
    role : {"model", "noisy", "second"}
        Which of the study's models.
    place : str
        Where it was looked for: a path, or ``sample:ID``.
    """

    def __init__(self, message: str, role: str, place: str) -> None:
        super().__init__(message)
        self.role = role
        self.place = place


class MissingModelError(ModelError):
    """Raised when a model is not where the study says."""


class ChangedModelError(ModelError):
    """Raised when a model has another content than when the study was saved."""
