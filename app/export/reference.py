"""The reference page of methods, metrics, fields, statistics and repairs, as declared."""

import inspect
import re
from collections.abc import Callable, Iterable
from typing import Any

from core.doctor import FINDINGS, REPAIRS, FindingSpec, RepairSpec, repair_for
from core.fields import FIELDS, FieldSpec
from core.metrics import METRICS, MetricSpec
from core.parameters import Parameter, Params, describe, value_text
from core.smoothing import METHODS, MethodSpec
from core.statistics import (
    GeodesicParams,
    SpectrumParams,
    assortativity,
    clustering,
    connectivity,
    degree_distribution,
    geodesic_steps,
    spectrum_steps,
)

STATISTICS: dict[str, tuple[str, Callable[..., Any], type[Params] | None]] = {
    "degree": ("Degree distribution", degree_distribution, None),
    "assortativity": ("Assortativity", assortativity, None),
    "clustering": ("Clustering coefficient", clustering, None),
    "geodesic": ("Geodesic distances", geodesic_steps, GeodesicParams),
    "spectrum": ("Laplacian spectrum", spectrum_steps, SpectrumParams),
    "connectivity": ("Numbers of each vertex", connectivity, None),
}
"""Title, computing function and parameters of each statistic, in the order of the page."""

_HEADING = re.compile(r"^(\w[\w ]*)\n-{3,}$", re.MULTILINE)


def reference_page() -> str:
    """Write the page in Markdown."""
    parts = ["# Methods", *(_method(spec) for spec in METHODS.values())]
    parts += ["# Metrics", *(_metric(spec) for spec in METRICS.values())]
    parts += ["# Fields", *(_field(spec) for spec in FIELDS.values())]
    parts += ["# Statistics", *(_statistic(*entry) for entry in STATISTICS.values())]
    parts += ["# Mesh doctor", *(_repair(spec) for spec in REPAIRS.values())]
    parts += [
        "## What cannot be repaired",
        *(_finding(spec) for spec in FINDINGS if not repair_for(spec)),
    ]
    return "\n\n".join(parts) + "\n"


def entry_title(entry: str) -> str:
    """Heading of a method, metric, field or statistic on the page, by its id.

    Raises
    ------
    KeyError
        If there is no such entry.
    """
    for registry in (METHODS, METRICS, FIELDS):
        if entry in registry:
            return str(registry[entry].title)
    return STATISTICS[entry][0]


def _method(spec: MethodSpec) -> str:
    return _entry(spec, spec.title, spec.departure, describe(spec.params))


def _metric(spec: MetricSpec) -> str:
    return _entry(spec, f"{spec.title} ({spec.unit})", "", ())


def _field(spec: FieldSpec) -> str:
    return _entry(spec, spec.title, spec.departure, describe(spec.params))


def _repair(spec: RepairSpec) -> str:
    """Entry of a repair: what it does, the findings that it is for, its parameters."""
    parts = [f"## {spec.title}", f"`{spec.id}`: {spec.summary}"]
    parts += [_finding(finding) for finding in (*spec.removes, *spec.eases)]
    parts += [_parameter(parameter) for parameter in describe(spec.params)]
    return "\n\n".join(parts)


def _finding(spec: FindingSpec) -> str:
    return f"*{spec.title}:* {spec.meaning}"


def _entry(
    spec: MethodSpec | MetricSpec | FieldSpec,
    title: str,
    departure: str,
    parameters: Iterable[Parameter],
) -> str:
    parts = [f"## {title}", spec.summary, f"**{spec.formula}**"]
    if departure:
        parts.append(f"*Departure from the printed thesis:* {departure}")
    parts += [_parameter(parameter) for parameter in parameters]
    parts.append(f"*Source:* {spec.reference}")
    return "\n\n".join(parts)


def _statistic(title: str, compute: Callable[..., Any], params: type[Params] | None) -> str:
    """Entry of a statistic: what its docstring says before the parameters, and its notes."""
    text = inspect.getdoc(compute) or ""
    pieces = _HEADING.split(text)
    sections = dict(zip(pieces[1::2], pieces[2::2], strict=True))
    parts = [f"## {title}", _flat(pieces[0])]
    parts += [_flat(sections[name]) for name in ("Notes",) if name in sections]
    parts += [_parameter(parameter) for parameter in (describe(params) if params else ())]
    if "References" in sections:
        parts.append(f"*Source:* {_flat(sections['References'])}")
    return "\n\n".join(part for part in parts if part)


def _flat(text: str) -> str:
    """Text of a docstring without its line ends and its markup for code."""
    paragraphs = [" ".join(part.split()) for part in text.strip().split("\n\n")]
    plain = "\n\n".join(paragraphs).replace("``", "`")
    return re.sub(r":\w+:`~?([^`]+)`", r"`\1`", plain)


def _parameter(parameter: Parameter) -> str:
    default = value_text(parameter.default)
    return f"- `{parameter.name}` ({parameter.domain}; default {default}): {parameter.help}"
