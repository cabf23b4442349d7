"""Recent files, gallery, preferences, and what happens when something breaks."""

import logging
import threading
import time
from urllib.error import URLError

import pytest
from PySide6.QtCore import QSettings, Qt, QTimer, qWarning
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QApplication, QMessageBox, QPushButton

from app.cli import main
from app.logs import log_file, start_logging
from app.session.memory import default_budget, machine_memory
from app.ui import downloads
from app.ui.gallery import GalleryDialog
from app.ui.preferences import PreferencesDialog
from app.ui.preferences_general import GeneralPage, kept_budget
from app.ui.thumbnails import thumbnail
from core.comparison import run
from core.smoothing import METHODS
from core.study_files import read_study_file

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton


def boxes(user):
    return [box for box in user.window.findChildren(QMessageBox) if box.isVisible()]


def button(parent, word):
    found = parent.findChildren(QPushButton)
    return next(b for b in found if word in b.text().replace("&", ""))


def gallery(user):
    user.press(Qt.Key.Key_G, CONTROL)
    user.wait(lambda: user.window.findChild(GalleryDialog))
    return user.window.findChild(GalleryDialog)


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
    assert not entry.icon().isNull()
    recent.menu.close()
    entry.trigger()
    user.wait(lambda: user.window.windowTitle().startswith("ball.ply"))
    recent.menu.actions()[-1].trigger()
    assert recent.names == []


def test_the_gallery_opens_a_bundled_model(user, ball_file):
    user.open(ball_file)
    dialog = gallery(user)
    user.wait(thumbnail("sample:machine_part").exists)
    items = [dialog.bundled.item(row) for row in range(dialog.bundled.count())]
    item = next(item for item in items if item.text() == "Machine part")
    dialog.bundled.setCurrentItem(item)
    user.qtbot.mouseClick(button(dialog, "Open"), LEFT)
    user.wait(lambda: user.window.windowTitle().startswith("machine_part.ply"))


def test_the_gallery_downloads_beside_the_window(user, ball_file, tmp_path, monkeypatch):
    user.open(ball_file)
    begun, go_on = threading.Event(), threading.Event()
    (tmp_path / "cow.ply").write_bytes(ball_file.read_bytes())

    def download(example, meter):
        begun.set()
        go_on.wait(20)
        return str(tmp_path / f"{example}.ply")

    monkeypatch.setattr(downloads, "download", download)
    dialog = gallery(user)
    item = dialog.examples.findItems("Cow", Qt.MatchFlag.MatchExactly)[0]
    dialog.examples.itemActivated.emit(item)
    user.wait(begun.is_set)
    assert dialog.progress.isVisible()
    assert dialog.message.text() == "Downloading Cow …"
    go_on.set()
    user.wait(lambda: user.window.windowTitle().startswith("cow.ply"))


def test_without_a_network_the_gallery_says_so_and_goes_on(user, ball_file, monkeypatch):
    from pyvista.examples.downloads import FETCHER

    class ConnectionError(OSError):
        pass

    def fail(file, downloader):
        raise ConnectionError("Max retries exceeded")

    monkeypatch.setattr(FETCHER, "fetch", fail)
    user.open(ball_file)
    dialog = gallery(user)
    item = dialog.examples.findItems("Cow", Qt.MatchFlag.MatchExactly)[0]
    dialog.examples.setCurrentItem(item)
    user.qtbot.mouseClick(button(dialog, "Open"), LEFT)
    user.wait(lambda: "there is no connection" in dialog.message.text())
    assert dialog.message.text().startswith("Cow cannot be downloaded")
    assert button(dialog, "Open").isEnabled()


@pytest.mark.parametrize("example", downloads.EXAMPLES)
def test_every_example_is_the_file_that_pyvista_downloads(example, monkeypatch):
    from pyvista import examples

    fetched = []

    def fetch(file, **_):
        fetched.append(file)
        return __file__

    monkeypatch.setattr(examples.downloads.FETCHER, "fetch", fetch)
    getattr(examples, f"download_{example}")(load=False)
    assert fetched == [downloads.EXAMPLES[example].file]


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
    user.qtbot.mouseClick(page.reset_button, LEFT)
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
    user.qtbot.mouseClick(button(box, "Copy details"), LEFT)
    details = QApplication.clipboard().text()
    assert "Traceback" in details
    assert "numpy " in details
    assert box.isVisible()
    user.qtbot.mouseClick(button(box, "Close"), LEFT)
    user.window.session.undo()
    assert user.window.session.study == study
    user.rest()


