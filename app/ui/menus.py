"""Menus of choices, and the toolbar."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QMainWindow, QMenu, QToolButton, QWidget

from app.ui.actions import TOOLBAR, ActionBook

_INSTANT = QToolButton.ToolButtonPopupMode.InstantPopup


def choice_menu(
    parent: QWidget, title: str, names: Mapping[str, str], use: Callable[..., None]
) -> QMenu:
    """Make a menu of which one entry is checked; each entry's data is its key."""
    menu = QMenu(title, parent)
    group = QActionGroup(menu)
    for key, name in names.items():
        action = menu.addAction(name)
        action.setCheckable(True)
        action.setData(key)
        group.addAction(action)
        action.triggered.connect(partial(use, key))
    return menu


def fill_toolbar(
    window: QMainWindow, book: ActionBook, menus: Mapping[str, tuple[str, QMenu]]
) -> None:
    """Make the toolbar: the commands, and buttons that open a menu, each before a command.

    `menus` has the text of a button and its menu, by the command after it.
    """
    bar = window.addToolBar("Toolbar")
    bar.setObjectName("toolbar")
    bar.setMovable(False)
    for command in TOOLBAR:
        if command is None:
            bar.addSeparator()
        else:
            bar.addAction(book[command])
    for command, (text, menu) in menus.items():
        button = QToolButton(text=text, popupMode=_INSTANT)
        button.setMenu(menu)
        bar.insertWidget(book[command], button)
