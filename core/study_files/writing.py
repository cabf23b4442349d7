"""Writing study files, plain or with their models packed inside."""

import os
from collections.abc import Mapping
from pathlib import Path

from core.study import SAMPLE_PREFIX, Study
from core.study_files.document import write_document
from core.study_files.errors import StudyFileError
from core.study_files.fingerprints import Fingerprint, fingerprint
from core.study_files.packing import pack, packable
from core.study_files.places import (
    PACKED_PREFIX,
    Role,
    models_of,
    place_name,
    with_models,
    written_place,
)
from core.whole_files import write_atomically


def study_text(study: Study, folder: Path, known: Mapping[str, Fingerprint] | None = None) -> str:
    """Return the content of a plain study file in a folder.

    Parameters
    ----------
    study : Study
        What is written.
    folder : Path
        Models are named relative to it.
    known : mapping, optional
        Fingerprints by model, taken when the models were read; others are taken now.

    Raises
    ------
    OSError, LoadError
        If a model whose fingerprint is not known cannot be read.
    """
    models = models_of(study)
    marks = {role: (known or {}).get(m) or fingerprint(m) for role, m in models.items()}
    places = {role: written_place(model, folder) for role, model in models.items()}
    return write_document(with_models(study, places), marks)


def write_study_file(
    study: Study,
    path: str | os.PathLike[str],
    *,
    packed: bool = False,
    known: Mapping[str, Fingerprint] | None = None,
) -> None:
    """Write a study; the old file is replaced only once the new one is complete.

    Parameters
    ----------
    study : Study
        What is written.
    path : str or path-like
        The file, in a folder that exists.
    packed : bool
        Put the models inside; without it they are named by relative path and content.
        Bundled models are always named by their id.
    known : mapping, optional
        Fingerprints by model, taken when the models were read; others are taken now.

    Raises
    ------
    StudyFileError
        One sentence: a model cannot be read or has changed since, no such folder, disk full.
    """
    file = Path(path)
    try:
        if packed:
            content = _packed(study, file.parent, known or {})
        else:
            content = study_text(study, file.parent, known).encode()
        write_atomically(file, content)
    except OSError as error:
        reason = f"{_model_at_fault(error, study)}{error.strerror or error}"
        raise StudyFileError(f"{file.name}: cannot be written ({reason}).") from error
    except ValueError as error:
        reason = str(error).removesuffix(".")
        raise StudyFileError(f"{file.name}: cannot be written ({reason}).") from error


def _model_at_fault(error: OSError, study: Study) -> str:
    """Name the model that could not be read, if it was one; the file itself is named anyway."""
    file = Path(str(error.filename))
    return f"{file.name}: " if file in map(Path, models_of(study).values()) else ""


def _packed(study: Study, folder: Path, known: Mapping[str, Fingerprint]) -> bytes:
    places: dict[Role, str] = {}
    marks: dict[Role, Fingerprint] = {}
    members: dict[str, bytes] = {}
    for role, model in models_of(study).items():
        if model.startswith(SAMPLE_PREFIX):
            places[role], marks[role] = model, fingerprint(model)
            continue
        if model in known and known[model] != fingerprint(model):
            raise ValueError(f"{place_name(model)} has changed since it was opened")
        name, content = packable(model)
        member = f"{role}/{name}"
        places[role], marks[role] = PACKED_PREFIX + member, Fingerprint.of(content)
        members[member] = content
    return pack(write_document(with_models(study, places), marks), members)
