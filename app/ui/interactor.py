"""PyVista's Qt interactor as Burnish wants it: no keys of its own, no drops, no idle drawing."""

from PySide6.QtCore import Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor

from app.ui.surfaces import take_own_surface

_PLAIN_DPI = 72


class Interactor(QtInteractor):
    """A drawing area whose keys and drops go to the window.

    Parameters
    ----------
    parent : QWidget
        Where it stands.
    shape : (int, int)
        Rows and columns of its renderers.

    Signals
    -------
    pixels_lost() : nothing of what has been drawn is left.
    """

    pixels_lost = Signal()

    def __init__(self, parent: QWidget, shape: tuple[int, int]) -> None:
        # Multisampling makes software OpenGL six times slower and hides translucent meshes under
        # depth peeling; without automatic updates nothing is drawn while nothing changes.
        super().__init__(parent, shape=shape, border=False, multi_samples=0, auto_update=False)
        take_own_surface(self)
        self.setAcceptDrops(False)
        self.iren.clear_key_event_callbacks()

    def initializeGL(self) -> None:
        super().initializeGL()
        self.pixels_lost.emit()

    def resizeGL(self, width: int, height: int) -> None:
        super().resizeGL(width, height)
        # Text has its size in pixels, as in a picture; else VTK would enlarge it a second time.
        if self.render_window is not None:
            self.render_window.SetDPI(_PLAIN_DPI)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def pixel_size(self) -> tuple[int, int]:
        """Size of the drawing area in device pixels."""
        ratio = self.devicePixelRatioF()
        return max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))
