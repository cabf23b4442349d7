"""Commands by name and by key, cameras, help, the empty window, panels and colours."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QKeySequence
from PySide6.QtWidgets import QApplication, QInputDialog, QMessageBox, QTextBrowser, QToolBar

from app.scene.camera import CameraPose
from app.ui.actions import COMMANDS
from app.ui.command_list import entries
from app.ui.palette import CommandPalette

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier


def palette(user):
    user.press(Qt.Key.Key_P, CONTROL | SHIFT)
    return user.window.findChildren(CommandPalette)[-1]


def test_every_command_has_a_place_a_name_and_a_tip():
    assert len({command.id for command in COMMANDS}) == len(COMMANDS)
    assert all(command.menu and command.text and command.tip for command in COMMANDS)
    keys = [QKeySequence(command.key) for command in COMMANDS if command.key]
    assert len({key.toString() for key in keys}) == len(keys)


def test_the_palette_lists_commands_choices_and_presets_once(user):
    paths = [entry.path for entry in entries(user.window)]
    assert len(paths) == len(set(paths))
    for path in ("File › Export › Figure", "View › Colour by › Normal angle",
                 "View › Look From › Top (+Y)", "View › Theme › Dark"):  # fmt: skip
        assert path in paths


def test_the_palette_runs_what_a_few_letters_find(user, ball_file, qtbot):
    user.open(ball_file)
    dialog = palette(user)
    qtbot.keyClicks(dialog.line, "norm ang")
    assert dialog.model.entries[0].name == "Normal angle"
    qtbot.keyClick(dialog.line, Qt.Key.Key_Return)
    user.wait(lambda: user.window.session.study.view.colour == "normal_angle")


def test_the_palette_does_not_run_what_is_impossible_now(user, qtbot):
    dialog = palette(user)
    qtbot.keyClicks(dialog.line, "export figure")
    assert dialog.model.entries[0].name == "Figure"
    qtbot.keyClick(dialog.line, Qt.Key.Key_Return)
    assert dialog.isVisible()
    assert dialog.told.text().endswith("Not now: Open a model first.")
    dialog.line.setText("zzz")
    assert dialog.told.text() == "No command fits what is typed."
    qtbot.keyClick(dialog.line, Qt.Key.Key_Return)
    dialog.close()


def test_the_palette_outlives_a_menu_that_is_filled_anew_by_what_was_chosen(user, ball_file, qtbot):
    """The list asks for the entry once more when its action has been deleted."""
    user.open(ball_file)
    dialog = palette(user)
    names = [(*entry.menus, entry.name) for entry in dialog.model.entries]
    index = dialog.model.index(names.index(("View", "Compare Panes", "With", "Noisy input")))
    chosen = dialog.model.entries[index.row()]
    dialog.list.scrollTo(index)
    place = dialog.list.visualRect(index).center()
    qtbot.mouseClick(dialog.list.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert not dialog.isVisible()
    user.rest()
    chosen.run()  # does nothing, whether or not its action is still there


def test_a_camera_is_copied_and_pasted(user, ball_file):
    user.open(ball_file)
    viewport = user.denoise.viewport
    before = viewport.pose
    user.press(Qt.Key.Key_C, CONTROL | ALT)
    text = QGuiApplication.clipboard().text()
    user.press(Qt.Key.Key_6)
    assert viewport.pose != before
    QGuiApplication.clipboard().setText(text)
    user.press(Qt.Key.Key_V, CONTROL | ALT)
    assert np.array(viewport.pose) == pytest.approx(np.array(before))
    assert CameraPose.of(viewport.grid.renderer("mean").GetActiveCamera()) == viewport.pose


def test_pasting_something_else_is_one_sentence(user, ball_file):
    user.open(ball_file)
    QGuiApplication.clipboard().setText("hello")
    user.press(Qt.Key.Key_V, CONTROL | ALT)
    boxes = [b for b in user.window.findChildren(QMessageBox) if b.isVisible()]
    assert "This text is no camera" in boxes[0].text()
    boxes[0].close()


def test_a_camera_is_saved_by_name_with_the_study(user, ball_file, qtbot):
    user.open(ball_file)
    before = user.denoise.viewport.pose
    user.press(Qt.Key.Key_S, CONTROL | ALT)
    dialog = user.window.findChild(QInputDialog)
    dialog.setTextValue("My side")
    dialog.accept()
    assert "“My side” stands in View" in user.window.statusBar().currentMessage()
    user.press(Qt.Key.Key_6)
    menu = user.window.actions_.menu("View/&Cameras")
    next(a for a in menu.actions() if a.text() == "My side").trigger()
    assert np.array(user.denoise.viewport.pose) == pytest.approx(np.array(before))
    assert user.window.session.study.view.cameras[0].name == "My side"
    user.window.session.undo()
    assert "My side" not in [a.text() for a in menu.actions()]


def choose_camera(user, title, name):
    dialogs = [d for d in user.window.findChildren(QInputDialog) if d.isVisible()]
    assert [d.windowTitle() for d in dialogs] == [title]
    dialogs[0].setTextValue(name)
    verb = title.split()[0]
    user.qtbot.mouseClick(user.button(dialogs[0], verb), Qt.MouseButton.LeftButton)


def test_saved_cameras_are_restored_and_forgotten_by_commands(user, ball_file, qtbot):
    user.open(ball_file)
    book, viewport = user.window.actions_, user.denoise.viewport
    assert "No camera has been saved" in book["restore_camera"].toolTip()
    poses = {}
    for name, key in (("Side", Qt.Key.Key_6), ("Above", Qt.Key.Key_3)):
        user.press(key)
        poses[name] = viewport.pose
        user.press(Qt.Key.Key_S, CONTROL | ALT)
        choose_camera(user, "Save the camera", name)
    user.press(Qt.Key.Key_R, CONTROL | ALT)
    choose_camera(user, "Restore a camera", "Side")
    assert np.array(viewport.pose) == pytest.approx(np.array(poses["Side"]))
    dialog = palette(user)
    qtbot.keyClicks(dialog.line, "above")
    assert dialog.model.entries[0].path == "View › Cameras › Above"
    qtbot.keyClick(dialog.line, Qt.Key.Key_Return)
    assert np.array(viewport.pose) == pytest.approx(np.array(poses["Above"]))
    book["forget_camera"].trigger()
    choose_camera(user, "Forget a camera", "Side")
    assert [camera.name for camera in user.window.session.study.view.cameras] == ["Above"]


def test_the_empty_window_tells_what_to_do(user):
    panels, tabs = user.window.empty_panels, user.window.tabs
    for place, panel in enumerate(panels):
        tabs.setCurrentIndex(place)
        assert panel.isVisible()
        assert panel.rect() == panel.parent().rect()
        widest = max(button.geometry().right() for button in panel.buttons.values())
        assert widest < panel.width()
    tabs.setCurrentIndex(0)
    panels[0].buttons["double_torus"].click()
    user.rest()
    assert all(panel.isHidden() for panel in panels)
    assert user.captions()["mean"].startswith("k = 6 ")


def test_the_first_start_shows_the_bundled_model_compared(user):
    user.window.open_model("sample:creature")
    user.rest()
    assert len(user.captions()) == 7


def test_help_opens_at_the_entry_of_the_place(user, ball_file):
    user.open(ball_file)
    user.denoise.methods.blocks["bilateral"].help.click()
    page = user.window.findChildren(QTextBrowser)[-1]
    top = page.cursorForPosition(page.rect().topLeft()).block()
    heading = top if top.text() else top.next()
    assert heading.text() == "Bilateral"
    page.window().close()


def test_panels_are_put_back(user, ball_file):
    user.open(ball_file)
    dock = user.denoise.docks[0]
    dock.close()
    user.denoise.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, user.denoise.docks[3])
    menu = user.window.actions_.menu("View/P&anels")
    menu.aboutToShow.emit()
    assert [a.isChecked() for a in menu.actions()[:4]] == [False, True, True, True]
    menu.actions()[-1].trigger()
    assert dock.isVisible()
    areas = [user.denoise.dockWidgetArea(d) for d in user.denoise.docks]
    assert areas[3] == Qt.DockWidgetArea.BottomDockWidgetArea


def test_no_menu_of_the_right_button_hides_the_toolbar(user, qtbot):
    bar = user.window.findChild(QToolBar)
    place = bar.rect().center()
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, place, bar.mapToGlobal(place))
    QApplication.sendEvent(bar, event)
    assert QApplication.activePopupWidget() is None


def test_panels_come_back_where_they_were_after_a_restart(user, ball_file, qtbot):
    from app.ui.main_window import MainWindow

    user.open(ball_file)
    user.denoise.docks[2].close()
    user.denoise.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, user.denoise.docks[1])
    user.denoise.save_layout()
    second = MainWindow()
    second.resize(1280, 800)
    second.show()
    try:
        user.wait(lambda: not second.denoise.docks[2].isVisible())
        area = second.denoise.dockWidgetArea(second.denoise.docks[1])
        assert area == Qt.DockWidgetArea.LeftDockWidgetArea
    finally:
        second.close()
        second.deleteLater()


def test_text_in_the_panes_is_scaled_once(user, ball_file):
    user.open(ball_file)
    assert user.denoise.viewport.interactor.render_window.GetDPI() == 72


def test_every_entry_but_those_of_the_study_and_the_files_is_declared(user, ball_file):
    user.open(ball_file)
    declared = {command.id for command in COMMANDS}
    changing = {"Cameras", "Open Recent"}
    for entry in entries(user.window):
        assert entry.action.objectName() in declared or changing & set(entry.menus), entry.path


def test_a_sample_opens_from_the_palette(user, qtbot):
    dialog = palette(user)
    qtbot.keyClicks(dialog.line, "double torus")
    qtbot.keyClick(dialog.line, Qt.Key.Key_Return)
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
