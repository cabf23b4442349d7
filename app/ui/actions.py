"""Every command of the window, declared once: menus, toolbar, shortcuts and tips come from here."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import qtawesome
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

from app.scene.camera import PRESETS


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
    Command("open", "File", "&Open…", "Open a model to compare the methods on, or a study",
            "Ctrl+O", "mdi6.folder-open-outline"),
    Command("open_study", "File", "Open St&udy…", "Open a study that was saved", "Ctrl+Alt+O"),
    Command("gallery", "File", "&Gallery…", "Bundled models, and PyVista's to download", "Ctrl+G"),
    Command("open_noisy", "File", "Separate &Noisy File…",
            "Use a noisy file of the same model instead of adding noise", "Ctrl+Shift+O"),
    Command("save_study", "File", "&Save Study", "Save the study: models, noise, methods, views",
            "Ctrl+S", "mdi6.content-save-outline", divided=True),
    Command("save_study_as", "File", "Save Study &As…", "Save the study under another name",
            "Ctrl+Shift+S"),
    Command("save_packed", "File", "Save Study Pac&ked…",
            "Save the study with its models inside, to give it away"),
    Command("save_mesh", "File/E&xport", "Denoised &Mesh…",
            "Save the mesh of the selected pane as PLY, OBJ, OFF or STL", "Ctrl+M"),
    Command("figure", "File/E&xport", "&Figure…",
            "Arrange panes with captions as PNG, PDF or TIFF, in centimetres", "Ctrl+Shift+F"),
    Command("screenshot", "File/E&xport", "&Screenshot…",
            "Save a pane, the grid or the window as PNG", "Ctrl+P", "mdi6.camera-outline"),
    Command("save_plot", "File/E&xport", "Error &Plot…", "Save the error plot as SVG, PDF or PNG",
            "Ctrl+E", divided=True),
    Command("save_table", "File/E&xport", "&Table…", "Save the table as CSV, Markdown or LaTeX",
            "Ctrl+Shift+E"),
    Command("quit", "File", "&Quit", "Close Burnish", "Ctrl+Q", divided=True),
    Command("undo", "Edit", "&Undo", "Take back the last step", "Ctrl+Z", "mdi6.undo"),
    Command("redo", "Edit", "&Redo", "Do the step again that was taken back", "Ctrl+Shift+Z",
            "mdi6.redo"),
    Command("copy_table", "Edit", "&Copy Table", "Copy the table as text", "Ctrl+Shift+C",
            divided=True),
    Command("copy_command", "Edit", "Copy as Command &Line",
            "Copy the command that carries out this study without a window"),
    Command("copy_script", "Edit", "Copy as Python &Script",
            "Copy a script that carries out this study with Burnish's core"),
    Command("copy_camera", "Edit", "Copy C&amera", "Copy where the camera stands, as text",
            "Ctrl+Alt+C"),
    Command("paste_camera", "Edit", "Paste Ca&mera", "Put the camera where a copied text says",
            "Ctrl+Alt+V"),
    Command("preferences", "Edit", "&Preferences…", "Memory, keys, defaults", "Ctrl+,",
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
    *(Command(f"look_{key}", "View/Look F&rom", name, f"Show the whole model: {name}", str(key))
      for key, name in enumerate(PRESETS, start=1)),
    Command("save_camera", "View/&Cameras", "&Save Camera…", "Save the camera under a name",
            "Ctrl+Alt+S"),
    Command("flicker", "View/Co&mpare Panes", "&Flicker (Hold the Key)",
            "While held, the selected pane shows the mesh it is compared with", "X"),
    Command("swipe", "View/Co&mpare Panes", "&Swipe Line",
            "Part one pane by a line to drag: left the one, right the other", "D",
            checkable=True),
    Command("difference", "View", "&Distance to the Original",
            "Heat map of each vertex' distance to where it was in the original", "H",
            checkable=True, divided=True),
    Command("colour_bar", "View", "Colour &Bar…",
            "Range, colours, direction and histogram of the heat map", "C"),
    Command("advance", "Run", "Five &More Iterations", "Run every checked method five steps on",
            "Ctrl+R", "mdi6.play-outline"),
    Command("cancel", "Run", "&Cancel", "Stop what is being computed", "Esc",
            "mdi6.stop-circle-outline"),
    Command("palette", "Help", "&Find a Command…", "Search all commands by name and run one",
            "Ctrl+Shift+P"),
    Command("shortcuts", "Help", "&Keyboard Shortcuts", "All keys and mouse gestures", "?"),
    Command("methods", "Help", "&Reference", "Formulas, parameters and sources", "F1",
            divided=True),
    Command("errata", "Help", "Where the &Printed Thesis Fails",
            "What Burnish does differently, and why"),
    Command("log", "Help", "Show the &Log File", "What happened, for a bug report"),
    Command("about", "Help", "&About Burnish", "Versions, for a bug report", divided=True),
)  # fmt: skip

TOOLBAR = ("open", None, "undo", "redo", None, "advance", "cancel", None, "link", "box_zoom", None,
           "screenshot")  # fmt: skip
"""Commands on the toolbar, with None for a gap."""

NEED_MODEL = ("save_study", "save_study_as", "save_packed", "save_mesh", "save_plot",
              "save_table", "screenshot", "advance", "copy_command", "copy_script")  # fmt: skip
"""Commands that need a model."""


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
        return self._menus[name]

    def key(self, command: str) -> QKeySequence:
        """Return the key of a command."""
        return self[command].shortcut()

    def set_key(self, command: str, key: QKeySequence) -> None:
        """Give a command a key, and tell it in the tooltip."""
        action = self[command]
        action.setShortcut(key)
        shown = key.toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(action.statusTip() + (f" ({shown})" if shown else ""))

    def set_icons(self, colour: str) -> None:
        """Draw the icons in the colour of the text."""
        for command in COMMANDS:
            if command.icon:
                self[command.id].setIcon(qtawesome.icon(command.icon, color=colour))

    def _make(self, command: Command, handler: Callable[..., None]) -> QAction:
        action = QAction(command.text, self._window, checkable=command.checkable)
        action.setObjectName(command.id)
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


def escaped(text: str) -> str:
    """Return a text as a menu shows it, an ampersand as itself."""
    return text.replace("&", "&&")
