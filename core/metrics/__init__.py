"""Metrics: how far a mesh is from its original, each in its own file, in display order."""

from core.metrics import normal_angle, vertex_rms
from core.metrics import visual_error as _visual_error
from core.metrics.spec import Evaluator, MetricSpec
from core.metrics.visual_error import visual_error

METRICS: dict[str, MetricSpec] = {
    spec.id: spec for spec in (_visual_error.SPEC, vertex_rms.SPEC, normal_angle.SPEC)
}
"""All metrics by id, in the order in which they are shown; the first is the default."""


def metrics_in(*, model_units: bool) -> dict[str, MetricSpec]:
    """All metrics by id, in mean edge lengths ℓ̄ or in the file's own units."""
    if not model_units:
        return METRICS
    return {id_: spec.in_model_units() for id_, spec in METRICS.items()}


__all__ = ["METRICS", "Evaluator", "MetricSpec", "metrics_in", "visual_error"]
