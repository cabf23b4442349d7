"""The Skeleton tab's views, used as a person would: resolution, growth, picking."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, Qt

pytestmark = pytest.mark.gui

LONG = 60_000


def test_nothing_is_computed_before_the_tab_is_shown(hidden_tab):
    assert hidden_tab.views.skeleton(1) is None


def test_it_opens_with_euclidean_beside_mixture(tab):
    panes, _ = tab.panes(1.0)
    assert [pane.title for pane in panes] == [
        "Euclidean distance, R = 22",
        "Mixture distance, R = 22",
    ]
    assert all("1 loops / genus 1" in pane.caption for pane in panes)


def test_a_dragged_slider_redraws_and_is_one_step_of_undo(qtbot, tab, settle):
    slider = tab.centre.resolutions[1].slider
    slider.setFocus()
    for _ in range(6):
        qtbot.keyClick(slider, Qt.Key.Key_Left)
    settle()
    assert tab.views.skeleton(1).graph.resolution == 16
    assert tab.centre.resolutions[1].number.value() == 16
    assert tab.session.study.skeleton.views[0].resolution == 22
    tab.session.undo()
    settle()
    assert tab.views.skeleton(1).graph.resolution == 22
    assert slider.value() == 22


def test_a_dragged_slider_does_not_lay_out_the_tab_anew(tab, settle):
    requests = []

    class Watch(QObject):
        def eventFilter(self, _, event):  # noqa: N802 (the name is Qt's)
            if event.type() == QEvent.Type.LayoutRequest:
                requests.append(event)
            return False

    watch = Watch()
    tab.installEventFilter(watch)
    for resolution in (8, 12, 40):
        tab.centre.resolutions[1].slider.setValue(resolution)
        settle()
    assert tab.centre.growth.label.text() == "all 40 bands"
    assert not requests


def test_one_views_resolution_leaves_the_other_view_as_it_is(qtbot, tab, settle):
    before, look = tab.panes(1.0)
    slider = tab.centre.resolutions[1].slider
    slider.setFocus()
    qtbot.keyClick(slider, Qt.Key.Key_Left)
    settle()
    after, same_look = tab.panes(1.0)
    assert same_look == look
    assert after[0].skeleton is before[0].skeleton
    assert after[1].skeleton is not before[1].skeleton


def test_auto_chooses_a_resolution(qtbot, tab, settle, hands):
    hands.click(tab.centre.resolutions[1].automatic)
    qtbot.waitUntil(lambda: tab.session.study.skeleton.views[1].resolution != 22, timeout=LONG)
    settle()
    assert tab.views.skeleton(1).graph.loops == 1


def test_growth_by_hand_and_by_itself(qtbot, tab, settle, hands):
    tab.growth.slider.setFocus()
    qtbot.keyClick(tab.growth.slider, Qt.Key.Key_Home)
    settle()
    assert tab.step == 0
    with qtbot.waitSignal(tab.growth.changed, timeout=LONG):
        hands.click(tab.growth.play)
    assert tab.growth.is_playing
    hands.click(tab.growth.pause)
    assert not tab.growth.is_playing
    qtbot.keyClick(tab.growth.slider, Qt.Key.Key_End)
    settle()
    assert tab.step is None


def test_picking_is_linked_both_ways(tab, settle, hands):
    drawing = tab.centre.flat[1]
    node = 4
    x, y = drawing.places()[node]
    hands.click(drawing, QPoint(round(x), round(y)))
    settle()
    pane = tab.panes(1.0)[0][1]
    assert pane.picked == node
    assert pane.note.startswith(f"node {node}, ")
    empty = QPoint(3, tab.viewport.interactor.height() - 5)
    hands.click(tab.viewport.interactor, empty)
    settle()
    assert tab.selected == 0
    size = tab.viewport.pixel_size()
    places, _, _ = tab.viewport.grid._project(0, size)
    left, bottom = places[-1]
    hands.click(tab.viewport.interactor, QPoint(round(left), round(size[1] - bottom)))
    settle()
    assert tab.panes(1.0)[0][0].picked is not None


def test_a_cancelled_graph_is_told_with_a_button_to_draw_it(tab, settle, hands):
    bar = tab.centre.resolutions[1]
    assert not bar.notice.isVisible()
    bar.number.setValue(40)
    tab.session.cancel()
    assert bar.notice.isVisible()
    assert bar.notice.text().startswith("Cancelled")
    assert not tab.centre.resolutions[0].notice.isVisible()
    hands.click(bar.resume)
    assert not bar.notice.isVisible()
    settle()
    assert tab.views.skeleton(1).view.resolution == 40


def test_an_unchanged_view_keeps_its_pixels(qtbot, tab, settle):
    qtbot.waitUntil(lambda: not tab.viewport._rest.isActive(), timeout=LONG)
    before = _pixels(tab)
    tab.centre.resolutions[1].number.setValue(9)
    settle()
    after = _pixels(tab)
    half = before.shape[1] // 2
    assert np.abs(after[60:-60, half + 20 :] - before[60:-60, half + 20 :]).max() > 60
    assert np.abs(after[60:-60, : half - 20] - before[60:-60, : half - 20]).mean() < 12


def _pixels(tab):
    image = tab.viewport.interactor.grabFramebuffer().convertToFormat(
        tab.viewport.interactor.grabFramebuffer().Format.Format_RGB888
    )
    rows = np.array(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), -1, 3).astype(int)
