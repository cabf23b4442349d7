"""The study that the words of a command line describe, and those that describe a study."""

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from app.folders import unpacked_folder
from app.repair_words import repair_words, repairs_of
from app.usage import UsageError
from core.models import read_model
from core.noise import NoiseParams
from core.parameters import build_params, value_text
from core.smoothing import method_spec
from core.study import MethodChoice, Study
from core.study_files import ChangedModelError, MissingModelError, Role, read_study_file

_NO_METHOD = "none"
_ITERATIONS = "iterations"


def study_of_words(
    model: str | None,
    *,
    file: Path | None = None,
    repair: str | None = None,
    noisy: str | None = None,
    noise: dict[str, float | int | None] | None = None,
    methods: str | None = None,
    iterations: int | None = None,
    settings: Sequence[str] = (),
    model_units: bool = False,
) -> Study:
    """Build the study of a command line; what is not given is as in the file, or as declared.

    Raises
    ------
    UsageError, ParameterError, StudyFileError
        If a word does not fit, a value is not allowed, or the study file cannot be used.
    """
    base = _base(model, file, noisy)
    given = {name: value for name, value in (noise or {}).items() if value is not None}
    return base.model_copy(
        update={
            "repairs": base.repairs
            if repair is None
            else repairs_of(repair, lambda: read_model(base.model).mesh),
            "noise": build_params(NoiseParams, {**base.noise.model_dump(), **given}, "noise"),
            "methods": _choices(base, methods, iterations, settings),
            "model_units": base.model_units or model_units,
        }
    )


def command_of(study: Study) -> str:
    """Return the command line that carries out a study."""
    words = ["burnish", "compare", study.model]
    if study.repairs:
        words += ["--repair", repair_words(study.repairs)]
    if study.noisy is not None:
        words += ["--noisy", study.noisy]
    else:
        words += ["--sigma", repr(study.noise.sigma), "--seed", str(study.noise.seed)]
    enabled = [choice for choice in study.methods if choice.enabled]
    words += ["--methods", ",".join(choice.method for choice in enabled) or _NO_METHOD]
    for choice in enabled:
        words += _setting_words(choice)
    return shlex.join([*words, *(["--model-units"] if study.model_units else [])])


def _setting_words(choice: MethodChoice) -> list[str]:
    changed = choice.settings.model_dump(exclude_defaults=True)
    values = {_ITERATIONS: choice.iterations, **changed}
    texts = {name: value_text(value) for name, value in values.items()}
    return [
        word for name, text in texts.items() for word in ("--set", f"{choice.method}.{name}={text}")
    ]


def _base(model: str | None, file: Path | None, noisy: str | None) -> Study:
    if file is not None:
        return _study_in(file, model, noisy)
    if model is None:
        raise UsageError("compare requires an argument: a model, or --study with a study file.")
    fresh = Study()
    enabled = tuple(choice for choice in fresh.methods if choice.enabled)
    return fresh.model_copy(update={"model": model, "noisy": noisy, "methods": enabled})


def _study_in(file: Path, model: str | None, noisy: str | None) -> Study:
    """Read a study; models named on the command line take the place of its own as they are.

    The second model of the Statistics tab takes no part in a comparison and is left out.
    """
    named: dict[Role, str | None] = {"model": model, "noisy": noisy}
    chosen = {role: name for role, name in named.items() if name is not None}
    try:
        study = read_study_file(file).locate(
            unpacked_folder(), chosen=chosen, accepted=chosen.keys(), with_second=False
        )
    except (MissingModelError, ChangedModelError) as error:
        way = "before --study" if error.role == "model" else "after --noisy"
        raise UsageError(f"{error} Name the file to use {way}.") from error
    return study.model_copy(update={"noisy": noisy or study.noisy})


def _choices(
    base: Study, methods: str | None, iterations: int | None, settings: Sequence[str]
) -> tuple[MethodChoice, ...]:
    """Choose methods, their iterations and parameters."""
    ids = [choice.method for choice in base.methods if choice.enabled]
    if methods is not None:
        ids = [method_spec(id_.strip()).id for id_ in methods.split(",") if id_ != _NO_METHOD]
    values = {id_: base.choice(id_).model_dump() | {"enabled": True} for id_ in ids}
    for id_, name, value in map(_parse_setting, settings):
        if id_ not in values:
            raise UsageError(f"--set {id_}.{name}: {id_} does not take part; {_listed(ids)}.")
        target: dict[str, Any] = values[id_]
        if name != _ITERATIONS:
            target["params"] = {**target["params"], name: value}
        else:
            target[_ITERATIONS] = value
    for target in values.values():
        target.update({} if iterations is None else {_ITERATIONS: iterations})
    made = [build_params(MethodChoice, value) for value in values.values()]
    for choice in made:
        _ = choice.settings  # a wrong value is told now, not after minutes of work
    return tuple(made)


def _listed(ids: Sequence[str]) -> str:
    return f"{', '.join(ids)} do" if ids else "no method does"


def _parse_setting(setting: str) -> tuple[str, str, str]:
    left, equals, value = setting.partition("=")
    id_, dot, name = left.partition(".")
    if not (equals and dot and name):
        raise UsageError(f"--set {setting} is not of the form id.parameter=value.")
    return id_, name, value
