"""Commands act on the tab that is shown; what it cannot do is switched off and says why."""

import json

import numpy as np
import pytest
from matplotlib.image import imread
from PySide6.QtCore import QPoint, QSettings, Qt
from PySide6.QtGui import QGuiApplication

from app.ui.montage_dialog import MontageDialog
from app.ui.screenshot_dialog import ScreenshotDialog
from core.io import load_mesh

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def skeleton(user, ball_file):
    """The Skeleton tab with both graphs of a ball."""
    user.open(ball_file)
    user.press(Qt.Key.Key_2, CONTROL)
    tab = user.window.skeleton
    user.wait(lambda: tab.views.is_settled and all(map(tab.views.skeleton, (0, 1))))
    user.wait(lambda: not tab._redraw_timer.isActive() and tab.viewport.panes)
    return tab


@pytest.fixture
def statistics(user, ball_file):
    """The Statistics tab with the ball and its noisy copy."""
    user.open(ball_file)
    user.press(Qt.Key.Key_3, CONTROL)
    tab = user.window.statistics
    user.wait(lambda: tab.side.second.count() > 1 and tab.work.series())
    tab.side.second.activated.emit(tab.side.second.findData("noisy"))
    user.wait(lambda: len(tab.work.series()) == 2 and len(tab.view.panes) == 2)
    return tab


def titles(skeleton):
    return [slot.caption._lines[0].input for slot in skeleton.viewport.grid._slots]


def middle_of_first(statistics):
    """Point in the middle of the first model."""
    area = statistics.view.interactor
    port = statistics.view.scene.viewports[0]
    left, top, width, height = port.pixels(area.width(), area.height())
    return QPoint(int(left + width / 2), int(top + height / 2))


def shown_place(user):
    return user.window.statusBar()._place.text()


def test_keys_go_from_tab_to_tab(user):
    for place in (2, 3, 1):
        user.press(Qt.Key(Qt.Key.Key_0 + place), CONTROL)
        assert user.window.tabs.currentIndex() == place - 1
        assert user.window.actions_[f"tab_{place}"].isChecked()


def test_in_the_skeleton_tab_the_key_shows_the_other_graph_while_it_is_held(user, skeleton, qtbot):
    assert [title.split()[0] for title in titles(skeleton)] == ["Euclidean", "Mixture"]
    qtbot.keyPress(user.window, Qt.Key.Key_X)
    assert [title.split()[0] for title in titles(skeleton)] == ["Euclidean", "Euclidean"]
    qtbot.keyRelease(user.window, Qt.Key.Key_X)
    assert [title.split()[0] for title in titles(skeleton)] == ["Euclidean", "Mixture"]


