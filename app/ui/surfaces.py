"""Surfaces of their own for drawing areas on X11, and what Qt then leaves undone."""

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QGuiApplication, QPaintEvent
from PySide6.QtWidgets import QWidget


def take_own_surface(widget: QWidget) -> None:
    """Give a drawing area, or what stands above one, a surface of its own on X11.

    Without it Qt puts the whole window together by OpenGL, pictures and all, whenever any widget
    is painted: on software OpenGL 60 ms at 1280 by 800 pixels and 150 ms at 1920 by 1080, where it
    takes 2 ms so. X11 alone: other systems move such surfaces on their own.
    """
    if QGuiApplication.platformName() == "xcb":
        # Else what stands beside it, and in turn nearly every widget, gets a surface too.
        QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_DontCreateNativeWidgetSiblings)
        widget.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
        widget.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)


class Uncovering(QObject):
    """Shows a window's widgets again where another window has covered them.

    Qt 6.11 leaves that out in a window with a drawing area that has a surface of its own.

    Parameters
    ----------
    window : QWidget
        The window.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.WinIdChange and watched is self._window:
            self._window.windowHandle().installEventFilter(self)
        elif isinstance(event, QPaintEvent) and watched is not self._window:
            self._window.backingStore().flush(event.region(), self._window.windowHandle())
        return False
