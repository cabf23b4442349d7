"""Every command of the window, declared once: menus, toolbar, shortcuts and tips come from here."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import qtawesome
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu


@dataclass(frozen=True)
class Command:
    """A command: its name, its place in the menus, its key and what it does.

    Attributes
    ----------
    id : str
        Name in code.
    menu : str
        Menu it stands in; submenus after a slash.
    text : str
        Name in the menu.
    tip : str
        One line for the tooltip and the status bar.
    key : str
        Shortcut.
    icon : str
        Name of a qtawesome icon, for commands on the toolbar.
    checkable : bool
        Whether it switches something on and off.
    divided : bool
        Whether a line stands above it in the menu.
    """

    id: str
    menu: str
    text: str
    tip: str
    key: str = ""
    icon: str = ""
    checkable: bool = False
    divided: bool = False


COMMANDS = (
    Command("open", "File", "&Open…", "Open a model to compare the methods on", "Ctrl+O",
            "mdi6.folder-open-outline"),
    Command("open_noisy", "File", "Separate &Noisy File…",
            "Use a noisy file of the same model instead of adding noise", "Ctrl+Shift+O"),
    Command("save_mesh", "File", "&Save Denoised Mesh…",
            "Save the mesh of the selected pane as PLY, OBJ, OFF or STL", "Ctrl+S", divided=True),
    Command("save_plot", "File", "Export &Plot…", "Save the error plot as SVG, PDF or PNG",
            "Ctrl+E"),
    Command("save_table", "File", "Export &Table…", "Save the table as CSV, Markdown or LaTeX",
            "Ctrl+Shift+E"),
    Command("screenshot", "File", "S&creenshot…", "Save a pane, the grid or the window as PNG",
            "Ctrl+P", "mdi6.camera-outline"),
    Command("quit", "File", "&Quit", "Close Burnish", "Ctrl+Q", divided=True),
    Command("undo", "Edit", "&Undo", "Take back the last step", "Ctrl+Z", "mdi6.undo"),
    Command("redo", "Edit", "&Redo", "Do the step again that was taken back", "Ctrl+Shift+Z",
            "mdi6.redo"),
    Command("copy_table", "Edit", "&Copy Table", "Copy the table as text", "Ctrl+Shift+C",
            divided=True),
    Command("smooth_shading", "View", "&Smooth Shading", "Smooth shading; off shows flat faces",
            "S", checkable=True),
    Command("edges", "View", "&Edges", "Draw the edges of the triangles", "W", checkable=True),
    Command("link", "View", "&Link Cameras", "Move the cameras of all panes together", "L",
            "mdi6.link-variant", checkable=True),
    Command("enlarge", "View", "Enlarge &Pane", "Enlarge the selected pane, or bring all back",
            "E", divided=True),
    Command("reset_view", "View", "&Whole Model", "Show the whole model again", "R"),
    Command("box_zoom", "View", "&Box Zoom", "Drag a rectangle to zoom into", "B",
            "mdi6.magnify-scan", checkable=True),
    Command("fly", "View", "&Fly to Cursor", "Fly to the point under the cursor", "F"),
    Command("advance", "Run", "Five &More Iterations", "Run every checked method five steps on",
            "Ctrl+R", "mdi6.play-outline"),
    Command("cancel", "Run", "&Cancel", "Stop what is being computed", "Esc",
            "mdi6.stop-circle-outline"),
    Command("methods", "Help", "&Methods and Metrics", "Formulas, parameters and sources", "F1"),
    Command("errata", "Help", "Where the &Printed Thesis Fails",
            "What Burnish does differently, and why"),
    Command("about", "Help", "&About Burnish", "Versions, for a bug report", divided=True),
)  # fmt: skip

TOOLBAR = ("open", None, "undo", "redo", None, "advance", "cancel", None, "link", "box_zoom", None,
           "screenshot")  # fmt: skip
"""Commands on the toolbar, with None for a gap."""


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
        self._actions = {
            command.id: self._make(command, handlers[command.id]) for command in COMMANDS
        }

    def __getitem__(self, command: str) -> QAction:
        """Return the action of a command."""
        return self._actions[command]

    def menu(self, name: str) -> QMenu:
        """Return a menu of the menu bar, made where it is not there yet."""
        if name not in self._menus:
            self._menus[name] = self._window.menuBar().addMenu(f"&{name}")
        return self._menus[name]

    def set_icons(self, colour: str) -> None:
        """Draw the icons in the colour of the text."""
        for command in COMMANDS:
            if command.icon:
                self[command.id].setIcon(qtawesome.icon(command.icon, color=colour))

    def _make(self, command: Command, handler: Callable[..., None]) -> QAction:
        action = QAction(command.text, self._window, checkable=command.checkable)
        action.setObjectName(command.id)
        action.setShortcut(QKeySequence(command.key))
        key = f" ({action.shortcut().toString()})" if command.key else ""
        action.setToolTip(command.tip + key)
        action.setStatusTip(command.tip)
        if command.checkable:
            action.toggled.connect(handler)
        else:
            action.triggered.connect(lambda *_: handler())
        menu = self.menu(command.menu)
        if command.divided:
            menu.addSeparator()
        menu.addAction(action)
        return action
