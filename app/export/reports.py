"""What the command line prints and writes about a comparison."""

from typing import Any

from app.export.tables import as_text, study_rows
from core.comparison import MethodResult, StudyResult
from core.parameters import describe, value_text
from core.smoothing import METHODS


def comparison_json(result: StudyResult) -> dict[str, Any]:
    """Describe a comparison as one JSON object.

    Each metric of a method is a list with one number an iteration, the noisy input first.
    """
    original = result.comparison.original
    study = result.study
    noise: dict[str, Any] = {"file": study.noisy} if study.noisy else study.noise.model_dump()
    return {
        "model": {
            "file": study.model,
            "vertices": len(original.vertices),
            "faces": len(original.faces),
            "mean_edge_length": original.mean_edge_length,
            "changes": list(result.report),
        },
        "units": "model" if study.model_units else "mean edge length",
        "noise": noise,
        "noisy": result.comparison.noisy_errors,
        "methods": [_method_json(method) for method in result.methods],
    }


def _method_json(result: MethodResult) -> dict[str, Any]:
    return {
        "id": result.choice.method,
        "iterations": result.iterations,
        "params": result.choice.settings.model_dump(),
        **{metric: list(values) for metric, values in result.errors.items()},
        "seconds_per_iteration": result.seconds_per_iteration,
        "diverged": result.diverged,
    }


def methods_json() -> dict[str, Any]:
    """Describe every method with its parameters as one JSON object."""
    return {
        "methods": [
            {
                "id": spec.id,
                "title": spec.title,
                "summary": spec.summary,
                "formula": spec.formula,
                "reference": spec.reference,
                "parameters": [
                    {
                        "name": parameter.name,
                        "kind": parameter.kind,
                        "default": parameter.default,
                        "allowed": parameter.domain,
                        "help": parameter.help,
                    }
                    for parameter in describe(spec.params)
                ],
            }
            for spec in METHODS.values()
        ]
    }


def methods_text() -> str:
    """List every method with its parameters for a terminal."""
    return "\n".join(_method_text(id_) for id_ in METHODS)


def _method_text(method: str) -> str:
    spec = METHODS[method]
    lines = [f"{spec.id}: {spec.summary}"]
    for parameter in describe(spec.params):
        default = value_text(parameter.default)
        lines.append(f"    {parameter.name} = {default}  ({parameter.domain})")
        lines.append(f"        {parameter.help}")
    return "\n".join(lines)


def comparison_text(result: StudyResult) -> str:
    """Describe a comparison as a table for a terminal."""
    original = result.comparison.original
    head = (
        f"{result.study.model}: {len(original.vertices):,} vertices, "
        f"{len(original.faces):,} faces, mean edge length {original.mean_edge_length:.6g}"
    )
    return "\n".join([head, *result.report, as_text(study_rows(result))])
