"""Studies as files: saved, opened, asked for, kept through a kill."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QMessageBox

from app.ui.restoring import offer_leftovers
from core.comparison import run
from core.io import save_mesh
from core.mesh import primitives
from core.study import Study
from core.study_files import read_study_file, write_study_file

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
NONE = Qt.KeyboardModifier.NoModifier


def question(user):
    boxes = lambda: [b for b in user.window.findChildren(QMessageBox) if b.isVisible()]  # noqa: E731
    user.wait(boxes)
    return boxes()[-1]


def answer(user, word):
    """Click the button of the open question whose text has a word; return what was asked."""
    box = question(user)
    text = box.text()
    button = next(b for b in box.buttons() if word in b.text().replace("&", ""))
    user.qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    return text


def save_as(user, path):
    user.press(Qt.Key.Key_S, CONTROL | SHIFT)
    user.answer_file_dialog(path)
    user.wait(lambda: user.window.windowTitle().startswith(f"{path.name} "))


@pytest.fixture
def saved(user, ball_file, tmp_path):
    """The window with a study of nine mean iterations, saved."""
    user.open(ball_file)
    user.type_iterations("mean", 9)
    user.rest()
    path = tmp_path / "first.burnish"
    save_as(user, path)
    return path


def open_study(user, path):
    user.window.activateWindow()
    user.wait(user.window.isActiveWindow)
    user.press(Qt.Key.Key_O, CONTROL)
    user.answer_file_dialog(path)


def test_the_title_shows_the_file_and_what_is_not_saved(user, saved):
    assert user.window.windowTitle() == "first.burnish – ball.ply – Burnish"
    user.type_iterations("mean", 10)
    user.rest()
    assert user.window.windowTitle() == "first.burnish* – ball.ply – Burnish"
    user.press(Qt.Key.Key_Z, CONTROL)
    assert user.window.windowTitle() == "first.burnish – ball.ply – Burnish"
    user.press(Qt.Key.Key_Z, CONTROL | SHIFT)
    user.press(Qt.Key.Key_S, CONTROL)
    user.wait(lambda: user.window.windowTitle() == "first.burnish – ball.ply – Burnish")
    assert read_study_file(saved).study.choice("mean").iterations == 10


def test_what_was_saved_opens_again_with_the_same_numbers(user, saved, ball_file, tmp_path):
    shown = user.window.session.run("mean").errors[9]["visual_error"]
    other = tmp_path / "other.ply"
    save_mesh(primitives.torus(), other)
    user.open(other)
    user.type_iterations("mean", 2)
    user.rest()
    open_study(user, saved)
    assert "Save the changes to the study of other.ply?" in answer(user, "Discard")
    user.wait(lambda: user.window.windowTitle() == "first.burnish – ball.ply – Burnish")
    user.rest()
    assert user.captions()["mean"].startswith("k = 9 ")
    assert user.window.session.run("mean").errors[9]["visual_error"] == shown
    study = read_study_file(saved).locate(tmp_path)
    result = next(m for m in run(study).methods if m.choice.method == "mean")
    assert result.errors["visual_error"][9] == shown


def test_undo_across_an_opening_brings_the_other_file_back(user, saved, tmp_path):
    second = tmp_path / "second.burnish"
    write_study_file(Study(model="sample:double_torus"), second)
    open_study(user, second)
    user.wait(lambda: user.window.windowTitle().startswith("second.burnish "))
    user.rest()
    user.press(Qt.Key.Key_Z, CONTROL)
    user.wait(lambda: user.window.windowTitle() == "first.burnish – ball.ply – Burnish")
    user.press(Qt.Key.Key_Z, CONTROL | SHIFT)
    user.wait(lambda: user.window.windowTitle().startswith("second.burnish "))


def test_a_missing_model_is_asked_for(user, saved, ball_file, tmp_path):
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    moved = tmp_path / "moved.ply"
    ball_file.rename(moved)
    open_study(user, saved)
    assert "Choose" in question(user).defaultButton().text()
    assert "its model ball.ply is not at" in answer(user, "Choose")
    user.answer_file_dialog(moved)
    user.wait(lambda: "moved.ply" in user.window.windowTitle())
    assert user.window.windowTitle().startswith("first.burnish ")


def test_a_changed_model_is_asked_about(user, saved, ball_file):
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    save_mesh(primitives.torus(), ball_file)
    open_study(user, saved)
    assert "not the one the study was saved with" in answer(user, "Cancel")
    assert user.window.windowTitle().startswith("double_torus")
    open_study(user, saved)
    answer(user, "anyway")
    user.wait(lambda: user.window.windowTitle().startswith("first.burnish"))
    user.rest()
    assert user.captions()["original"] == "576 faces"


def test_a_packed_study_needs_no_model(user, ball_file, tmp_path):
    user.open(ball_file)
    path = tmp_path / "all.burnish"
    user.window.actions_["save_packed"].trigger()
    user.answer_file_dialog(path)
    user.wait(lambda: user.window.windowTitle().startswith("all.burnish "))
    ball_file.unlink()
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    open_study(user, path)
    user.wait(lambda: user.window.windowTitle() == "all.burnish – ball.ply – Burnish")
    user.type_iterations("mean", 3)
    user.press(Qt.Key.Key_S, CONTROL)
    user.wait(lambda: user.window.windowTitle() == "all.burnish – ball.ply – Burnish")
    assert read_study_file(path).packed


def test_a_study_can_be_dropped_on_the_window(user, saved):
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(saved))])
    where, what = QPointF(100, 100), Qt.DropAction.CopyAction
    user.window.dropEvent(QDropEvent(where, what, data, Qt.MouseButton.LeftButton, NONE))
    user.wait(lambda: user.window.windowTitle().startswith("first.burnish "))


def test_a_bad_study_is_one_sentence_and_all_stays(user, saved, tmp_path):
    bad = tmp_path / "bad.burnish"
    bad.write_text(saved.read_text().replace('"version": 2', '"version": 9'))
    open_study(user, bad)
    assert "was written by a newer Burnish" in answer(user, "OK")
    assert user.window.windowTitle() == "first.burnish – ball.ply – Burnish"


def test_closing_asks_and_cancel_keeps_the_window(user, saved):
    user.type_iterations("mean", 4)
    user.rest()
    user.window.close()
    assert "Save the changes to first.burnish?" in answer(user, "Cancel")
    assert user.window.isVisible()
    user.window.close()
    answer(user, "Save")
    user.wait(lambda: not user.window.isVisible())
    assert read_study_file(saved).study.choice("mean").iterations == 4


def test_closing_an_unnamed_study_asks_for_its_name(user, ball_file, tmp_path):
    user.open(ball_file)
    user.type_iterations("mean", 4)
    user.rest()
    user.window.close()
    assert "the study of ball.ply" in answer(user, "Save")
    user.answer_file_dialog(tmp_path / "new")
    user.wait(lambda: not user.window.isVisible())
    assert read_study_file(tmp_path / "new.burnish").study.choice("mean").iterations == 4


def test_nothing_is_asked_where_nothing_was_done(user, ball_file):
    user.open(ball_file)
    user.press(Qt.Key.Key_W)
    user.window.close()
    assert not user.window.isVisible()


def test_only_what_would_be_lost_is_kept_to_restore(user, ball_file, tmp_path):
    def kept():
        user.window.files.autosave.write()
        return list((tmp_path / "state").rglob("study.json"))

    user.open(ball_file)
    assert not kept()
    user.window.actions_["edges"].trigger()  # no work to be asked about, yet lost in a crash
    assert not user.window.files.documents.is_modified
    assert kept()
    save_as(user, tmp_path / "first.burnish")
    assert not kept()
    user.type_iterations("mean", 9)
    assert kept()


def test_closing_leaves_nothing_to_restore(user, saved, tmp_path):
    user.type_iterations("mean", 7)
    user.window.files.autosave.write()
    assert list((tmp_path / "state").rglob("study.json"))
    user.window.files.discard_changes()
    user.window.close()
    assert not list((tmp_path / "state").rglob("study.json"))


def test_changes_are_kept_within_seconds(user, saved, tmp_path):
    started = time.monotonic()
    user.type_iterations("mean", 7)

    def kept():
        files = list((tmp_path / "state").rglob("study.json"))
        text = json.loads(files[0].read_text())["study"] if files else ""
        return '"iterations": 7' in text

    user.wait(kept)
    assert time.monotonic() - started < 6


_PROGRAM = """
import sys
from PySide6.QtCore import QCoreApplication, QSettings, QTimer
QSettings.setDefaultFormat(QSettings.Format.IniFormat)
QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, sys.argv[2])
from app.ui import main_window
shown = main_window.MainWindow.show

