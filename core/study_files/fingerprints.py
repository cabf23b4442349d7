"""Fingerprints of files: equal fingerprints mean equal content."""

import hashlib
import os
from functools import lru_cache
from pathlib import Path

from pydantic import Field

from core.io import sample_path
from core.parameters import Params
from core.study import SAMPLE_PREFIX


class Fingerprint(Params):
    """Size and content hash of a file."""

    size: int = Field(ge=0, description="Size in bytes.")
    sha256: str = Field(pattern="^[0-9a-f]{64}$", description="SHA-256 in hexadecimal digits.")

    @classmethod
    def of(cls, content: bytes) -> "Fingerprint":
        """Return the fingerprint of a content that is in memory."""
        return cls(size=len(content), sha256=hashlib.sha256(content).hexdigest())


def fingerprint(model: str | os.PathLike[str]) -> Fingerprint:
    """Return the fingerprint of a model's file.

    Parameters
    ----------
    model : str or path-like
        Path, or ``sample:ID`` for a bundled model.

    Returns
    -------
    Fingerprint
        Size and hash; kept as long as the file's size and time of change stay the same.

    Raises
    ------
    OSError
        If the file cannot be read.
    LoadError
        If there is no such bundled model.
    """
    path = model_path(os.fspath(model))
    state = path.stat()
    return Fingerprint(size=state.st_size, sha256=_digest(path, state.st_size, state.st_mtime_ns))


def model_path(model: str) -> Path:
    """Return the file of a model given by its path or as ``sample:ID``."""
    if model.startswith(SAMPLE_PREFIX):
        return sample_path(model.removeprefix(SAMPLE_PREFIX))
    return Path(model)


@lru_cache(maxsize=64)
def _digest(path: Path, _size: int, _changed: int) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
