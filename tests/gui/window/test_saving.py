"""Where the window saves: names that are completed, folders that are proposed, questions asked."""

from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtWidgets import QApplication, QLineEdit, QMessageBox

from app.ui.dialogs import remember_folder
from core.study_files import read_study_file

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
LEFT = Qt.MouseButton.LeftButton


def save(user, command, path):
    user.window.actions_[command].trigger()
    user.answer_file_dialog(path)


def proposed(user, command):
    """Folder in which a dialog begins."""
    user.window.actions_[command].trigger()
    dialog = user.file_dialogs()[0]
    folder = dialog.directory().absolutePath()
    dialog.reject()
    user.wait(lambda: not user.file_dialogs())
    return folder


def answer(user, word):
    """Click a button of the open question; return what was asked."""
    boxes = lambda: [b for b in user.window.findChildren(QMessageBox) if b.isVisible()]  # noqa: E731
    user.wait(boxes)
    box = boxes()[-1]
    text = box.text()
    user.qtbot.mouseClick(user.button(box, word), LEFT)
    return text


def show_statistics(user, model):
    user.open(model)
    tab = user.window.statistics
    user.window.tabs.setCurrentWidget(tab)
    user.wait(lambda: tab.work.summaries() and tab.work.activity is None)


def said(user):
    return user.window.statusBar().currentMessage()


def test_an_ending_that_is_none_gets_that_of_the_chosen_type(user, ball_file, folder):
    user.open(ball_file)
    for command, typed, written in (
        ("save_plot", "errors_0.02", "errors_0.02.svg"),
        ("save_table", "TABLE.TXT", "TABLE.TXT"),
        ("save_mesh", "ball.v2", "ball.v2.ply"),
        ("save_study_as", "study.json", "study.json.burnish"),
    ):
        save(user, command, folder / typed)
        user.wait(lambda written=written: said(user) == f"Saved {written}.")
    assert (folder / "errors_0.02.svg").read_text().startswith("<?xml")
    assert (folder / "ball.v2.ply").read_bytes().startswith(b"ply")
    assert read_study_file(folder / "study.json.burnish").study.model.endswith("ball.ply")


def test_a_completed_name_that_is_taken_is_asked_about(user, ball_file, folder):
    user.open(ball_file)
    taken = folder / "errors_0.02.svg"
    taken.write_text("old")
    save(user, "save_plot", folder / "errors_0.02")
    assert answer(user, "Cancel") == "errors_0.02.svg already exists."
    assert not user.window.session.tasks.states()
    assert taken.read_text() == "old"
    save(user, "save_plot", folder / "errors_0.02")
    answer(user, "Replace")
    user.wait(lambda: said(user) == "Saved errors_0.02.svg.")
    assert taken.read_text() != "old"


def test_a_dialog_begins_where_the_work_is(user, ball_file, folder, tmp_path):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(ball_file)), QUrl.fromLocalFile(str(folder))])
    assert user.window.files.drop(data)
    assert said(user) == "Only ball.ply is opened: one file at a time."
    user.rest()
    assert proposed(user, "save_mesh") == str(tmp_path)
    save(user, "save_study_as", folder / "a.burnish")
    user.wait(lambda: said(user) == "Saved a.burnish.")
    remember_folder(str(tmp_path / "elsewhere" / "b.ply"))
    assert proposed(user, "save_study_as") == str(folder)


def test_what_cannot_be_dropped_is_told(user, folder):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(folder))])
    assert not user.window.files.may_drop(data)
    assert "a model or a study" in said(user)


def test_statistics_go_into_a_new_folder(user, ball_file, folder):
    show_statistics(user, ball_file)
    user.window.actions_["save_statistics"].trigger()
    dialog = user.file_dialogs()[0]
    line, choose = dialog.findChild(QLineEdit), user.button(dialog, "Choose")
    assert line.text() == "ball_statistics"
    assert choose.isEnabled()
    QApplication.clipboard().setText(str(folder / "new" / "ball"))
    line.selectAll()
    line.paste()
    user.qtbot.mouseClick(choose, LEFT)
    user.wait((folder / "new" / "ball" / "figure.png").exists)


def test_statistics_are_not_put_into_a_filled_folder_unasked(user, ball_file, folder):
    show_statistics(user, ball_file)
    mine = folder / "figure.png"
    mine.write_bytes(b"mine")
    save(user, "save_statistics", folder)
    assert "folder out is not empty" in answer(user, "Cancel")
    assert not [s for s in user.window.session.tasks.states() if "Statistics" in s.title]
    assert mine.read_bytes() == b"mine"
