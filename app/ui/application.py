"""Starts Qt and the window."""

import os
import sys

# pyvistaqt asks qtpy for a binding; say which before either is imported.
os.environ.setdefault("QT_API", "pyside6")

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication

from app.logs import start_logging


def start(model: str) -> int:
    """Open the window on a model and run until it is closed; returns the exit status."""
    start_logging()
    QCoreApplication.setOrganizationName("Burnish")
    QCoreApplication.setApplicationName("Burnish")
    application = QApplication.instance() or QApplication(sys.argv[:1])
    from app.ui.main_window import MainWindow
    from app.ui.restoring import offer_leftovers

    window = MainWindow()
    window.faults.install()
    window.show()
    window.files.open(model)
    offer_leftovers(window)
    try:
        return application.exec()
    finally:
        window.faults.uninstall()
