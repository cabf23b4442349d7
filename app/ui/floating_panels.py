"""Panels that float go away with their tab and come back with it."""

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QDockWidget, QTabWidget


class FloatingPanels(QObject):
    """Hides the floating panels of tabs that are not shown; Qt would leave them over the others.

    Parameters
    ----------
    tabs : QTabWidget
        The tabs; it owns this.
    """

    def __init__(self, tabs: QTabWidget) -> None:
        super().__init__(tabs)
        self._tabs = tabs
        self._away: list[QDockWidget] = []
        tabs.currentChanged.connect(self._follow)

    def show_all(self) -> None:
        """Bring back what is away, so that a layout that is saved knows it as shown."""
        for panel in self._away:
            panel.show()
        self._away = []

    def _follow(self, _: int) -> None:
        here = self._tabs.currentWidget()
        for panel in [panel for panel in self._away if panel.parent() is here]:
            self._away.remove(panel)
            panel.show()
        for panel in self._tabs.findChildren(QDockWidget):
            if panel.isFloating() and panel.isVisible() and panel.parent() is not here:
                self._away.append(panel)
                panel.hide()
