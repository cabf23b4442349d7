"""Recent files, the memory budget, and the study as text to copy."""

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QApplication, QMessageBox

from app.cli import main
from app.session.memory import default_budget, machine_memory
from app.ui.preferences import PreferencesDialog
from app.ui.preferences_general import GeneralPage, kept_budget
from app.ui.thumbnails import thumbnail
from core.comparison import run

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton


def drawn_width(menu, entry):
    """How much of the width left of an entry's text is drawn on, in pixels."""
    image = menu.grab(menu.actionGeometry(entry)).toImage()
    ground = image.pixel(1, 1)
    columns, rows = range(min(64, image.width())), range(image.height())
    drawn = [x for x in columns if any(image.pixel(x, y) != ground for y in rows)]
    return (drawn[-1] - drawn[0]) if drawn else 0


def answer_reset(user, page, word):
    user.qtbot.mouseClick(page.reset_button, LEFT)
    box = page.findChildren(QMessageBox)[-1]
    assert box.text() == "Reset everything to defaults?"
    user.qtbot.mouseClick(user.button(box, word), LEFT)


def test_recent_files_have_pictures_and_open_again(user, ball_file):
    recent = user.window.files.recent
    assert not recent.menu.menuAction().isEnabled()
    user.open(ball_file)
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    user.rest()
    assert recent.names == [str(ball_file)]
    user.window.open_model(str(ball_file))
    user.wait(lambda: user.window.windowTitle().startswith("ball"))
    user.wait(thumbnail(str(ball_file)).exists)
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    recent.menu.popup(user.window.pos())
    entry = recent.menu.actions()[0]
    assert entry.text() == "ball.ply"
    assert drawn_width(recent.menu, entry) > 30
    recent.menu.close()
    entry.trigger()
    user.wait(lambda: user.window.windowTitle().startswith("ball.ply"))
    recent.menu.actions()[-1].trigger()
    assert recent.names == []


def test_the_memory_budget_is_a_preference_and_is_kept(user, ball_file):
    user.open(ball_file)
    assert kept_budget() == default_budget()
    assert default_budget() <= machine_memory() // 4
    user.press(Qt.Key.Key_Comma, CONTROL)
    page = user.window.findChild(PreferencesDialog).findChild(GeneralPage)
    page.budget.setFocus()
    page.budget.selectAll()
    user.qtbot.keyClicks(page.budget, "100")
    user.qtbot.keyClick(page.budget, Qt.Key.Key_Return)
    assert kept_budget() == 100 * 1024**2
    assert user.window.session.budget == 100 * 1024**2
    answer_reset(user, page, "Cancel")
    assert user.window.session.budget == 100 * 1024**2
    answer_reset(user, page, "Reset")
    assert user.window.session.budget == default_budget()
    assert QSettings().value("recent_files") is None


def test_the_study_as_command_line_and_script_can_be_copied(user, ball_file, capsys):
    user.open(ball_file)
    user.type_iterations("mean", 2)
    user.rest()
    user.window.actions_["copy_command"].trigger()
    words = QApplication.clipboard().text().split()
    with pytest.raises(SystemExit):
        main([*words[1:], "--json"])
    assert '"mean", "iterations": 2' in capsys.readouterr().out
    user.window.actions_["copy_script"].trigger()
    exec(compile(QApplication.clipboard().text(), "script", "exec"), {})
    error = run(user.window.session.study).methods[1].errors["visual_error"][2]
    assert f"mean visual_error={error!r}" in capsys.readouterr().out


def test_a_name_with_an_ampersand_stands_in_the_undo_step_as_it_is(user, ball_file, tmp_path):
    odd = tmp_path / "R&D.ply"
    odd.write_bytes(ball_file.read_bytes())
    user.open(ball_file)
    user.open(odd)
    assert user.window.actions_["undo"].text() == "&Undo Open R&&D.ply"
