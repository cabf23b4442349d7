"""Metrics: how far a mesh is from its original, each in its own file, in display order."""

from core.metrics import normal_angle, vertex_rms
from core.metrics import visual_error as _visual_error
from core.metrics.spec import Evaluator, MetricSpec
from core.metrics.visual_error import visual_error

METRICS: dict[str, MetricSpec] = {
    spec.id: spec for spec in (_visual_error.SPEC, vertex_rms.SPEC, normal_angle.SPEC)
}
"""All metrics by id, in the order in which they are shown; the first is the default."""

__all__ = ["METRICS", "Evaluator", "MetricSpec", "visual_error"]
