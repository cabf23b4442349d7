"""The toolbar."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMainWindow, QMenu, QToolButton

from app.ui.action_book import ActionBook
from app.ui.actions import TOOLBAR

_INSTANT = QToolButton.ToolButtonPopupMode.InstantPopup


def fill_toolbar(
    window: QMainWindow, book: ActionBook, menus: Mapping[str, tuple[str, QMenu]]
) -> None:
    """Make the toolbar: the commands, and buttons that open a menu, each before a command.

    `menus` has the text of a button and its menu, by the command after it.
    """
    bar = window.addToolBar("Toolbar")
    bar.setObjectName("toolbar")
    bar.setMovable(False)
    # A menu on the right button would hide it, and nothing on the window would bring it back.
    window.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
    for command in TOOLBAR:
        if command is None:
            bar.addSeparator()
        else:
            bar.addAction(book[command])
    for command, (text, menu) in menus.items():
        button = QToolButton(text=text, popupMode=_INSTANT)
        button.setMenu(menu)
        bar.insertWidget(book[command], button)
