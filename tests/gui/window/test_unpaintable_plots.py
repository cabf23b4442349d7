"""An error while a plot is painted is told like any other, and the plot says that it failed."""

import logging

import pytest
from matplotlib.axis import XAxis
from PySide6.QtWidgets import QMessageBox, QPushButton

from app.export import chart
from app.ui import plot_canvas
from app.ui.figure_canvas import NOT_DRAWN


@pytest.fixture
def faults(user):
    """The window's fault reports in place of those of the tests."""
    user.window.faults.install()
    yield user.window.faults
    user.window.faults.uninstall()


def boxes(user):
    return [box for box in user.window.findChildren(QMessageBox) if box.isVisible()]


def close(user, box):
    box.findChildren(QPushButton)[-1].click()
    user.wait(lambda: not boxes(user))


def fail(*_, **__):
    raise ArithmeticError("the axis is bent")


def pixels(canvas):
    picture = canvas.grab().toImage()  # held: the bits are its own
    return bytes(picture.constBits())


def test_an_error_while_painting_is_told_once_and_the_plot_says_so(
    user, ball_file, faults, monkeypatch, caplog
):
    user.open(ball_file)
    study, canvas = user.window.session.study, user.denoise.plot.canvas
    user.wait(lambda: canvas._background is not None)
    before = pixels(canvas)
    with monkeypatch.context() as patch, caplog.at_level(logging.ERROR):
        patch.setattr(XAxis, "draw", fail)
        canvas.draw_idle()
        user.wait(lambda: boxes(user))
        assert "ArithmeticError: the axis is bent" in boxes(user)[0].informativeText()
        assert canvas.words == NOT_DRAWN
        assert pixels(canvas) != before
        for _ in range(5):
            canvas.update()
            user.qtbot.wait(50)
        assert caplog.text.count("ArithmeticError: the axis is bent") == 1
        close(user, boxes(user)[0])
        canvas.draw_idle()
        user.qtbot.wait(200)
        assert not boxes(user)
    assert user.window.session.study is study
    user.type_iterations("mean", 2)
    user.rest()
    user.wait(lambda: not canvas.words)
    user.wait(lambda: pixels(canvas) != before)


def test_a_chart_that_fails_half_way_is_not_shown_and_the_next_one_is(
    user, ball_file, faults, monkeypatch
):
    user.open(ball_file)
    canvas = user.denoise.plot.canvas
    with monkeypatch.context() as patch:
        patch.setattr(plot_canvas, "draw_curves", fail)
        user.type_iterations("mean", 2)
        user.wait(lambda: boxes(user))
        assert canvas.words == NOT_DRAWN
        canvas.draw_idle()
        user.qtbot.wait(100)
        assert canvas.words == NOT_DRAWN
        close(user, boxes(user)[0])
    user.rest()
    user.type_iterations("mean", 3)
    user.wait(lambda: not canvas.words)
    assert {chart.method_of(line) for line in canvas.axes.lines} >= {"mean", "median"}


def test_plots_of_the_statistics_say_so_too(user, ball_file, faults, monkeypatch):
    user.open(ball_file)
    with monkeypatch.context() as patch:
        patch.setattr(XAxis, "draw", fail)
        user.window.tabs.setCurrentIndex(2)
        tab = user.window.tabs.currentWidget()
        user.wait(lambda: tab.work.series() and tab.work.activity is None)
        user.wait(lambda: boxes(user))
        user.wait(lambda: any(plot.canvas.words for plot in tab.plots.values()))
        close(user, boxes(user)[0])
    for plot in tab.plots.values():
        plot.canvas.draw_idle()
    user.wait(lambda: not any(plot.canvas.words for plot in tab.plots.values()))


def test_an_error_under_the_pointer_is_told(user, ball_file, faults, monkeypatch):
    user.open(ball_file)
    canvas = user.denoise.plot.canvas
    monkeypatch.setattr(plot_canvas, "method_of", fail)
    user.qtbot.mouseMove(canvas, canvas.rect().center())
    user.wait(lambda: boxes(user))
    assert "the axis is bent" in boxes(user)[0].informativeText()
    assert not canvas.words
