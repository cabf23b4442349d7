"""Repairs as words of a command line: ``split,fill_holes:most_edges=60``."""

from collections.abc import Callable, Iterable, Iterator

from app.usage import UsageError
from core.doctor import RepairChoice, needed_repairs, repair_spec, repaired
from core.mesh import TriangleMesh
from core.parameters import build_params, value_text

ALL = "all"
NONE = "none"


def repairs_of(words: str, read: Callable[[], TriangleMesh]) -> tuple[RepairChoice, ...]:
    """Return the repairs that words name; "all" are those that the mesh needs at that point.

    The mesh is read only for "all".

    Raises
    ------
    UsageError, ParameterError
        If a word is not of the form, or a repair or a parameter is not allowed.
    """
    chosen: list[RepairChoice] = []
    for word in filter(None, (word.strip() for word in words.split(","))):
        if word == ALL:
            chosen += needed_repairs(repaired(read(), chosen).mesh)
        elif word != NONE:
            chosen.append(_choice(word))
    return tuple(chosen)


def repair_words(choices: Iterable[RepairChoice]) -> str:
    """Return the words that name repairs."""
    return ",".join(":".join([choice.repair, *_settings(choice)]) for choice in choices)


def _settings(choice: RepairChoice) -> Iterator[str]:
    for name, value in choice.settings.model_dump(exclude_defaults=True).items():
        yield f"{name}={value_text(value)}"


def _choice(word: str) -> RepairChoice:
    id_, *settings = word.split(":")
    values = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not (equals and name):
            raise UsageError(f"--repair {word} is not of the form repair:parameter=value.")
        values[name] = value
    made = build_params(repair_spec(id_).params, values, id_)
    return RepairChoice(repair=id_, params=made.model_dump(exclude_defaults=True))
