"""One window after another in a process of its own: opened, brought to rest, measured, closed."""

import faulthandler
import gc
import os
import shutil
import sys
import tempfile
import threading
import time
from pathlib import Path

import hands
import watch
import world
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit

from app.session.documents import Document
from app.ui.main_window import MainWindow
from core.study import Study

_PATIENCE = float(os.environ.get("BURNISH_TEST_PATIENCE", "60"))
_SIZE = 1280, 800
# Little: what does not fit is dropped and computed again, and the resident size tells of leaks.
_BUDGET = 16_000_000


class House:
    """A window, what went wrong in it, and what the process held whenever it rested."""

    def __init__(self):
        self.window, self.windows = None, 0
        self.faults = watch.Faults()
        self.measured = []
        self.faults.install()

    def open_window(self):
        """Open a window without a model."""
        self.window = MainWindow()
        self.windows += 1
        self.faults.watch(self.window)
        self.window.resize(*_SIZE)
        self.window.show()
        self.window.activateWindow()
        self.wait(self.window.isActiveWindow, "the window to be active")

    def close_window(self):
        """Close the window, unless that has been done, and see that nothing of it runs on."""
        self._close(self.window)
        self.window = None
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        gc.collect()
        self.wait(lambda: not burnish_threads(), "Burnish's threads to end")

    def _close(self, window):
        window.files.discard_changes()
        window.close()
        self.wait(lambda: not window.isVisible(), "the window to close")
        window.deleteLater()

    def come_home(self, model):
        """Close all dialogs, open a small study and wait until nothing is under way."""
        self.close_dialogs()
        session = self.window.session
        session.cancel()
        study = Study(model=str(model))
        self.window.files.documents.open(study, Document(saved=study), "Home")
        self.window.showNormal()
        self.window.resize(*_SIZE)
        self.window.tabs.setCurrentIndex(0)
        session.set_budget(_BUDGET)
        self.wait(lambda: session.study.model == study.model and self.rests(), "the small study")
        self.close_dialogs()

    def rests(self):
        """Whether nothing is being loaded, computed or saved."""
        session = self.window.session
        return session.meshes and session.activity is None and not session.tasks.states()

    def measure(self):
        """Add what the process holds now."""
        self.measured.append({"windows": self.windows, **watch.measure(self.window)})

    def close_dialogs(self):
        """Close whatever is open beside the window."""
        for _ in range(20):
            shown = {w for w in QApplication.topLevelWidgets() if w.isVisible()} - {self.window}
            top = hands.scope() or next(iter(shown), None)
            if top is None or top is self.window:
                return
            top.close()
            hands.rest(1)

    def answer_file_dialog(self, path):
        """Enter a name into the file dialog that has been opened."""
        self.wait(hands.file_dialog, "a file dialog")
        line = hands.file_dialog().findChild(QLineEdit, "fileNameEdit")
        line.setText(str(path))
        QTest.keyClick(line, Qt.Key.Key_Return)

    def wait(self, condition, what):
        """Wait until something is so; that it never is, is a fault."""
        end = time.monotonic() + _PATIENCE
        faulthandler.dump_traceback_later(2 * _PATIENCE, exit=True)
        while not condition():
            if time.monotonic() > end:
                self.faults.found.append(f"Waited in vain for {what}.")
                return
            hands.rest(10)


def burnish_threads():
    """Return the names of the threads that belong to a window."""
    return [t.name for t in threading.enumerate() if t.name.startswith("burnish")]


def inhabit(live):
    """Run a function of a new folder in Qt's application, then end the process."""
    faulthandler.enable()
    folder, status = Path(tempfile.mkdtemp(prefix="burnish-test-")), 2
    try:
        world.move_in(folder)
        application = world.set_up(folder)
        status = live(folder)
        application.clipboard().clear()
    except Exception:  # noqa: BLE001 - whatever it is, the process ends
        sys.__excepthook__(*sys.exc_info())
    shutil.rmtree(folder, ignore_errors=True)
    sys.stdout.flush()
    # As the program itself does: a thread may be in the middle of a step that cannot be cut.
    os._exit(status)
