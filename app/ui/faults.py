"""Unexpected errors: a line in the log, and a dialog that helps to report them."""

import logging
import sys
import threading
import traceback
from collections.abc import Callable
from contextlib import suppress
from textwrap import shorten
from types import TracebackType

from PySide6.QtCore import (
    QMessageLogContext,
    QObject,
    Qt,
    QtMsgType,
    QUrl,
    qInstallMessageHandler,
)
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget

from app.logs import log_file
from app.ui.dialogs import tell
from app.ui.graphics import NO_WINDOW, leave, say
from app.ui.help import versions
from app.ui.tasks import Poster

logger = logging.getLogger(__name__)

_LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}
_Role = QMessageBox.ButtonRole
_MOST_LETTERS = 200


class FaultReports(QObject):
    """Catches what nobody else does, in any thread, and tells of it once.

    Parameters
    ----------
    parent : QWidget
        Window that the dialog belongs to.
    keep : callable
        Keeps the study on disk before the process has to end.
    """

    def __init__(self, parent: QWidget, keep: Callable[[], None] = lambda: None) -> None:
        super().__init__(parent)
        self._window, self._keep = parent, keep
        self._post = Poster(self)
        self._told: set[str] = set()
        self._box: QMessageBox | None = None
        self._before: tuple[Callable[..., None], Callable[..., None]] | None = None

    def install(self) -> None:
        """Catch errors of the program, of its threads, and messages of Qt."""
        self._before = sys.excepthook, threading.excepthook
        sys.excepthook = self._on_error
        threading.excepthook = lambda args: self._on_error(
            args.exc_type, args.exc_value, args.exc_traceback
        )
        qInstallMessageHandler(self._on_qt_message)

    def uninstall(self) -> None:
        """Leave errors to whoever caught them before."""
        if self._before:
            sys.excepthook, threading.excepthook = self._before
            qInstallMessageHandler(None)
            self._before = None

    def report(self, error: BaseException) -> None:
        """Log an error and tell of it; may be called from any thread."""
        logger.error("unexpected error", exc_info=error)
        self._post(lambda: self._tell(error))

    def _on_error(
        self, kind: type[BaseException], error: BaseException | None, _: TracebackType | None
    ) -> None:
        if issubclass(kind, KeyboardInterrupt):
            QApplication.quit()
        else:
            self.report(error or kind())

    def _tell(self, error: BaseException) -> None:
        """Show one dialog at a time, and each place in the program once: it may fail often."""
        place = "".join(traceback.format_tb(error.__traceback__)[-1:]) or str(error)
        if self._box is not None or place in self._told:
            return
        self._told.add(place)
        box = self._box = QMessageBox(self._window)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.setIcon(QMessageBox.Icon.Warning)
        box.setWindowTitle("Burnish")
        box.setText("Something went wrong inside Burnish.")
        box.setInformativeText(plain_words(error))
        self._add_buttons(box, details_of(error))
        box.finished.connect(self._forget_box)
        box.open()

    def _add_buttons(self, box: QMessageBox, details: str) -> None:
        copy = box.addButton("Copy details", _Role.ActionRole)
        folder = box.addButton("Show the log", _Role.ActionRole)
        # Buttons of a message box close it unless they are taken from it.
        copy.clicked.disconnect()
        folder.clicked.disconnect()
        copy.clicked.connect(lambda: QApplication.clipboard().setText(details))
        folder.clicked.connect(lambda: show_log(box))
        box.setDefaultButton(box.addButton(QMessageBox.StandardButton.Close))

    def _on_qt_message(self, kind: QtMsgType, context: QMessageLogContext, message: str) -> None:
        """Log a message; the loss of the display, X11's or Wayland's, is told by nothing else."""
        log_qt_message(kind, context, message)
        if "connection broke" in message:
            with suppress(Exception):
                self._keep()
            say("The display is lost. What was not saved is kept; the next start offers it.")
            leave(NO_WINDOW)

    def _forget_box(self, _: int) -> None:
        self._box = None


def plain_words(error: BaseException) -> str:
    """Say what happened and what it means, without a traceback."""
    what = shorten(str(error), _MOST_LETTERS, placeholder=" …")
    return (
        f"{type(error).__name__}: {what or 'no more is known'}\n\n"
        "Your study is as it was, and you can go on working. If it happens again, please report "
        f"it with the details.\n\nThe log is {log_file()}."
    )


def details_of(error: BaseException) -> str:
    """Return all that helps to find a fault: versions, system, traceback."""
    trace = "".join(traceback.format_exception(error))
    return f"{versions()}\n\n{trace}"


def show_log(parent: QWidget) -> None:
    """Open the log with the system's program for text; where there is none, tell its place."""
    if not QDesktopServices.openUrl(QUrl.fromLocalFile(str(log_file()))):
        tell(parent, f"No program here opens the log. It is {log_file()}.")


def log_qt_message(kind: QtMsgType, context: QMessageLogContext, message: str) -> None:
    """Write what Qt has to say into the log."""
    logging.getLogger(context.category or "qt").log(_LEVELS.get(kind, logging.WARNING), message)
