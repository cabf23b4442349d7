"""Slider and number of iterations, by mouse, keys and wheel."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from app.ui.method_block import IterationControl

pytestmark = pytest.mark.gui

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def control(shown):
    return shown(IterationControl("Test"), 280, 40)


def test_slider_jumps_to_where_it_is_pressed(qtbot, control):
    slider = control.slider
    qtbot.mouseClick(slider, LEFT, pos=QPoint(slider.width() // 2, slider.height() // 2))
    assert control.box.value() == 15
    qtbot.mouseClick(slider, LEFT, pos=QPoint(slider.width() - 2, slider.height() // 2))
    assert control.box.value() == 30


def test_slider_reaches_as_far_as_a_typed_number(qtbot, control, hands):
    with qtbot.waitSignal(control.changed) as changed:
        hands.type_into(control.box, "200")
    assert changed.args == [200]
    assert (control.slider.value(), control.slider.maximum()) == (200, 200)
    hands.type_into(control.box, "5")
    assert control.slider.maximum() == 30


def test_scale_stays_while_the_handle_is_dragged(qtbot, control):
    control.set_value(100)
    slider = control.slider
    middle = slider.height() // 2
    qtbot.mousePress(slider, LEFT, pos=QPoint(slider.width() - 6, middle))
    qtbot.mouseMove(slider, QPoint(slider.width() // 2, middle))
    assert slider.maximum() == 100
    assert 40 < control.box.value() < 60
    qtbot.mouseRelease(slider, LEFT, pos=QPoint(slider.width() // 2, middle))
    assert slider.maximum() == slider.value() == control.box.value()


def test_wheel_moves_a_control_only_with_the_focus(control):
    QApplication.focusWidget().clearFocus()
    wheel(control.box)
    assert control.box.value() == 0
    control.box.setFocus()
    wheel(control.box)
    assert control.box.value() == 1


def wheel(widget):
    place = QPointF(widget.rect().center())
    event = QWheelEvent(
        place,
        QPointF(widget.mapToGlobal(place)),
        QPoint(0, 0),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)
