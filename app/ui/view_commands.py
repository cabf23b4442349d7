"""The commands that change how panes are looked at and compared, and their menus."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QMenu

from app.scene.camera import PRESETS
from app.ui.actions import ActionBook
from app.ui.cameras import Cameras
from app.ui.colour_bar_dialog import ColourBarDialog
from app.ui.comparing import Flicker, SwipeLine
from app.ui.montage_dialog import MontageDialog
from app.ui.palette import CommandPalette
from app.ui.preferences import open_preferences
from app.ui.shortcut_sheet import ShortcutSheet
from app.ui.shortcuts import Shortcuts
from app.ui.value_probe import ValueProbe

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

    def handlers(self) -> dict[str, Callable[..., None]]:
        """What each command does, by id."""
        looks = {
            f"look_{key}": partial(self.cameras.look_from, name)
            for key, name in enumerate(PRESETS, start=1)
        }
        return looks | {
            "copy_camera": self.cameras.copy,
            "paste_camera": self.cameras.paste,
            "save_camera": self.cameras.ask_for_name,
            "flicker": self._start_flicker,
            "swipe": self._set_swipe,
            "difference": self._show_difference,
            "colour_bar": lambda: ColourBarDialog.open_for(self._window),
            "figure": lambda: MontageDialog.open_for(self._window),
            "palette": lambda: CommandPalette(self._window).show(),
            "shortcuts": self._show_shortcuts,
        }

    def attach(self, book: ActionBook) -> None:
        """Tie the commands to their actions, once these are there."""
        window = self._window
        self._book = book
        self.shortcuts = Shortcuts(book)
        self.flicker = Flicker(window.denoise, book["flicker"])
        self.swipe = SwipeLine(window.denoise, book["swipe"])
        self.probe = ValueProbe(window.denoise.viewport)
        self.probe.changed.connect(window.statusBar().show_place)
        self._compare_with = book.menu("View/Co&mpare Panes").addMenu("&With")
        self._compare_group = QActionGroup(self._compare_with)
        window.denoise.viewport.bar_opened.connect(book["colour_bar"].trigger)
        self._camera_menu = book.menu("View/&Cameras")
        self._panels = book.menu("View/P&anels")
        self._panels.aboutToShow.connect(self._fill_panels)
        window.denoise.selection_changed.connect(lambda _: self.swipe.refresh())
        window.session.study_changed.connect(lambda *_: self.refresh())
        window.session.meshes_changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show the study in the menus."""
        session = self._window.session
        self._fill_compare_with()
        self.cameras.fill(self._camera_menu, first=1)
        for command in ("figure", "flicker", "swipe", "copy_camera", "paste_camera", "save_camera"):
            self._book[command].setEnabled(session.meshes is not None)
        action = self._book["difference"]
        action.blockSignals(True)
        action.setChecked(session.study.view.colour == _HEAT_MAP)
        action.blockSignals(False)

    def _fill_compare_with(self) -> None:
        """Offer every pane as the one to compare with."""
        menu: QMenu = self._compare_with
        menu.clear()
        chosen = self._window.session.study.view.compare_with
        for pane in self._window.denoise.panes()[0]:
            action = menu.addAction(pane.title)
            action.setCheckable(True)
            action.setChecked(pane.id == chosen)
            self._compare_group.addAction(action)
            action.triggered.connect(lambda *_, id_=pane.id: self._compare(id_))

    def _fill_panels(self) -> None:
        """Offer the panels of the tab that is shown."""
        self._panels.clear()
        tab = self._window.tabs.currentWidget()
        for dock in getattr(tab, "docks", ()):
            self._panels.addAction(dock.toggleViewAction())
        if hasattr(tab, "reset_layout"):
            self._panels.addSeparator()
            self._panels.addAction("&Put All Back").triggered.connect(tab.reset_layout)

    def _compare(self, pane: str) -> None:
        view = self._window.session.study.view.model_copy(update={"compare_with": pane})
        self._window.change_view("Compare with", view)
        self.swipe.refresh()

    def _start_flicker(self) -> None:
        self.flicker.start()

    def _set_swipe(self, on: bool) -> None:
        self.swipe.set_on(on)

    def _show_difference(self, on: bool) -> None:
        view = self._window.session.study.view.coloured_by(_HEAT_MAP if on else "none")
        self._window.change_view("Colour by", view)

    def _show_shortcuts(self) -> None:
        change = partial(open_preferences, self._window, "Keyboard")
        ShortcutSheet(self._window, self.shortcuts, change).open()
