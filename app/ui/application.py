"""Starts Qt and the window."""

import gc
import os
from pathlib import Path

# pyvistaqt asks qtpy for a binding; say which before either is imported.
os.environ.setdefault("QT_API", "pyside6")

from PySide6.QtCore import QCoreApplication

from app.logs import start_logging
from app.ui.graphics import NO_WINDOW, leave, make_application, opengl_is_missing


def start(model: str) -> int:
    """Open the window on a model; the process ends when it is closed.

    Without a display or OpenGL the exit status is returned, after one sentence on standard error.
    """
    start_logging()
    # Nearly all that is made until the window is there stays as long as the window. To look through
    # it for what does not takes a fifth of a second each time, and the window would stand still.
    # From then on the window collects.
    gc.disable()
    QCoreApplication.setOrganizationName("Burnish")
    QCoreApplication.setApplicationName("Burnish")
    application = make_application()
    if opengl_is_missing():
        return NO_WINDOW
    from app.ui.dialogs import remember_folder
    from app.ui.main_window import MainWindow
    from app.ui.restoring import offer_leftovers

    window = MainWindow()
    window.faults.install()
    window.show()
    gc.freeze()
    if Path(model).is_file():
        remember_folder(model)
    window.files.open(model)
    offer_leftovers(window)
    try:
        status = application.exec()
    finally:
        window.faults.uninstall()
    if application.clipboard().ownsClipboard():
        application.shutdown()  # hands over what was copied
    # A thread may be in the middle of a step that cannot be cut, and taking apart what it uses
    # would crash; even without, that takes seconds. Nothing is lost: what is saved was waited for
    # when the window closed.
    leave(status)
    return status
