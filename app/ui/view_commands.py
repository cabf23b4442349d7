"""The commands that change how panes are looked at and compared, and their menus."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject

from app.scene.camera import OBLIQUE, PRESETS
from app.ui.action_book import ActionBook
from app.ui.actions import COLOURS, COMPARED
from app.ui.cameras import Cameras
from app.ui.colour_bar_dialog import ColourBarDialog
from app.ui.montage_dialog import MontageDialog
from app.ui.palette import CommandPalette
from app.ui.preferences import open_preferences
from app.ui.shortcut_sheet import ShortcutSheet
from app.ui.shortcuts import Shortcuts
from app.ui.tab_commands import TabCommands

_HEAT_MAP = "vertex_rms"


class ViewCommands(QObject):
    """Handlers and menus, made before the actions and tied to them afterwards.

    Parameters
    ----------
    window : MainWindow
        The window.
    """

    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self._window = window
        self.cameras = Cameras(window)
        self.tabs = TabCommands(window)

    def handlers(self) -> dict[str, Callable[..., None]]:
        """What each command does, by id."""
        looks = {
            f"look_{key}": partial(self.cameras.look_from, name)
            for key, name in enumerate(PRESETS, start=1)
        }
        colours = {f"colour_{id_}": partial(self._colour_by, id_) for id_ in COLOURS}
        compared = {f"compare_{id_}": partial(self._compare, id_) for id_ in COMPARED}
        return (
            looks
            | colours
            | compared
            | self.tabs.handlers()
            | {
                "smooth_shading": partial(self._set, "smooth_shading", "Shading"),
                "edges": partial(self._set, "edges", "Edges"),
                "link": partial(self._set, "linked", "Link cameras"),
                "reset_view": partial(self.cameras.look_from, OBLIQUE),
                "copy_camera": self.cameras.copy,
                "paste_camera": self.cameras.paste,
                "save_camera": self.cameras.ask_for_name,
                "restore_camera": self.cameras.ask_which_to_restore,
                "forget_camera": self.cameras.ask_which_to_forget,
                "difference": lambda on: self._colour_by(_HEAT_MAP if on else "none"),
                "colour_bar": lambda: ColourBarDialog.open_for(self._window),
                "figure": lambda: MontageDialog.open_for(self._window),
                "palette": lambda: CommandPalette(self._window).show(),
                "shortcuts": self._show_shortcuts,
            }
        )

    def attach(self, book: ActionBook) -> None:
        """Tie the commands to their actions, once these are there."""
        window = self._window
        self._book = book
        self.shortcuts = Shortcuts(book)
        self.tabs.attach(book)
        window.denoise.viewport.bar_opened.connect(book["colour_bar"].trigger)
        self._camera_menu = book.menu("View/&Cameras")
        self._first_camera = len(self._camera_menu.actions())
        window.session.study_changed.connect(lambda *_: self.refresh())
        window.session.meshes_changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show the study in the menus."""
        view = self._window.session.study.view
        self.cameras.fill(self._camera_menu, first=self._first_camera)
        for command, on in (
            ("smooth_shading", view.smooth_shading),
            ("edges", view.edges),
            ("link", view.linked),
            ("difference", view.colour == _HEAT_MAP),
            (f"colour_{view.colour}", True),
            (f"compare_{view.compare_with}", True),
        ):
            self._book.check(command, on)

    def _compare(self, pane: str) -> None:
        self._set("compare_with", "Compare with", pane)
        self.tabs.follow_swipe()

    def _set(self, name: str, step: str, value: object) -> None:
        view = self._window.session.study.view.model_copy(update={name: value})
        self._window.change_view(step, view)

    def _colour_by(self, metric: str) -> None:
        self._window.change_view("Colour by", self._window.session.study.view.coloured_by(metric))

    def _show_shortcuts(self) -> None:
        change = partial(open_preferences, self._window, "Keyboard")
        ShortcutSheet(self._window, self.shortcuts, change).open()
