"""The whole window on a virtual X server, used as a person uses it."""

import gc
import os
import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QSettings, Qt
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit, QPushButton

from core.io import save_mesh
from core.mesh import primitives

PATIENCE = int(os.environ.get("BURNISH_TEST_PATIENCE", "60")) * 1000


@pytest.fixture
def ball_file(tmp_path):
    """File of a sphere with 642 vertices."""
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(3), path)
    return path


@pytest.fixture
def folder(tmp_path):
    """An empty folder to save into."""
    folder = tmp_path / "out"
    folder.mkdir()
    return folder


@pytest.fixture
def gate():
    """Holds up what waits for it until it is set, at the latest at the end of the test."""
    gate = threading.Event()
    yield gate
    gate.set()


@pytest.fixture
def window(qtbot, tmp_path, monkeypatch):
    """A main window without a model, active, of the smallest supported size."""
    for kind in ("STATE", "CACHE"):
        monkeypatch.setenv(f"XDG_{kind}_HOME", str(tmp_path / kind.lower()))
    QCoreApplication.setOrganizationName("BurnishTests")
    QCoreApplication.setApplicationName("BurnishTests")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    QSettings.setPath(
        QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path / "settings")
    )
    from app.ui.main_window import MainWindow

    window = MainWindow()
    window.resize(1280, 800)
    window.show()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    yield window
    window.files.discard_changes()
    window.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    gc.collect()


@pytest.fixture
def user(qtbot, window):
    """Someone who uses the window."""
    return User(qtbot, window)


class User:
    """Does with mouse and keys what a person does, and looks at what a person sees."""

    def __init__(self, qtbot, window):
        self.qtbot, self.window = qtbot, window
        self.denoise = window.denoise

    def press(self, key, modifier=Qt.KeyboardModifier.NoModifier):
        self.qtbot.keyClick(self.window, key, modifier)

    def wait(self, condition):
        self.qtbot.waitUntil(lambda: bool(condition()), timeout=PATIENCE)

    def rest(self):
        """Wait until everything is computed and drawn."""
        session = self.window.session
        self.wait(lambda: session.meshes is not None and session.activity is None)
        self.wait(lambda: self.denoise.is_drawn and self.captions() == self.drawn_captions())

    def open(self, path):
        """Open a file by Ctrl+O, its name and Enter."""
        self.press(Qt.Key.Key_O, Qt.KeyboardModifier.ControlModifier)
        self.answer_file_dialog(path)
        self.wait(lambda: self.window.windowTitle().startswith(Path(path).name))
        self.rest()

    def answer_file_dialog(self, path):
        """Paste a file's name, because the dialog completes what is typed, and press Enter."""
        self.wait(self.file_dialogs)
        line = self.file_dialogs()[0].findChild(QLineEdit, "fileNameEdit")
        QApplication.clipboard().setText(str(path))
        line.selectAll()
        line.paste()
        self.qtbot.keyClick(line, Qt.Key.Key_Return)

    def file_dialogs(self):
        return [d for d in self.window.findChildren(QFileDialog) if d.isVisible()]

    def button(self, parent, word):
        """The button with a word in its text."""
        found = parent.findChildren(QPushButton)
        return next(b for b in found if word in b.text().replace("&", ""))

    def captions(self):
        """Captions that the panes should have now."""
        return {pane.id: pane.caption for pane in self.denoise.panes()[0]}

    def drawn_captions(self):
        """Captions that were drawn last."""
        return {pane.id: pane.caption for pane in self.denoise.viewport.grid.panes}

    def middle_of(self, pane):
        """Point in the middle of a pane, in the viewport's coordinates."""
        area = self.denoise.viewport.interactor
        left, top, width, height = self.denoise.viewport.grid.viewports[pane].pixels(
            area.width(), area.height()
        )
        return QPoint(int(left + width / 2), int(top + height / 2))

    def click_pane(self, pane):
        area = self.denoise.viewport.interactor
        self.qtbot.mouseClick(area, Qt.MouseButton.LeftButton, pos=self.middle_of(pane))

    def type_iterations(self, method, count):
        """Type a number into a method's box."""
        box = self.denoise.methods.blocks[method].iterations.box
        box.setFocus()
        box.selectAll()
        self.qtbot.keyClicks(box, str(count))
        self.qtbot.keyClick(box, Qt.Key.Key_Return)
