"""All that the menus can do, as one flat list for the palette and the sheet of shortcuts."""

from dataclasses import dataclass

from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu
from shiboken6 import isValid

_DIVIDER = " › "


@dataclass(frozen=True, eq=False)
class Entry:
    """One action as it was when the list was made, and the menus it stands in.

    The words are kept, not asked for: a menu that is filled anew deletes its actions while a list
    of them is still shown.
    """

    action: QAction
    menus: tuple[str, ...]
    name: str
    key: str
    tip: str
    usable: bool
    checked: bool

    @classmethod
    def of(cls, action: QAction, menus: tuple[str, ...]) -> "Entry":
        """Read an action: its name without marks, its key as this machine writes it."""
        key = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        return cls(
            action, menus, plain(action.text()), key, action.toolTip(),
            action.isEnabled(), action.isChecked(),
        )  # fmt: skip

    @property
    def path(self) -> str:
        """Menus and name, as a person finds the action."""
        return _DIVIDER.join((*self.menus, self.name))

    def run(self) -> None:
        """Do it, if it is still there."""
        if isValid(self.action):
            self.action.trigger()


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
            found.append(Entry.of(action, menus))