def test_after_an_error_in_a_slot_the_study_is_whole_and_can_be_saved(
    user, ball_file, faults, tmp_path, monkeypatch
):
    opened, file = [], tmp_path / "after.burnish"
    monkeypatch.setattr(QDesktopServices, "openUrl", opened.append)
    user.open(ball_file)
    study = user.window.session.study

    def stumble():
        raise ZeroDivisionError("a slot stumbled")

    QTimer.singleShot(0, stumble)
    user.wait(lambda: boxes(user))
    box = boxes(user)[0]
    assert "ZeroDivisionError: a slot stumbled" in box.informativeText()
    assert "Your study is as it was" in box.informativeText()
    user.qtbot.mouseClick(button(box, "Show the log"), LEFT)
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


def test_an_error_of_another_place_is_told_when_the_first_was_read(user, faults):
    def report(error):
        try:
            raise error
        except LookupError as raised:
            faults.report(raised)

    report(KeyError("first"))
    user.wait(lambda: boxes(user))
    report(KeyError("first"))
    user.qtbot.mouseClick(button(boxes(user)[0], "Close"), LEFT)
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


def test_a_name_with_an_ampersand_stands_in_the_undo_step_as_it_is(user, ball_file, tmp_path):
    odd = tmp_path / "R&D.ply"
    odd.write_bytes(ball_file.read_bytes())
    user.open(ball_file)
    user.open(odd)
    assert user.window.actions_["undo"].text() == "&Undo Open R&&D.ply"


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (URLError("Name or service not known"), "there is no connection to github.com"),
        (TimeoutError("timed out"), "github.com did not answer in time"),
        (ValueError("hash does not match"), "hash does not match."),
    ],
)
def test_every_kind_of_failed_download_is_one_sentence(monkeypatch, error, words):
    from pyvista.examples.downloads import FETCHER

    def fail(file, downloader):
        raise error

    monkeypatch.setattr(FETCHER, "fetch", fail)
    with pytest.raises(downloads.DownloadError, match=words):
        downloads.download("cow", downloads.Meter())


def test_a_download_that_was_cancelled_opens_nothing(user, ball_file, tmp_path, monkeypatch):
    user.open(ball_file)
    begun, go_on = threading.Event(), threading.Event()
    (tmp_path / "cow.ply").write_bytes(ball_file.read_bytes())

    def download(example, meter):
        begun.set()
        go_on.wait(20)
        return str(tmp_path / f"{example}.ply")

    monkeypatch.setattr(downloads, "download", download)
    dialog = gallery(user)
    item = dialog.examples.findItems("Cow", Qt.MatchFlag.MatchExactly)[0]
    dialog.examples.itemActivated.emit(item)
    user.wait(begun.is_set)
    user.window.session.cancel()
    assert dialog.message.text() == "The download was cancelled."
    assert dialog.examples.isEnabled()
    go_on.set()
    user.wait(lambda: "Downloaded to" in user.window.statusBar().currentMessage())
    assert user.window.windowTitle().startswith("ball.ply")
    dialog.close()


def test_cancel_in_the_window_stops_the_transfer(user, ball_file, monkeypatch):
    user.open(ball_file)
    begun, outcome = threading.Event(), []

    def download(example, meter):
        begun.set()
        try:
            while True:
                meter.update(1)
                time.sleep(0.01)
        except downloads.DownloadCancelledError as error:
            outcome.append(error)
            raise

    monkeypatch.setattr(downloads, "download", download)
    dialog = gallery(user)
    item = dialog.examples.findItems("Cow", Qt.MatchFlag.MatchExactly)[0]
    dialog.examples.itemActivated.emit(item)
    user.wait(begun.is_set)
    user.window.session.cancel()
    user.wait(lambda: outcome)
    assert dialog.message.text() == "The download was cancelled."
    assert dialog.examples.isEnabled()
    dialog.close()
