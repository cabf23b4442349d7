"""The commands as Qt actions: menus, keys, tooltips, and what can be used now."""

from collections.abc import Callable, Mapping

from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

from app.ui.actions import COMMANDS, Command
from app.ui.icons import font_icon


class ActionBook:
    """The commands as Qt actions of one window.

    Parameters
    ----------
    window : QMainWindow
        Gets the menus and the shortcuts.
    handlers : mapping
        What each command does, by id; a checkable one gets its new state.
    """

    def __init__(self, window: QMainWindow, handlers: Mapping[str, Callable[..., None]]) -> None:
        self._window = window
        self._menus: dict[str, QMenu] = {}
        self._groups: dict[str, QActionGroup] = {}
        self._obstacles: dict[str, str] = {}
        self._actions = {
            command.id: self._make(command, handlers[command.id]) for command in COMMANDS
        }
        for command in COMMANDS:
            self.set_key(command.id, QKeySequence(command.key))

    def __getitem__(self, command: str) -> QAction:
        """Return the action of a command."""
        return self._actions[command]

    def menu(self, name: str) -> QMenu:
        """Return a menu, made where it is not there yet; a submenu stands after a slash."""
        if name not in self._menus:
            above, _, own = name.rpartition("/")
            parent = self.menu(above) if above else self._window.menuBar()
            self._menus[name] = parent.addMenu(own if above else f"&{own}")
            # Why a command cannot be used now is said in its tooltip.
            self._menus[name].setToolTipsVisible(True)
        return self._menus[name]

    def key(self, command: str) -> QKeySequence:
        """Return the key of a command."""
        return self[command].shortcut()

    def set_key(self, command: str, key: QKeySequence) -> None:
        """Give a command a key, and tell it in the tooltip."""
        self[command].setShortcut(key)
        self._tell(command)

    def allow(self, command: str, obstacle: str) -> None:
        """Let a command be used, or with an obstacle not; the tooltip says why."""
        if self._obstacles.get(command) == obstacle:
            return
        self[command].setEnabled(not obstacle)
        self._obstacles[command] = obstacle
        self._tell(command)

    def check(self, command: str, on: bool) -> None:
        """Show whether something is switched on, without doing it."""
        action = self[command]
        action.blockSignals(True)
        action.setChecked(on)
        action.blockSignals(False)

    def set_icons(self, colour: str) -> None:
        """Draw the icons in the colour of the text."""
        for command in COMMANDS:
            if command.icon:
                self[command.id].setIcon(font_icon(command.icon, color=colour))

    def _tell(self, command: str) -> None:
        action = self[command]
        shown = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        parts = [action.statusTip() + (f" ({shown})" if shown else "")]
        if obstacle := self._obstacles.get(command):
            parts.append(f"Not now: {obstacle}")
        action.setToolTip("\n".join(parts))

    def _make(self, command: Command, handler: Callable[..., None]) -> QAction:
        action = QAction(command.text, self._window, checkable=command.checkable)
        action.setObjectName(command.id)
        action.setStatusTip(command.tip)
        if command.group:
            group = self._groups.setdefault(command.group, QActionGroup(self._window))
            group.addAction(action)
        if command.checkable and not command.group:
            action.toggled.connect(handler)
        else:
            action.triggered.connect(lambda *_: handler())
        menu = self.menu(command.menu)
        if command.divided:
            menu.addSeparator()
        menu.addAction(action)
        return action


def escaped(text: str) -> str:
    """Return a text as a menu shows it, an ampersand as itself."""
    return text.replace("&", "&&")
