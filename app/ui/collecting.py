"""Python's garbage collection, on the window's thread alone."""

import gc

from PySide6.QtCore import QObject, QTimer

_EVERY_MS = 100


class Collector(QObject):
    """Collects what only refers to itself, in the window's thread and while it lives.

    By itself Python collects in whatever thread happens to allocate. What is left of a closed
    dialog or of a picture, objects of Qt and of VTK, would then be destroyed by a worker, while the
    window's thread is at work on its neighbours; such a crash comes rarely and anywhere.

    Parameters
    ----------
    parent : QObject
        Whose thread collects.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self, interval=_EVERY_MS)
        self._timer.timeout.connect(self._collect)
        self._timer.start()

    def close(self) -> None:
        """Leave the collecting to Python again."""
        self._timer.stop()
        gc.enable()

    def _collect(self) -> None:
        """Collect the oldest generation that is due by Python's own thresholds, if any is."""
        counts = zip(gc.get_count(), gc.get_threshold(), strict=True)
        due = [generation for generation, (count, most) in enumerate(counts) if count > most]
        if due:
            gc.collect(due[-1])
