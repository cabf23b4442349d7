"""What the captions of the comparison say."""

import pytest

from app.scene.comparison import error_text
from core.metrics import METRICS


@pytest.mark.parametrize(
    ("metric", "value", "text"),
    [
        ("visual_error", 0.033, "D = 0.0330"),
        ("visual_error", 0.0, "D = 0"),
        ("visual_error", 123.4, "D = 123"),
        ("normal_angle", 2.4, "Normal angle = 2.40°"),
    ],
)
def test_errors_have_three_digits(metric, value, text):
    assert error_text(METRICS[metric], value) == text
