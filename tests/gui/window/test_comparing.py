"""Comparing two panes in place, the colour bar, and the value under the cursor."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt

from app.ui.colour_bar_dialog import ColourBarDialog
from app.ui.value_probe import description

LEFT = Qt.MouseButton.LeftButton
CONTROL = Qt.KeyboardModifier.ControlModifier


def titles(user):
    return {pane.id: pane.title for pane in user.denoise.viewport.grid.panes}


def test_the_key_shows_the_original_while_it_is_held(user, ball_file, qtbot):
    user.open(ball_file)
    user.click_pane("mean")
    original = user.denoise.panes()[0][0]
    qtbot.keyPress(user.window, Qt.Key.Key_X)
    assert titles(user)["mean"] == "Original"
    shown = next(p for p in user.denoise.viewport.grid.panes if p.id == "mean")
    assert shown.points is original.points
    qtbot.keyRelease(user.window, Qt.Key.Key_X)
    assert titles(user)["mean"] == "Mean filter"


def test_the_pane_to_compare_with_can_be_chosen_and_undone(user, ball_file, qtbot):
    user.open(ball_file)
    user.click_pane("mean")
    book = user.window.actions_
    book["compare_noisy"].trigger()
    assert book["compare_noisy"].isChecked()
    qtbot.keyPress(user.window, Qt.Key.Key_X)
    assert titles(user)["mean"] == "Noisy input"
    qtbot.keyRelease(user.window, Qt.Key.Key_X)
    user.press(Qt.Key.Key_Z, CONTROL)
    assert user.window.session.study.view.compare_with == "original"


def test_only_panes_that_are_shown_are_compared_with(user, ball_file):
    user.open(ball_file)
    book = user.window.actions_
    assert book["compare_mean"].isEnabled()
    assert "is not checked on the Denoise tab" in book["compare_laplacian"].toolTip()
    assert not book["compare_laplacian"].isEnabled()
    user.window.tabs.setCurrentIndex(1)
    assert not book["compare_mean"].isEnabled()


def test_from_the_menu_the_flicker_stays_until_it_is_chosen_again(user, ball_file):
    user.open(ball_file)
    user.click_pane("mean")
    user.window.actions_["flicker"].trigger()
    assert titles(user)["mean"] == "Original"
    user.window.actions_["flicker"].trigger()
    assert titles(user)["mean"] == "Mean filter"


def test_the_swipe_line_parts_two_results_and_is_dragged(user, ball_file, qtbot):
    user.open(ball_file)
    user.click_pane("mean")
    user.press(Qt.Key.Key_D)
    grid, area = user.denoise.viewport.grid, user.denoise.viewport.interactor
    assert (grid.swipe.left, grid.swipe.right) == ("original", "mean")
    assert list(grid.viewports) == ["original"]
    middle = user.middle_of("original")
    pose = grid.poses()[0]
    qtbot.mousePress(area, LEFT, pos=middle)
    qtbot.mouseMove(area, middle + QPoint(100, 0))
    qtbot.mouseRelease(area, LEFT, pos=middle + QPoint(100, 0))
    assert grid.swipe.share == pytest.approx(0.5 + 100 / area.width(), abs=0.01)
    assert grid.poses()[0] == pose  # the model did not turn
    share = user.denoise.viewport.share
    assert grid.mesh_at(*share(QPointF(middle + QPoint(90, 0)))) == "original"
    assert grid.mesh_at(*share(QPointF(middle + QPoint(110, 0)))) == "mean"
    user.press(Qt.Key.Key_D)
    assert grid.swipe is None
    assert len(grid.viewports) == 7


def test_the_swipe_follows_the_selection_and_ends_with_its_pane(user, ball_file):
    user.open(ball_file)
    user.click_pane("mean")
    user.press(Qt.Key.Key_D)
    user.denoise.select("bilateral")
    grid = user.denoise.viewport.grid
    assert grid.swipe.right == "bilateral"
    user.denoise.methods.blocks["bilateral"].check.click()
    user.rest()
    assert grid.swipe is None or grid.swipe.right != "bilateral"


def test_the_value_under_the_cursor_stands_in_the_status_bar(user, ball_file, qtbot):
    user.open(ball_file)
    user.press(Qt.Key.Key_H)
    user.rest()
    qtbot.mouseMove(user.denoise.viewport.interactor, user.middle_of("mean"))
    place = user.window.statusBar()._place
    user.wait(lambda: place.text().startswith("Mean filter: vertex "))
    vertex = int(place.text().split("vertex ")[1].split(",")[0].replace(",", ""))
    values = next(p for p in user.denoise.panes()[0] if p.id == "mean").values
    assert float(place.text().split()[-2]) == pytest.approx(values[vertex], rel=1e-3)
    assert "distance to the original" in place.text()
    qtbot.mouseMove(user.denoise.viewport.interactor, QPoint(3, 3))
    user.wait(lambda: not place.text())


def test_a_face_is_named_where_faces_have_values(user, ball_file):
    user.open(ball_file)
    user.window.actions_["colour_normal_angle"].trigger()
    user.rest()
    panes, look = user.denoise.panes()
    for face in (0, 17, 1000):
        centre = panes[2].points[look.faces[face]].mean(axis=0)
        assert f"face {face:,}, normal angle" in description(panes[2], look, np.array(centre))


def test_the_colour_bar_is_set_and_undone(user, ball_file):
    user.open(ball_file)
    user.press(Qt.Key.Key_H)
    user.press(Qt.Key.Key_C)
    dialog = user.window.findChild(ColourBarDialog)
    assert dialog.metric_box.currentText() == "Distance to the original"
    automatic = user.denoise.panes()[1].colour_range
    dialog.range.setCurrentIndex(dialog.range.findData("manual"))
    dialog.range.activated.emit(2)
    assert user.denoise.panes()[1].colour_range == pytest.approx(automatic, rel=1e-3)
    dialog.high.setValue(0.5)
    dialog.map.setCurrentIndex(dialog.map.findData("magma"))
    dialog.map.activated.emit(2)
    dialog.reversed.click()
    dialog.histogram.click()
    look = user.denoise.panes()[1]
    assert (look.colour_range[1], look.colour_map, look.histogram) == (0.5, "magma_r", None)
    assert user.window.session.history.undo_name == "Colour bar"
    dialog.close()
    user.window.session.undo()
    assert user.denoise.panes()[1].colour_map == "viridis"
    user.window.session.redo()
    assert user.denoise.panes()[1].colour_map == "magma_r"
