"""The gallery: bundled models, and downloads with all that can go wrong."""

import threading
import time
from urllib.error import URLError

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QIcon

from app.ui import downloads
from app.ui.gallery import GalleryDialog
from app.ui.thumbnails import thumbnail

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton
NORMAL, DISABLED = QIcon.Mode.Normal, QIcon.Mode.Disabled


def gallery(user):
    user.press(Qt.Key.Key_G, CONTROL)
    user.wait(lambda: user.window.findChild(GalleryDialog))
    return user.window.findChild(GalleryDialog)


def test_the_gallery_opens_a_bundled_model(user, ball_file):
    user.open(ball_file)
    dialog = gallery(user)
    user.wait(thumbnail("sample:machine_part").exists)
    items = [dialog.bundled.item(row) for row in range(dialog.bundled.count())]
    item = next(item for item in items if item.text() == "Machine part")
    dialog.bundled.setCurrentItem(item)
    user.qtbot.mouseClick(user.button(dialog, "Open"), LEFT)
    user.wait(lambda: user.window.windowTitle().startswith("machine_part.ply"))


@pytest.fixture
def held_download(user, ball_file, gate, tmp_path, monkeypatch):
    """The gallery while it downloads a cow, held up at the gate, beside an open model."""
    user.open(ball_file)
    begun = threading.Event()
    (tmp_path / "cow.ply").write_bytes(ball_file.read_bytes())

    def download(example, meter):
        begun.set()
        gate.wait(20)
        return str(tmp_path / f"{example}.ply")

    monkeypatch.setattr(downloads, "download", download)
    dialog = gallery(user)
    item = dialog.examples.findItems("Cow", Qt.MatchFlag.MatchExactly)[0]
    dialog.examples.itemActivated.emit(item)
    user.wait(begun.is_set)
    return dialog


def test_the_gallery_downloads_beside_the_window(user, held_download, gate):
    dialog = held_download
    assert dialog.progress.isVisible()
    assert dialog.message.text() == "Downloading Cow …"
    icon, size = dialog.examples.item(0).icon(), dialog.examples.iconSize()
    plain, pale = (icon.pixmap(size, mode).toImage() for mode in (NORMAL, DISABLED))
    assert plain == pale
    gate.set()
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
    user.qtbot.mouseClick(user.button(dialog, "Open"), LEFT)
    user.wait(lambda: "there is no connection" in dialog.message.text())
    assert dialog.message.text().startswith("Cow cannot be downloaded")
    assert user.button(dialog, "Open").isEnabled()


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


def test_a_download_that_was_cancelled_opens_nothing(user, held_download, gate):
    dialog = held_download
    user.window.session.cancel()
    assert dialog.message.text() == "The download was cancelled."
    assert dialog.examples.isEnabled()
    gate.set()
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
