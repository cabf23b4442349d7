"""PyVista's Qt interactor as Burnish wants it: no keys of its own, no drops, no idle drawing."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent
from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor

_PLAIN_DPI = 72


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
        self._take_own_surface()
        self.setAcceptDrops(False)
        self.iren.clear_key_event_callbacks()

    def resizeGL(self, width: int, height: int) -> None:
        super().resizeGL(width, height)
        # Text has its size in pixels, as in a picture; else VTK would enlarge it a second time.
        if self.render_window is not None:
            self.render_window.SetDPI(_PLAIN_DPI)

    def _take_own_surface(self) -> None:
        # Without it Qt puts the whole window together by OpenGL, pictures and all, whenever any
        # widget is painted: on software OpenGL 60 ms at 1280 by 800 pixels and 150 ms at 1920 by
        # 1080, where it takes 2 ms so. X11 alone: other systems move such surfaces on their own.
        if QGuiApplication.platformName() == "xcb":
            self.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
            self.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def pixel_size(self) -> tuple[int, int]:
        """Size of the drawing area in device pixels."""
        ratio = self.devicePixelRatioF()
        return max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))
