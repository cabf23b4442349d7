"""The reference page of methods and metrics, made from their declarations."""

from core.metrics import METRICS, MetricSpec
from core.parameters import Parameter, describe
from core.smoothing import METHODS, MethodSpec


def reference_page() -> str:
    """Write the page in Markdown."""
    methods = [_method(spec) for spec in METHODS.values()]
    metrics = [_metric(spec) for spec in METRICS.values()]
    return "\n\n".join(["# Methods", *methods, "# Metrics", *metrics]) + "\n"


def _method(spec: MethodSpec) -> str:
    parts = [f"## {spec.title}", spec.summary, f"**{spec.formula}**"]
    if spec.departure:
        parts.append(f"*Departure from the printed thesis:* {spec.departure}")
    parts += [_parameter(parameter) for parameter in describe(spec.params)]
    parts.append(f"*Source:* {spec.reference}")
    return "\n\n".join(parts)


def _metric(spec: MetricSpec) -> str:
    return "\n\n".join(
        [f"## {spec.title} ({spec.unit})", spec.summary, f"**{spec.formula}**",
         f"*Source:* {spec.reference}"]
    )  # fmt: skip


def _parameter(parameter: Parameter) -> str:
    default = "auto" if parameter.default is None else parameter.default
    return f"- `{parameter.name}` ({parameter.domain}; default {default}): {parameter.help}"
