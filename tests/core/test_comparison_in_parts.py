"""A run whose iterations take long yields None in between, which counts for nothing."""

from itertools import islice

import pytest

from core.comparison import Comparison, run_method
from core.mesh import face_rings, primitives
from core.noise import add_noise
from core.study import MethodChoice

CHOICE = MethodChoice(method="median", iterations=2)


@pytest.fixture
def comparison():
    ball = primitives.sphere(2)
    return Comparison(ball, add_noise(ball))


def test_an_iteration_in_parts_is_one_snapshot(comparison, monkeypatch):
    whole = run_method(comparison, CHOICE)
    monkeypatch.setattr(face_rings, "_FEW_NEIGHBOURS", 2000)  # of 5,700
    steps = list(islice(comparison.snapshots(CHOICE), 7))
    assert [step and step.iteration for step in steps] == [*[None] * 5, 1, 2]
    assert steps[5].seconds > 0
    assert run_method(comparison, CHOICE).errors == whole.errors
