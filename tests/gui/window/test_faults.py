"""What happens when something breaks inside the program."""

import logging
import threading

import pytest
from PySide6.QtCore import Qt, QTimer, qWarning
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QApplication, QMessageBox

from app.logs import log_file, start_logging
from app.ui.faults import plain_words
from core.smoothing import METHODS
from core.study_files import read_study_file

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton


def boxes(user):
    return [box for box in user.window.findChildren(QMessageBox) if box.isVisible()]


@pytest.fixture
def faults(user, monkeypatch):
    """The window's fault reports in place of those of the tests."""
    user.window.faults.install()
    yield user.window.faults
    user.window.faults.uninstall()


def test_an_unexpected_error_is_told_and_the_session_goes_on(user, ball_file, faults):
    user.open(ball_file)
    study = user.window.session.study

    def fail(mesh, params):
        yield mesh.vertices
        raise RuntimeError("the kernel is on fire")

    spec = METHODS["laplacian"]
    METHODS["laplacian"] = type(spec)(**{**vars(spec), "steps": fail})
    try:
        check = user.denoise.methods.blocks["laplacian"].check
        user.qtbot.mouseClick(check, LEFT, pos=check.rect().center() * 0.1)
        check.setChecked(True)
        user.wait(lambda: boxes(user))
    finally:
        METHODS["laplacian"] = spec
    box = boxes(user)[0]
    assert box.text() == "Something went wrong inside Burnish."
    assert "the kernel is on fire" in box.informativeText()
    assert "Traceback" not in box.informativeText()
    assert str(log_file()) in box.informativeText()
    user.qtbot.mouseClick(user.button(box, "Copy details"), LEFT)
    details = QApplication.clipboard().text()
    assert "Traceback" in details
    assert "numpy " in details
    assert box.isVisible()
    user.qtbot.mouseClick(user.button(box, "Close"), LEFT)
    user.window.session.undo()
    assert user.window.session.study == study
    user.rest()


def test_after_an_error_in_a_slot_the_study_is_whole_and_can_be_saved(
    user, ball_file, faults, tmp_path, monkeypatch
):
    opened, file = [], tmp_path / "after.burnish"
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url) or True)
    user.open(ball_file)
    study = user.window.session.study

    def stumble():
        raise ZeroDivisionError("a slot stumbled")

    QTimer.singleShot(0, stumble)
    user.wait(lambda: boxes(user))
    box = boxes(user)[0]
    assert "ZeroDivisionError: a slot stumbled" in box.informativeText()
    assert "Your study is as it was" in box.informativeText()
    user.qtbot.mouseClick(user.button(box, "Show the log"), LEFT)
    assert [url.toLocalFile() for url in opened] == [str(log_file())]
    assert box.isVisible()
    user.qtbot.keyClick(box, Qt.Key.Key_Escape)
    user.wait(lambda: not boxes(user))
    assert user.window.session.study is study

    user.window.activateWindow()
    user.wait(user.window.isActiveWindow)
    user.type_iterations("mean", 3)
    user.rest()
    user.press(Qt.Key.Key_S, CONTROL)
    user.answer_file_dialog(file)
    user.wait(lambda: "*" not in user.window.windowTitle())
    saved = read_study_file(file).study
    assert saved.choice("mean").iterations == 3
    assert saved.noise == study.noise


def test_without_a_program_for_it_the_place_of_the_log_is_told(user, monkeypatch):
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda _: False)
    user.window.actions_["log"].trigger()
    assert str(log_file()) in boxes(user)[0].text()
    boxes(user)[0].close()


def test_a_long_error_ends_between_two_words():
    told = plain_words(RuntimeError("no implementation found " * 40)).splitlines()[0]
    assert told.endswith((" implementation …", " found …", " no …"))
    assert len(told) < 230


def test_an_error_of_another_place_is_told_when_the_first_was_read(user, faults):
    def report(error):
        try:
            raise error
        except LookupError as raised:
            faults.report(raised)

    report(KeyError("first"))
    user.wait(lambda: boxes(user))
    report(KeyError("first"))
    user.qtbot.mouseClick(user.button(boxes(user)[0], "Close"), LEFT)
    user.wait(lambda: not boxes(user))
    try:
        raise IndexError("second")
    except IndexError as raised:
        faults.report(raised)
    user.wait(lambda: boxes(user))
    assert "second" in boxes(user)[0].informativeText()


def test_errors_in_threads_are_told_once(user, ball_file, faults, caplog):
    user.open(ball_file)

    def fail():
        raise LookupError("lost in a thread")

    with caplog.at_level(logging.INFO):
        for _ in range(3):
            thread = threading.Thread(target=fail)
            thread.start()
            thread.join()
        user.wait(lambda: boxes(user))
        qWarning("a word from Qt")
    assert len(boxes(user)) == 1
    assert "lost in a thread" in boxes(user)[0].informativeText()
    assert caplog.text.count("LookupError: lost in a thread") == 3
    assert "a word from Qt" in caplog.text


def test_the_log_is_a_file_of_bounded_size(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    root = logging.getLogger()
    before, level = list(root.handlers), root.level
    try:
        start_logging()
        for _ in range(300):
            logging.getLogger("test").info("x" * 20_000)
        sizes = [path.stat().st_size for path in log_file().parent.iterdir()]
        assert log_file().read_text().count("INFO test")
        assert sum(sizes) < 5_000_000
    finally:
        root.setLevel(level)
        for handler in set(root.handlers) - set(before):
            root.removeHandler(handler)
            handler.close()
