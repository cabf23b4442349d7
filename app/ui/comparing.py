"""Two panes in place of each other: flickering while a key is held, and a line that is dragged."""

from dataclasses import replace

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtWidgets import QApplication

from app.scene.comparing import pair
from app.scene.swipe import Swipe
from app.ui.denoise_tab import DenoiseTab

_REACH = 7
_MARGIN = 0.02


class Flicker(QObject):
    """Shows another pane's mesh in the selected pane while the key of a command is held.

    Started from the menu, where no key is held, the command switches it on and off.

    Parameters
    ----------
    tab : DenoiseTab
        Whose panes flicker.
    action : QAction
        The command; its shortcut is the key.
    """

    def __init__(self, tab: DenoiseTab, action: QAction) -> None:
        super().__init__(tab)
        self._tab, self._action = tab, action
        self._held: Qt.Key | None = None
        action.setAutoRepeat(False)
        action.installEventFilter(self)

    def start(self) -> None:
        """Show the other mesh, or the pane's own again if it is shown already."""
        self._tab.set_flicker(self._tab.flicker is None)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._action:
            if event.type() == QEvent.Type.Shortcut:
                self._hold(event.key()[0].key())
        elif self._ends(event):
            QApplication.instance().removeEventFilter(self)
            self._tab.set_flicker(False)
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
    """Parts the enlarged pane by a line that the mouse drags.

    Parameters
    ----------
    tab : DenoiseTab
        Whose viewport is parted.
    action : QAction
        The checkable command; unchecked when its panes are gone.
    """

    def __init__(self, tab: DenoiseTab, action: QAction) -> None:
        super().__init__(tab)
        self._tab, self._action = tab, action
        self._area, self._grid = tab.viewport.interactor, tab.viewport.grid
        self._drags = False
        self._area.installEventFilter(self)

    def set_on(self, on: bool) -> None:
        """Part the pane, or show all panes again."""
        study = self._tab.session.study
        chosen = pair(self._grid.ids, self._tab.selected, study.view.compare_with) if on else None
        share = self._grid.swipe.share if self._grid.swipe else 0.5
        self._grid.swipe = Swipe(chosen[1], chosen[0], share) if chosen else None
        if chosen is None:
            self._set_cursor(False)
        self._tab.viewport.redraw()

    def refresh(self) -> None:
        """Follow a change of the panes, of the selection or of the study."""
        if self._action.isChecked():
            self.set_on(True)

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if self._grid.swipe is None or not isinstance(event, QMouseEvent):
            return False
        near = self._is_near(event)
        left = event.button() == Qt.MouseButton.LeftButton
        if event.type() == QEvent.Type.MouseButtonPress and left and near:
            self._drags = True
        elif event.type() == QEvent.Type.MouseButtonRelease and self._drags:
            self._drags = False
        elif event.type() == QEvent.Type.MouseMove and self._drags:
            self._move(event)
        else:
            self._set_cursor(near)
            return False
        return True

    def _share(self, event: QMouseEvent) -> float:
        """Place of the mouse across the pane."""
        port = self._grid.viewports[self._grid.swipe.left]
        across = event.position().x() / max(self._area.width(), 1)
        return (across - port.left) / (port.right - port.left)

    def _is_near(self, event: QMouseEvent) -> bool:
        return abs(self._share(event) - self._grid.swipe.share) * self._area.width() < _REACH

    def _move(self, event: QMouseEvent) -> None:
        share = min(max(self._share(event), _MARGIN), 1 - _MARGIN)
        self._grid.swipe = replace(self._grid.swipe, share=share)
        self._tab.viewport.redraw()

    def _set_cursor(self, near: bool) -> None:
        shape = Qt.CursorShape.SplitHCursor if near else Qt.CursorShape.ArrowCursor
        if self._area.cursor().shape() != shape:
            self._area.setCursor(shape)
