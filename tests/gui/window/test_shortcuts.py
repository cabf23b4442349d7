"""The sheet of shortcuts, and keys that are changed in the preferences."""

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QKeySequence

from app.ui.actions import COMMANDS
from app.ui.preferences import open_preferences
from app.ui.shortcut_sheet import ShortcutPage, ShortcutSheet

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_the_sheet_of_shortcuts_is_searched_by_name_and_key(user, qtbot):
    user.press(Qt.Key.Key_Question)
    sheet = user.window.findChild(ShortcutSheet)
    qtbot.keyClicks(sheet.table.search, "ctrl+z")
    shown = [c.id for c in COMMANDS if not sheet.table.items[c.id].isHidden()]
    assert shown == ["undo"]
    for word, command in (
        ("swipe", "swipe"), ("noisy input", "compare_noisy"), ("restore camera", "restore_camera"),
    ):  # fmt: skip
        sheet.table.search.setText(word)
        assert not sheet.table.items[command].isHidden()
    assert sheet.table.nothing.isHidden()
    sheet.table.search.setText("zzz")
    assert sheet.table.nothing.isVisible()
    sheet.close()


def keyboard_page(user):
    return open_preferences(user.window, "Keyboard").findChild(ShortcutPage)


def test_a_key_is_changed_kept_and_reset(user, ball_file, window):
    user.open(ball_file)
    page = keyboard_page(user)
    page.table.tree.setCurrentItem(page.table.items["difference"])
    page.editor.setKeySequence(QKeySequence("K"))
    page.window().close()
    user.press(Qt.Key.Key_H)
    assert user.window.session.study.view.colour == "none"
    user.press(Qt.Key.Key_K)
    assert user.window.session.study.view.colour == "vertex_rms"
    assert QSettings().value("shortcuts/difference") == "K"
    assert user.window.actions_["difference"].toolTip().endswith("(K)")
    page = keyboard_page(user)
    page.reset_button.click()
    page.window().close()
    assert user.window.actions_["difference"].shortcut().toString() == "H"
    assert QSettings().value("shortcuts/difference") is None


def test_a_key_that_is_taken_is_refused_and_named(user, qtbot):
    page, edges = keyboard_page(user), user.window.actions_["edges"]
    page.table.tree.setCurrentItem(page.table.items["edges"])
    for key, refused in ((Qt.Key.Key_Z, True), (Qt.Key.Key_K, False), (Qt.Key.Key_S, True)):
        qtbot.keyClick(page.editor, key, CONTROL)
        user.wait(lambda refused=refused: ("belongs to" in page.message.text()) is refused)
        kept = "W" if key == Qt.Key.Key_Z else "Ctrl+K"
        assert edges.shortcut().toString() == kept
        user.wait(lambda kept=kept: page.editor.keySequence().toString() == kept)
    assert "belongs to “Save Study”" in page.message.text()
    page.remove_button.click()
    assert edges.shortcut().isEmpty()
    page.window().close()


@pytest.mark.parametrize(
    ("command", "key"),
    [("theme_dark", "F7"), ("colour_normal_angle", "F8"), ("panel_Methods", "F9")],
)
def test_choices_and_panels_can_have_keys(user, ball_file, command, key):
    user.open(ball_file)
    page = keyboard_page(user)
    page.table.tree.setCurrentItem(page.table.items[command])
    page.editor.setKeySequence(QKeySequence(key))
    page.window().close()
    before = user.window.actions_[command].isChecked()
    user.press(getattr(Qt.Key, f"Key_{key}"))
    assert user.window.actions_[command].isChecked() is not before
