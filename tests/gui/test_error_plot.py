"""The error plot in the window, by mouse and keys."""

import pytest
from PySide6.QtCore import QPoint, Qt

from app.scene.colours import DARK
from app.ui.error_plot import ErrorPlot
from core.smoothing import METHODS

pytestmark = pytest.mark.gui

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def plot(qtbot, session, shown):
    plot = shown(ErrorPlot(session), 640, 190)
    qtbot.waitUntil(
        lambda: len(legend(plot)) == 6 and plot.canvas._background is not None, timeout=10_000
    )
    return plot


def legend(plot):
    return [text.get_text() for text in plot.canvas.axes.texts]


def artist(plot, gid):
    axes = plot.canvas.axes
    return next(found for found in (*axes.lines, *axes.texts) if found.get_gid() == gid)


def click_plot(qtbot, plot, x, y):
    """Click a place given in pixels from the lower left corner, as matplotlib counts."""
    qtbot.mouseMove(plot.canvas, QPoint(round(x), plot.canvas.height() - round(y)))
    qtbot.mouseClick(plot.canvas, LEFT, pos=QPoint(round(x), plot.canvas.height() - round(y)))


def test_plot_shows_a_line_a_method_and_the_noisy_input(session, plot):
    enabled = [choice for choice in session.study.methods if choice.enabled]
    titles = [METHODS[choice.method].title for choice in enabled]
    assert legend(plot) == [*titles, "noisy input"]
    assert artist(plot, "mean.line").get_ydata().tolist() == pytest.approx(
        session.run("mean").values("visual_error")
    )
    assert artist(plot, "mean.marker").get_xdata() == [6]


def test_marker_follows_the_slider_without_a_new_frame(qtbot, plot, change):
    ground = plot.canvas._background
    assert ground is not None
    change("mean", iterations=2)
    qtbot.waitUntil(lambda: artist(plot, "mean.marker").get_xdata() == [2])
    assert plot.canvas._background is ground


@pytest.mark.parametrize("gid", ["median.legend", "median.marker"])
def test_click_on_marker_or_label_selects_the_method(qtbot, plot, gid, change):
    change("median", iterations=3)
    qtbot.waitUntil(lambda: artist(plot, "median.marker").get_xdata() == [3])
    place = artist(plot, gid).get_window_extent()
    with qtbot.waitSignal(plot.selected) as selected:
        click_plot(qtbot, plot, (place.x0 + place.x1) / 2, (place.y0 + place.y1) / 2)
    assert selected.args == ["median"]


def test_click_beside_the_lines_selects_nothing(qtbot, plot):
    place = plot.canvas.axes.get_window_extent()
    with qtbot.assertNotEmitted(plot.selected):
        click_plot(qtbot, plot, place.x0 + 30, place.y0 - 20)


def test_selected_method_is_drawn_heavy(qtbot, plot):
    plot.set_selected("mean")
    qtbot.waitUntil(lambda: artist(plot, "mean.line").get_linewidth() > 2)


def test_metric_is_chosen_by_keys(qtbot, session, plot):
    qtbot.keyClick(plot.metric_box, Qt.Key.Key_Down)
    assert session.study.metric == "vertex_rms"
    axes = plot.canvas.axes
    qtbot.waitUntil(lambda: axes.get_title(loc="left") == "Vertex RMS error (ℓ̄)")
    session.undo()
    assert plot.metric_box.currentText() == "Visual error"


def test_log_scale_and_theme(qtbot, plot, hands):
    assert plot.canvas.axes.get_yscale() == "log"
    hands.click_check(plot.log_box)
    qtbot.waitUntil(lambda: plot.canvas.axes.get_yscale() == "linear")
    plot.set_theme(DARK)
    qtbot.waitUntil(lambda: plot.canvas.grab().toImage().pixelColor(3, 3).name() == DARK.panel)


def test_plot_says_where_a_run_diverged(qtbot, plot, change, diverging):
    change("diffusion", params=diverging)
    qtbot.waitUntil(lambda: any("diverged at" in text for text in legend(plot)), timeout=10_000)


def test_plot_is_redrawn_when_it_is_shown_again(qtbot, plot, change):
    plot.hide()
    change("mean", enabled=False)
    plot.show()
    qtbot.waitUntil(lambda: "Mean filter" not in legend(plot))


def test_saved_plot_shows_what_the_window_shows(plot, tmp_path):
    plot.writer()(tmp_path / "errors.svg")
    assert "Angle median filter" in (tmp_path / "errors.svg").read_text(encoding="utf-8")


def test_a_frame_drawn_in_steps_is_the_one_that_is_drawn_at_once(qtbot, plot, change):
    before = plot.canvas._background
    change("median", enabled=False)
    qtbot.waitUntil(lambda: len(legend(plot)) == 5)
    qtbot.waitUntil(lambda: plot.canvas._background not in {before, None})
    qtbot.waitUntil(lambda: not plot._redrawing.is_active)
    stepwise = plot.canvas.grab().toImage()
    plot.canvas.draw()
    assert plot.canvas.grab().toImage() == stepwise
