"""Two meshes in place of each other: flickering while a key is held, and a line to drag."""

from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtWidgets import QApplication

from app.ui.desk import Desk
from app.ui.stage import share_of

_REACH = 7
_MARGIN = 0.02


class Flicker(QObject):
    """Shows another mesh in the selected view while the key of a command is held.

    Started from the menu, where no key is held, the command switches it on and off.

    Parameters
    ----------
    window : MainWindow
        On the tab that it shows, views flicker.
    action : QAction
        The command; its shortcut is the key.
    """

    def __init__(self, window: Any, action: QAction) -> None:
        super().__init__(window)
        self._window, self._action = window, action
        self._held: Qt.Key | None = None
        action.setAutoRepeat(False)
        action.installEventFilter(self)
        window.tabs.currentChanged.connect(self.stop)

    def start(self) -> None:
        """Show the other mesh, or the view's own again if it is shown already."""
        desk: Desk = self._window.desk
        desk.set_flicker(not desk.flickers)

    def stop(self, *_: object) -> None:
        """Show every view's own mesh, on whichever tab."""
        QApplication.instance().removeEventFilter(self)
        for desk in self._window.desks:
            if desk.flickers:
                desk.set_flicker(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._action:
            if event.type() == QEvent.Type.Shortcut:
                self._hold(event.key()[0].key())
        elif self._ends(event):
            self.stop()
        return False

    def _hold(self, key: Qt.Key) -> None:
        """Wait for the release of a key, whatever has the focus then."""
        self._held = key
        QApplication.instance().installEventFilter(self)

    def _ends(self, event: QEvent) -> bool:
        """Whether the key was released, or the keyboard went to another program."""
        if event.type() == QEvent.Type.KeyRelease:
            return event.key() == self._held and not event.isAutoRepeat()
        return event.type() == QEvent.Type.ApplicationDeactivate


class SwipeLine(QObject):
    """Lets the mouse drag the line that parts a view.

    Parameters
    ----------
    desk : Desk
        The tab with the line.
    """

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self._desk = desk
        self._area = desk.stage.interactor
        self._drags = False
        self._area.installEventFilter(self)

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if not isinstance(event, QMouseEvent) or self._desk.swipe_line is None:
            return False
        near = self._is_near(event)
        left = event.button() == Qt.MouseButton.LeftButton
        if event.type() == QEvent.Type.MouseButtonPress and left and near:
            self._drags = True
        elif event.type() == QEvent.Type.MouseButtonRelease and self._drags:
            self._drags = False
        elif event.type() == QEvent.Type.MouseMove and self._drags:
            self._desk.move_swipe(min(max(self._share(event), _MARGIN), 1 - _MARGIN))
        else:
            self.set_cursor(near)
            return False
        return True

    def set_cursor(self, near: bool) -> None:
        """Tell by the cursor whether the line can be grasped."""
        shape = Qt.CursorShape.SplitHCursor if near else Qt.CursorShape.ArrowCursor
        if self._area.cursor().shape() != shape:
            self._area.setCursor(shape)

    def _share(self, event: QMouseEvent) -> float:
        """Place of the mouse across the view."""
        port, _ = self._desk.swipe_line
        across, _ = share_of(self._desk.stage, event.position())
        return (across - port.left) / (port.right - port.left)

    def _is_near(self, event: QMouseEvent) -> bool:
        port, line = self._desk.swipe_line
        width = (port.right - port.left) * self._area.width()
        return abs(self._share(event) - line) * width < _REACH
