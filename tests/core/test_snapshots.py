"""Errors of several iterations measured together: when, in which order, and with what result."""

from itertools import islice

import pytest

from core import snapshots
from core.comparison import Comparison
from core.mesh import primitives
from core.noise import add_noise
from core.smoothing import DivergenceError
from core.snapshots import iterations, measured
from core.study import MethodChoice

RING = primitives.torus()
COMPARISON = Comparison(RING, add_noise(RING))
CHOICE = MethodChoice(method="laplacian", iterations=10)
EVALUATORS = {id_: e.along_surface for id_, e in COMPARISON.evaluators.items()}


@pytest.fixture(autouse=True)
def patience(monkeypatch):
    monkeypatch.setattr(snapshots, "_PATIENCE", 1000)


def numbers(steps, count):
    return [step and step.iteration for step in islice(steps, count)]


def test_eight_are_measured_together_and_the_last_ones_at_the_end():
    steps = COMPARISON.snapshots(CHOICE)
    assert numbers(steps, 16) == [None] * 7 + [1, 2, 3, 4, 5, 6, 7, 8, None]
    assert numbers(steps, 3) == [9, 10, 11]


def test_every_iteration_has_the_errors_of_its_positions():
    for snapshot in filter(None, islice(COMPARISON.snapshots(CHOICE), 10)):
        assert snapshot.errors == COMPARISON.errors(snapshot.vertices)


def test_what_is_wanted_may_change():
    wanted = 1
    steps = COMPARISON.snapshots(CHOICE, lambda: wanted)
    assert numbers(steps, 1) == [1]
    wanted = 3
    assert numbers(steps, 3) == [None, 2, 3]


@pytest.mark.parametrize("name", ["_PATIENCE", "_ROOM"])
def test_none_waits_where_iterations_are_slow_or_large(monkeypatch, name):
    monkeypatch.setattr(snapshots, name, 0)
    assert numbers(COMPARISON.snapshots(CHOICE), 6) == [1, 2, 3, 4, 5, 6]


@pytest.mark.parametrize("good", [0, 2, 8, 9])
def test_a_run_that_diverges_gives_all_before(good):
    def diverging():
        yield from islice(iterations(COMPARISON.noisy, CHOICE), good)
        raise DivergenceError(good + 1)

    there = []
    with pytest.raises(DivergenceError, match=f"iteration {good + 1}"):
        there.extend(filter(None, measured(diverging(), EVALUATORS, lambda: 99)))
    assert numbers(there, 99) == list(range(1, good + 1))