def show(window):
    shown(window)
    def change():
        session = window.session
        if session.meshes is None or session.activity is not None:
            return QTimer.singleShot(50, change)
        choice = session.study.choice("mean").model_copy(update={"iterations": 23})
        session.apply(session.study.with_choice(choice), "Iterations")
    QTimer.singleShot(50, change)

main_window.MainWindow.show = show
from app.ui.application import start
start(sys.argv[1])
"""


@pytest.fixture
def killed(ball_file, tmp_path):
    """A session that was killed after its study was kept."""
    state = tmp_path / "state"
    environment = {**os.environ, "XDG_STATE_HOME": str(state),
                   "XDG_CACHE_HOME": str(tmp_path / "cache")}  # fmt: skip
    words = [sys.executable, "-c", _PROGRAM, str(ball_file), str(tmp_path / "other settings")]
    program = subprocess.Popen(words, env=environment)
    end = time.monotonic() + 60
    while '\\"iterations\\": 23' not in "".join(p.read_text() for p in state.rglob("study.json")):
        assert time.monotonic() < end
        assert program.poll() is None
        time.sleep(0.1)
    yield program
    if program.poll() is None:
        program.send_signal(signal.SIGKILL)
        program.wait()


def test_after_a_kill_the_next_start_offers_what_was_open(killed, user, tmp_path):
    offer_leftovers(user.window)
    assert not user.window.findChildren(QMessageBox)  # it still runs
    killed.send_signal(signal.SIGKILL)
    killed.wait()
    offer_leftovers(user.window)
    assert "while ball.ply was open" in answer(user, "Restore")
    user.wait(lambda: user.window.windowTitle() == "ball.ply* – Burnish")
    user.rest()
    assert user.captions()["mean"].startswith("k = 23 ")
    kept = list((tmp_path / "state").rglob("study.json"))
    assert [path.parent for path in kept] == [user.window.files.autosave.folder]


def test_what_a_crash_left_can_be_thrown_away(user, saved, tmp_path):
    kept = user.window.files.autosave
    user.type_iterations("mean", 7)
    kept.write()
    left = kept.folder.with_name("left")
    left.mkdir()
    (left / "study.json").write_bytes((kept.folder / "study.json").read_bytes())
    offer_leftovers(user.window)
    assert "while first.burnish was open" in answer(user, "Discard")
    user.wait(lambda: not left.exists())
    assert kept.folder.exists()


def test_what_a_crash_left_broken_is_passed_over(user, saved):
    left = user.window.files.autosave.folder.with_name("left")
    left.mkdir()
    (left / "study.json").write_text('{"study": "{", "document": null')
    offer_leftovers(user.window)
    assert not user.window.findChildren(QMessageBox)
