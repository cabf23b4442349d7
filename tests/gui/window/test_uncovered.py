"""What is on the screen itself, where the drawing areas have surfaces of their own."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QWidget

COVER = QColor("#ff00ff")


@pytest.fixture
def cover(qtbot, window):
    """Another window in front of all of the main window."""
    cover = QWidget()
    qtbot.addWidget(cover)
    cover.setStyleSheet(f"background: {COVER.name()}")
    cover.setGeometry(window.geometry())
    return cover


def on_screen(window):
    """Pixels of the screen where the window is."""
    place = window.geometry()
    picture = window.screen().grabWindow(0, place.x(), place.y(), place.width(), place.height())
    image = picture.toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.array(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), -1, 3)


def colour_at(widget, window, place):
    """Colour that the screen shows at a place of a widget."""
    place = widget.mapTo(window, place)
    return tuple(on_screen(window)[place.y(), place.x()].tolist())


def ground_of(widget):
    """Colour of what no widget paints upon."""
    return widget.palette().window().color().getRgb()[:3]


def covered(window):
    """Number of pixels that show the cover."""
    return np.count_nonzero((on_screen(window) == COVER.getRgb()[:3]).all(axis=-1))


@pytest.mark.parametrize("tab", [0, 1, 2])
def test_a_window_that_was_in_front_leaves_nothing_behind(user, ball_file, cover, tab):
    user.open(ball_file)
    user.window.tabs.setCurrentIndex(tab)
    user.wait(lambda: user.window.session.activity is None)
    cover.show()
    user.wait(lambda: covered(user.window) > 0.9 * user.window.width() * user.window.height())
    cover.close()
    user.wait(lambda: covered(user.window) == 0)


def test_the_empty_panel_stands_before_the_drawing_area(user):
    panel = user.window.empty_panels[0]
    button = panel.buttons["open"]
    ground = ground_of(panel)
    user.wait(lambda: colour_at(button, user.window, QPoint(-4, 4)) == ground)
    user.wait(lambda: colour_at(button, user.window, QPoint(8, 8)) != ground)


def test_the_empty_panel_fits_into_any_room(user, qtlog):
    panel = user.window.empty_panels[0]
    panel.parentWidget().resize(4, 4)
    assert panel.size() == panel.parentWidget().size()
    assert not qtlog.records  # Qt complains of a negative width


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_a_plot_without_curves_has_the_ground_of_the_window(user, mode):
    user.window.actions_[f"theme_{mode}"].trigger()
    canvas = user.window.denoise.plot.canvas
    middle, ground = canvas.rect().center(), ground_of(user.window)
    user.wait(lambda: colour_at(canvas, user.window, middle) == ground)
