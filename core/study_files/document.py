"""A study as a JSON document: format version, checks, migration of older versions."""

import json
from collections.abc import Callable, Mapping
from typing import Any

from pydantic import ValidationError

from core.metrics import METRICS
from core.parameters import Params, param
from core.smoothing import METHODS
from core.study import Study
from core.study_files.fingerprints import Fingerprint
from core.study_files.places import Role, models_of

FORMAT = "burnish study"
FORMAT_VERSION = 2
MOST_BYTES = 4 * 1024**2


def _with_second_model(plain: dict[str, Any]) -> dict[str, Any]:
    """Turn version 1 into 2, which may name a file as the second model; version 1 never did."""
    return {**plain, "version": 2}


MIGRATIONS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {1: _with_second_model}
"""What turns a document of a version into one of the next; version 1 is the first."""


class Document(Params):
    """Content of a study file: a study, and the fingerprints of its models."""

    format: str = param(FORMAT, help="Says what the file is.")
    version: int = param(FORMAT_VERSION, help="Version of the format.")
    study: Study = param(..., help="The study; models are named relative to the file.")
    files: dict[str, Fingerprint] = param(..., help="Fingerprint of each model.")


def write_document(study: Study, files: Mapping[Role, Fingerprint]) -> str:
    """Return a study, whose models are already named as in a file, as JSON."""
    document = Document(study=study, files={**files})
    # The document's own version says it all.
    plain = document.model_dump(mode="json", exclude={"study": {"version"}})
    return json.dumps(plain, indent=1, ensure_ascii=False) + "\n"


def read_document(content: bytes) -> Document:
    """Read and check a document; nothing in it is carried out.

    Raises
    ------
    ValueError
        One phrase without the file's name: not JSON, another format, a version or field that is
        not known, a value that is not allowed.
    """
    if len(content) > MOST_BYTES:
        raise ValueError(f"is larger than a study can be ({MOST_BYTES >> 20} MB)")
    plain = _migrated(_plain(content))
    try:
        document = Document.model_validate(plain)
    except ValidationError as error:
        raise ValueError(_phrase(error)) from error
    _check(document)
    return document


def _plain(content: bytes) -> dict[str, Any]:
    try:
        plain = json.loads(content.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:
        raise ValueError("is not a study: it is not well-formed JSON") from error
    if not isinstance(plain, dict) or plain.get("format") != FORMAT:
        raise ValueError(f'is not a study: it does not say "format": "{FORMAT}"')
    return plain


def _migrated(plain: dict[str, Any]) -> dict[str, Any]:
    version = plain.get("version")
    if not isinstance(version, int) or isinstance(version, bool) or version < 1:
        raise ValueError(f"has the format version {version!r}, which is not known")
    if version > FORMAT_VERSION:
        raise ValueError(
            f"was written by a newer Burnish (format version {version}; "
            f"this one reads up to {FORMAT_VERSION})"
        )
    try:
        for old in range(version, FORMAT_VERSION):
            plain = MIGRATIONS[old](plain)
    except (LookupError, TypeError, AttributeError) as error:
        raise ValueError(f"is damaged (it says format version {version})") from error
    return plain


def _phrase(error: ValidationError) -> str:
    first = error.errors()[0]
    name = ".".join(str(part) for part in first["loc"])
    if first["type"] == "extra_forbidden":
        return f"has the field {name[:80]}, which this Burnish does not know"
    if first["type"] == "missing":
        return f"lacks the field {name}"
    if first["type"] == "value_error":
        return f"has {name[:80]}, which is not allowed: {first['ctx']['error']}"
    return f"has {name[:80]}={str(first['input'])[:40]}, which is not allowed: {first['msg']}"


def _check(document: Document) -> None:
    """Check what the types of the fields cannot: ids, and the parameters that belong to them."""
    study = document.study
    named = models_of(study).keys()
    if document.files.keys() != named:
        raise ValueError(f"must hold the fingerprints of: {', '.join(sorted(named))}")
    methods = [choice.method for choice in study.methods]
    if len(set(methods)) < len(methods):
        raise ValueError("names a method twice")
    _ = [choice.settings for choice in study.methods]
    _ = [choice.settings for choice in study.repairs]
    _ = [view.settings for view in study.skeleton.views]
    _ = study.statistics.geodesic_params
    for name, id_, allowed in (
        ("metric", study.metric, METRICS),
        ("view.colour", study.view.colour, ("none", *METRICS)),
        ("view.compare_with", study.view.compare_with, ("original", "noisy", *METHODS)),
        *(("source", v.source, ("original", "noisy", *METHODS)) for v in study.skeleton.views),
    ):
        if id_ not in allowed:
            raise ValueError(f"has {name}={id_[:40]}; allowed: {', '.join(allowed)}")
