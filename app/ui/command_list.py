"""All that the menus can do, as one flat list for the palette and the sheet of shortcuts."""

from dataclasses import dataclass

from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

_DIVIDER = " › "


@dataclass(frozen=True, eq=False)
class Entry:
    """One action, and the menus it stands in."""

    action: QAction
    menus: tuple[str, ...]

    @property
    def name(self) -> str:
        """Name as the menu shows it, without the letter that is underlined."""
        return plain(self.action.text())

    @property
    def path(self) -> str:
        """Menus and name, as a person finds the action."""
        return _DIVIDER.join((*self.menus, self.name))

    @property
    def key(self) -> str:
        """The shortcut as this machine writes it."""
        return self.action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)


def entries(window: QMainWindow) -> list[Entry]:
    """Gather every action of the menu bar, submenus included, in their order."""
    found: list[Entry] = []
    for action in window.menuBar().actions():
        if action.menu():
            _gather(action.menu(), (plain(action.text()),), found)
    return found


def plain(text: str) -> str:
    """Text of a menu without the marks of underlined letters."""
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&").removesuffix("…")


def _gather(menu: QMenu, menus: tuple[str, ...], found: list[Entry]) -> None:
    menu.aboutToShow.emit()  # menus that are filled when they open
    for action in menu.actions():
        if action.menu():
            _gather(action.menu(), (*menus, plain(action.text())), found)
        elif action.text() and all(action is not entry.action for entry in found):
            found.append(Entry(action, menus))
