"""Work in steps beside whatever else the window has to do."""

import time

import pytest
from PySide6.QtCore import QTimer

from app.ui.turns import Turns, Work

pytestmark = pytest.mark.gui


@pytest.fixture
def turns(qapp):
    return Turns(qapp)


def test_long_steps_of_two_works_are_not_added_up(qtbot, turns):
    done, ticks = [], []
    timer = QTimer(interval=1)
    timer.timeout.connect(lambda: ticks.append(len(done)))
    timer.start()

    def steps(name):
        for number in range(4):
            time.sleep(0.02)
            done.append((number, name))
            yield

    for name in "ab":
        turns.add(steps(name))
    qtbot.waitUntil(lambda: len(done) == 8)
    assert done == sorted(done)
    assert {3, 4, 5} <= set(ticks)


def test_short_steps_share_a_turn(qtbot, turns):
    taken, turn = [], []
    turns.timeout.connect(lambda: turn.append(len(taken)))

    def steps():
        for number in range(50):
            taken.append(number)
            yield

    turns.add(steps())
    qtbot.waitUntil(lambda: len(taken) == 50)
    qtbot.wait(20)
    assert len(turn) < 25


def test_a_work_that_fails_does_not_stop_the_others(qtbot, turns):
    done = []

    def failing():
        yield
        raise ArithmeticError("bent")

    def sound():
        for number in range(5):
            time.sleep(0.006)
            done.append(number)
            yield

    broken = Work(turns, failing)
    with qtbot.captureExceptions() as errors:
        broken.request()
        turns.add(sound())
        qtbot.waitUntil(lambda: len(done) == 5)
    assert [str(error[1]) for error in errors] == ["bent"]
    assert not broken.is_active


def test_requests_meanwhile_give_one_more_run(qtbot, turns):
    runs = []

    def steps():
        runs.append(1)
        if len(runs) == 1:
            for _ in range(3):
                work.request()
        yield

    work = Work(turns, steps)
    work.request()
    qtbot.waitUntil(lambda: not work.is_active)
    assert len(runs) == 2
