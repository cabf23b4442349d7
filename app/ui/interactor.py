"""PyVista's Qt interactor as Burnish wants it: no keys of its own, no drops, no idle drawing."""

from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor


class Interactor(QtInteractor):
    """A drawing area whose keys and drops go to the window.

    Parameters
    ----------
    parent : QWidget
        Where it stands.
    shape : (int, int)
        Rows and columns of its renderers.
    """

    def __init__(self, parent: QWidget, shape: tuple[int, int]) -> None:
        # Multisampling makes software OpenGL six times slower and hides translucent meshes under
        # depth peeling; without automatic updates nothing is drawn while nothing changes.
        super().__init__(parent, shape=shape, border=False, multi_samples=0, auto_update=False)
        self.setAcceptDrops(False)
        self.iren.clear_key_event_callbacks()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def pixel_size(self) -> tuple[int, int]:
        """Size of the drawing area in device pixels."""
        ratio = self.devicePixelRatioF()
        return int(self.width() * ratio), int(self.height() * ratio)
