"""How a study file names a model: by relative path, as a bundled one, or packed beside it."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from core.io import SUPPORTED_READ
from core.study import SAMPLE_PREFIX, Study

Role = Literal["model", "noisy", "second"]
"""Which model of a study: the original, its noisy file, or the Statistics tab's second model."""

PACKED_PREFIX = "packed:"

_LONGEST = 4096


def models_of(study: Study) -> dict[Role, str]:
    """Return the models that a study names, by role."""
    models: dict[Role, str | None] = {
        "model": study.model, "noisy": study.noisy, "second": study.statistics.second_file,
    }  # fmt: skip
    return {role: model for role, model in models.items() if model is not None}


def with_models(study: Study, models: Mapping[Role, str]) -> Study:
    """Return a study that names some of its models otherwise."""
    second = models.get("second", study.statistics.second)
    update: dict[str, object] = {role: models[role] for role in models if role != "second"}
    update["statistics"] = study.statistics.model_copy(update={"second": second})
    return study.model_copy(update=update)


def written_place(model: str, folder: Path) -> str:
    """Return how a file in `folder` names a model: relative to the folder, with slashes."""
    if model.startswith(SAMPLE_PREFIX):
        return model
    path = os.path.abspath(model)
    try:
        place = Path(os.path.relpath(path, folder.absolute())).as_posix()
    except ValueError:  # another drive
        return Path(path).as_posix()
    return f"./{place}" if place.startswith((SAMPLE_PREFIX, PACKED_PREFIX)) else place


def read_place(text: str, folder: Path) -> str:
    """Return the model that a file in `folder` names: a path, or ``sample:ID``.

    Raises
    ------
    ValueError
        If the text is not the name of a model on this computer.
    """
    if text.startswith(SAMPLE_PREFIX):
        return text
    # A share on the network would be told who asks for it, and what is no model is not touched.
    is_share = text.replace("\\", "/").startswith("//")
    is_model = Path(text).suffix.lower() in SUPPORTED_READ
    if is_share or not is_model or "\0" in text or len(text) > _LONGEST:
        raise ValueError(f"{text[:60]!r} is not the place of a model")
    return os.path.normpath(folder.absolute() / text)


def place_name(place: str) -> str:
    """Return the file name of a place, or the id of a bundled model."""
    return (
        place.removeprefix(SAMPLE_PREFIX) if place.startswith(SAMPLE_PREFIX) else Path(place).name
    )
