"""Whether a window can be drawn at all: a display, and the OpenGL that the panes need."""

import logging
import os
import sys

from PySide6.QtCore import QMessageLogContext, QtMsgType, qInstallMessageHandler
from PySide6.QtGui import QOffscreenSurface, QOpenGLContext
from PySide6.QtWidgets import QApplication, QMessageBox

logger = logging.getLogger(__name__)

NO_WINDOW = 1
"""Exit status where no window can open, or the display is lost."""

_NEEDED = (3, 2)  # VTK draws with nothing older
_WAY_OUT = "The command line needs none of this: burnish compare MODEL -o FOLDER."


def make_application() -> QApplication:
    """Return Qt's application; without a display the process ends with one sentence.

    Qt itself would abort, which looks like a crash.
    """
    known = QApplication.instance()
    if isinstance(known, QApplication):
        return known
    said: list[str] = []

    def listen(kind: QtMsgType, _: QMessageLogContext, message: str) -> None:
        logger.warning("%s", message)
        said.append(message)
        if kind is QtMsgType.QtFatalMsg:
            say(
                f"The window cannot open: {said[0].strip().splitlines()[0].rstrip('.')}. {_WAY_OUT}"
            )
            leave(NO_WINDOW)

    qInstallMessageHandler(listen)
    try:
        return QApplication(sys.argv[:1])
    finally:
        qInstallMessageHandler(None)


def opengl_is_missing() -> bool:
    """Tell, in a dialog and on standard error, if there is no OpenGL that suffices."""
    found = opengl_version()
    if found >= _NEEDED:
        return False
    has = f"this one has {found[0]}.{found[1]}" if found > (0, 0) else "this one has none"
    sentence = f"Burnish needs a graphics driver with OpenGL 3.2 or newer; {has}."
    logger.error("%s", sentence)
    say(f"{sentence} {_WAY_OUT}")
    box = QMessageBox(QMessageBox.Icon.Critical, "Burnish", sentence)
    box.setInformativeText(f"A newer driver, or Mesa's software renderer, helps.\n\n{_WAY_OUT}")
    box.exec()
    return True


def opengl_version() -> tuple[int, int]:
    """Return the version of OpenGL that contexts get here; (0, 0) where there is none."""
    context, surface = QOpenGLContext(), QOffscreenSurface()
    if not context.create():
        return (0, 0)
    surface.setFormat(context.format())
    surface.create()
    if not context.makeCurrent(surface):
        return (0, 0)
    context.doneCurrent()
    surface.destroy()
    major, minor = context.format().version()
    return (major, minor)


def say(sentence: str) -> None:
    """Write a sentence to standard error, if anybody listens."""
    try:
        print(f"burnish: {sentence}", file=sys.stderr, flush=True)  # noqa: T201
    except OSError:
        logger.info("nobody hears: %s", sentence)


def leave(status: int) -> None:
    """End the process at once: Qt and the graphics driver can no longer be taken apart."""
    logging.shutdown()
    os._exit(status)
