"""What must not happen, and what must not grow."""

import ctypes
import gc
import logging
import os
import sys
import threading
import traceback
import warnings
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QObject, QtMsgType, qInstallMessageHandler
from PySide6.QtWidgets import QApplication

HARMLESS = ()
"""Beginnings of messages of Qt that are not the program's fault."""


class Faults:
    """Collects every exception, in whatever thread, every warning, and all that Qt complains of."""

    def __init__(self):
        self.found = []
        self._listener = logging.Handler(logging.ERROR)
        self._listener.emit = lambda record: self.found.append(self._listener.format(record))

    def install(self):
        sys.excepthook = lambda _, error, __: self._add(error)
        sys.unraisablehook = lambda unraisable: self._add(unraisable.exc_value)
        threading.excepthook = lambda thrown: self._add(thrown.exc_value)
        # Matplotlib prints what is raised while a plot is drawn, and goes on.
        traceback.print_exc = lambda *_, **__: self._add(sys.exc_info()[1])
        qInstallMessageHandler(self._on_message)
        logging.getLogger().addHandler(self._listener)
        warnings.simplefilter("error")

    def watch(self, window):
        """Hear of the faults that a window would tell in a dialog."""
        window.session.broken.connect(self._add)

    def _add(self, error):
        self.found.append("".join(traceback.format_exception(error)))

    def _on_message(self, kind, _, message):
        harmless = kind in {QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg}
        if not harmless and not message.startswith(HARMLESS):
            stack = "".join(traceback.format_stack(limit=12))
            self.found.append(f"Qt says: {message}\n{stack}")


def measure(window):
    """Count what the process holds; call it when nothing is under way.

    Freed memory is given back to the system first: else the resident size tells what was needed
    at most, not what is held.
    """
    gc.collect()
    with suppress(OSError, AttributeError):
        ctypes.CDLL(None).malloc_trim(0)
    known = gc.get_objects()
    return {
        "megabytes": round(resident_bytes() / 1e6, 1),
        "handles": len(list(Path("/proc/self/fd").iterdir())),
        "threads": threading.active_count(),
        "widgets": len(QApplication.allWidgets()),
        "qobjects": len(window.findChildren(QObject)),
        "vtk": sum(type(each).__name__.startswith("vtk") for each in known),
        "objects": len(known),
    }


def resident_bytes():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")