def test_two_graphs_are_parted_by_a_line_that_is_dragged(user, skeleton, qtbot):
    area, grid = skeleton.viewport.interactor, skeleton.viewport.grid
    user.press(Qt.Key.Key_D)
    pose = grid.pose
    start = QPoint(area.width() // 2, area.height() // 2)
    qtbot.mousePress(area, LEFT, pos=start)
    qtbot.mouseMove(area, start + QPoint(120, 0))
    qtbot.mouseRelease(area, LEFT, pos=start + QPoint(120, 0))
    assert grid.share == pytest.approx(0.5 + 120 / area.width(), abs=0.01)
    assert grid.pose == pose
    qtbot.mousePress(area, LEFT, pos=QPoint(60, 200))
    qtbot.mouseMove(area, QPoint(160, 240))
    qtbot.mouseRelease(area, LEFT, pos=QPoint(160, 240))
    turned = grid.pose
    assert turned != pose
    user.press(Qt.Key.Key_D)
    assert grid.share is None
    assert grid.pose == turned


def test_without_a_second_view_there_is_nothing_to_compare_with(user, skeleton):
    book = user.window.actions_
    skeleton.side.compare.click()
    for command in ("flicker", "swipe"):
        assert not book[command].isEnabled()
        assert "Check “Compare two views” first." in book[command].toolTip()
    skeleton.side.compare.click()
    assert book["swipe"].isEnabled()
    assert "Not now" not in book["swipe"].toolTip()


@pytest.mark.parametrize(
    ("tab", "command", "reason"),
    [
        (1, "save_graph", "Skeleton tab"),
        (1, "save_statistics", "Statistics tab"),
        (2, "edges", "Level curves"),
        (2, "colour_bar", "Denoise tab"),
        (2, "colour_normal_angle", "The field colours"),
        (2, "panel_Methods", "Denoise tab"),
        (3, "link", "move together"),
        (3, "reset_panels", "no panels"),
    ],
)
def test_what_a_tab_cannot_do_says_why(user, ball_file, tab, command, reason):
    user.open(ball_file)
    user.press(Qt.Key(Qt.Key.Key_0 + tab), CONTROL)
    action = user.window.actions_[command]
    assert not action.isEnabled()
    assert f"Not now: {reason}" in action.toolTip() or reason in action.toolTip()


def test_without_a_model_the_commands_say_so(user):
    for command in ("figure", "flicker", "look_3", "fly", "save_mesh"):
        assert not user.window.actions_[command].isEnabled()
        assert "Open a model first." in user.window.actions_[command].toolTip()


def test_field_value_and_band_stand_in_the_status_bar(user, skeleton, qtbot):
    area = skeleton.viewport.interactor
    skeleton.side.layers.layers["show_graph"].click()
    qtbot.mouseMove(area, QPoint(area.width() // 4 + 30, area.height() // 2 - 40))
    user.wait(lambda: shown_place(user).startswith("Euclidean distance: vertex "))
    words = shown_place(user)
    vertex = int(words.split("vertex ")[1].split(", field")[0].replace(",", ""))
    value = float(words.split("value ")[1].split(",")[0])
    band = int(words.split("band ")[1].split()[0])
    known = skeleton.views.skeleton(0)
    assert value == pytest.approx(known.field.values[vertex], abs=0.1)
    assert band == 1 + np.searchsorted(known.levels, value, side="right")
    qtbot.mouseMove(area, QPoint(5, area.height() - 5))
    user.wait(lambda: not shown_place(user))


def test_degree_and_distance_of_a_vertex_stand_in_the_status_bar(user, statistics, qtbot):
    area = statistics.view.interactor
    place = middle_of_first(statistics)
    qtbot.mouseMove(area, place)
    user.wait(lambda: "degree" in shown_place(user))
    words = shown_place(user)
    vertex = int(words.split("vertex ")[1].split(", degree")[0].replace(",", ""))
    degrees = statistics.work.models[0].mesh.degrees
    assert f"degree {degrees[vertex]}," in words
    assert words.startswith("ball: ")
    qtbot.mouseClick(area, LEFT, pos=place)
    user.wait(lambda: statistics.work.distances(0) is not None)
    qtbot.mouseMove(area, place + QPoint(12, 0))
    user.wait(lambda: "distance" in shown_place(user))
    assert shown_place(user).endswith("ℓ̄")


def test_two_models_flicker_and_are_parted(user, statistics, qtbot):
    scene, view = statistics.view.scene, statistics.view
    assert [pane.pane.title for pane in scene._panes] == ["ball", "noisy"]
    qtbot.keyPress(user.window, Qt.Key.Key_X)
    assert [pane.pane.title for pane in scene._panes] == ["noisy", "noisy"]
    qtbot.keyRelease(user.window, Qt.Key.Key_X)
    assert [pane.pane.title for pane in scene._panes] == ["ball", "noisy"]
    before = scene.viewports
    user.press(Qt.Key.Key_D)
    assert scene.share == 0.5
    assert scene.viewports[0].top - scene.viewports[0].bottom == 1
    user.press(Qt.Key.Key_D)
    assert scene.viewports == before
    assert view.pose is not None


def test_a_camera_goes_from_one_tab_to_the_others(user, statistics):
    user.press(Qt.Key.Key_4)
    user.press(Qt.Key.Key_C, CONTROL | ALT)
    copied = json.loads(QGuiApplication.clipboard().text())
    text = QGuiApplication.clipboard().text()
    assert copied["position"] == pytest.approx(statistics.view.pose.position)
    for key in (Qt.Key.Key_1, Qt.Key.Key_2):
        user.press(key, CONTROL)
        QGuiApplication.clipboard().setText(text)
        user.press(Qt.Key.Key_V, CONTROL | ALT)
        pose = user.window.desk.stage.pose
        assert np.array(pose) == pytest.approx(np.array(statistics.view.pose))


@pytest.mark.parametrize("tab", ["skeleton", "statistics"])
def test_a_box_is_zoomed_into(request, user, qtbot, tab):
    stage = request.getfixturevalue(tab).desk.stage
    area, before = stage.interactor, stage.pose
    user.press(Qt.Key.Key_B)
    middle = QPoint(area.width() // 4, area.height() // 4)
    qtbot.mousePress(area, LEFT, pos=middle - QPoint(30, 30))
    qtbot.mouseMove(area, middle + QPoint(30, 30))
    qtbot.mouseRelease(area, LEFT, pos=middle + QPoint(30, 30))
    assert not user.window.actions_["box_zoom"].isChecked()

    def distance(pose):
        return np.linalg.norm(np.subtract(pose.position, pose.focal_point))

    assert distance(stage.pose) < 0.7 * distance(before)


@pytest.mark.parametrize(("tab", "count"), [("skeleton", 2), ("statistics", 7)])
def test_a_figure_shows_the_views_of_the_tab(request, user, tmp_path, tab, count):
    request.getfixturevalue(tab)
    user.press(Qt.Key.Key_F, CONTROL | SHIFT)
    dialog = user.window.findChild(MontageDialog)
    assert len(dialog.montage().cells) == count
    dialog.width_box.setValue(10)
    dialog.dpi.setValue(60)
    user.wait(lambda: dialog.preview.image is not None)
    dialog.save_button.click()
    user.answer_file_dialog(tmp_path / "figure.png")
    user.wait((tmp_path / "figure.png").exists)
    picture = imread(tmp_path / "figure.png")
    assert picture.shape[1] == 236
    assert picture[..., :3].std() > 0.05


@pytest.mark.parametrize("tab", ["skeleton", "statistics"])
def test_a_screenshot_shows_the_tab(request, user, tmp_path, tab):
    stage = request.getfixturevalue(tab).desk.stage
    user.press(Qt.Key.Key_P, CONTROL)
    dialog = user.window.findChild(ScreenshotDialog)
    dialog.scale.setValue(1)
    dialog._accept()
    user.answer_file_dialog(tmp_path / "view.png")
    user.wait((tmp_path / "view.png").exists)
    width, height = stage.interactor.pixel_size()
    assert imread(tmp_path / "view.png").shape[:2] == (height, width)


def test_graph_mesh_and_tables_are_in_the_export_menu(user, skeleton, tmp_path):
    for key, keys, name in (
        (Qt.Key.Key_G, CONTROL | SHIFT, "graph.graphml"),
        (Qt.Key.Key_M, CONTROL, "mesh.ply"),
    ):
        user.press(key, keys)
        user.answer_file_dialog(tmp_path / name)
        user.wait((tmp_path / name).exists)
    assert len(load_mesh(tmp_path / "mesh.ply").vertices) == 642
    assert "<graph" in (tmp_path / "graph.graphml").read_text()


def test_tables_and_plots_of_the_statistics_are_exported(user, statistics, tmp_path):
    user.press(Qt.Key.Key_E, CONTROL | SHIFT)
    user.answer_file_dialog(tmp_path / "numbers.csv")
    user.wait((tmp_path / "numbers.csv").exists)
    assert "# degree\nmodel,degree,vertices,share\n" in (tmp_path / "numbers.csv").read_text()
    user.window.actions_["save_plot_degree"].trigger()
    user.answer_file_dialog(tmp_path / "degree.svg")
    user.wait((tmp_path / "degree.svg").exists)


def test_panels_are_switched_by_a_command(user, ball_file):
    user.open(ball_file)
    action = user.window.actions_["panel_Methods"]
    assert action.isChecked()
    action.trigger()
    assert user.denoise.docks[1].isHidden()
    user.press(Qt.Key.Key_2, CONTROL)
    user.press(Qt.Key.Key_1, CONTROL)
    assert not action.isChecked()
    user.window.actions_["reset_panels"].trigger()
    assert action.isChecked()


def test_a_floating_panel_goes_and_comes_with_its_tab(user, ball_file):
    user.open(ball_file)
    panel, closed = user.denoise.docks[2:]
    panel.setFloating(True)
    closed.setFloating(True)
    closed.close()
    user.press(Qt.Key.Key_2, CONTROL)
    assert panel.isHidden()
    user.press(Qt.Key.Key_3, CONTROL)
    user.press(Qt.Key.Key_1, CONTROL)
    assert panel.isVisible()
    assert closed.isHidden()
    user.press(Qt.Key.Key_2, CONTROL)
    user.window.files.discard_changes()
    user.window.close()
    user.denoise.restoreState(QSettings().value("denoise_layout"))
    assert not panel.isHidden()
