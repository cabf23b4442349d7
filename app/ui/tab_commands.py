"""The commands that act on the tab that is shown, whichever it is."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QDockWidget

from app.ui.action_book import ActionBook
from app.ui.actions import COMMANDS, NEED_MODEL, PANELS, TABS
from app.ui.comparing import Flicker, SwipeLine
from app.ui.desk import NO_MODEL
from app.ui.value_probe import ValueProbe
from core.smoothing import METHODS

_NO_PANELS = "This tab has no panels that can be hidden."
_NO_CAMERA = "No camera has been saved."
_KINDS = ("colour", "compare")


class TabCommands(QObject):
    """Asks the desk of the tab that is shown; what it cannot do is switched off, with the reason.

    Parameters
    ----------
    window : MainWindow
        The window.
    """

    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self._window = window

    def handlers(self) -> dict[str, Callable[..., None]]:
        """What each command does, by id."""
        window = self._window
        panels = {f"panel_{title}": partial(self._show_panel, title) for title in PANELS}
        tabs = {
            f"tab_{place + 1}": partial(window.tabs.setCurrentIndex, place)
            for place in range(len(TABS))
        }
        return (
            panels
            | tabs
            | {
                "flicker": self._start_flicker,
                "swipe": self._set_swipe,
                "enlarge": self._enlarge,
                "box_zoom": self._start_box_zoom,
                "fly": self._fly,
                "reset_panels": self._reset_panels,
            }
        )

    def attach(self, book: ActionBook) -> None:
        """Tie the commands to their actions, once these are there."""
        window, self._book = self._window, book
        self.flicker = Flicker(window, book["flicker"])
        self.probes = [ValueProbe(desk) for desk in window.desks]
        self.lines = [SwipeLine(desk) for desk in window.desks]
        for desk, probe in zip(window.desks, self.probes, strict=True):
            probe.changed.connect(window.statusBar().show_place)
            desk.gestures.box_zoom_ended.connect(lambda: book.check("box_zoom", False))
            desk.changed.connect(self.refresh)
        for title in PANELS:
            self._panel(title).visibilityChanged.connect(lambda _: self._show_panels())
        window.tabs.currentChanged.connect(self._on_tab_changed)
        window.denoise.selection_changed.connect(self.follow_swipe)
        window.session.study_changed.connect(lambda *_: self.refresh())
        window.session.meshes_changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Switch every command on or off, as the tab that is shown can do it now."""
        for command in COMMANDS:
            if command.id in NEED_MODEL or self._depends_on_tab(command.id):
                self._book.allow(command.id, self._obstacle(command.id))
        self._book.check(f"tab_{self._window.tabs.currentIndex() + 1}", True)
        self._book.check("swipe", self._window.desk.swipe_line is not None)
        self._show_panels()

    def follow_swipe(self, *_: object) -> None:
        """Let a swipe follow a change of the panes, of the selection or of the study."""
        desk = self._window.denoise.desk
        if desk.swipe_line is not None:
            desk.set_swipe(True)
        self._book.check("swipe", self._window.desk.swipe_line is not None)

    def _depends_on_tab(self, command: str) -> bool:
        return (
            command.startswith(("colour_", "compare_", "panel_"))
            or any(command in desk.lacks for desk in self._window.desks)
            or command == "reset_panels"
        )

    def _obstacle(self, command: str) -> str:
        """Why a command cannot be used now."""
        window = self._window
        title = PANELS.get(command.removeprefix("panel_"))
        if title is not None:
            here = TABS[window.tabs.currentIndex()] == title
            return "" if here else f"This panel is on the {title} tab."
        if command == "reset_panels":
            can = hasattr(window.tabs.currentWidget(), "reset_layout")
            return "" if can else _NO_PANELS
        if command in NEED_MODEL and window.session.meshes is None:
            return NO_MODEL
        kind = command.partition("_")[0]
        is_choice = kind in _KINDS and command != "colour_bar"
        return str(window.desk.obstacle(kind if is_choice else command)) or self._missing(command)

    def _missing(self, command: str) -> str:
        """What a command needs of the study and is not there."""
        study = self._window.session.study
        if command in {"restore_camera", "forget_camera"} and not study.view.cameras:
            return _NO_CAMERA
        method = command.removeprefix("compare_")
        if command != method and method in METHODS and not study.choice(method).enabled:
            return f"{METHODS[method].title} is not checked on the Denoise tab."
        return ""

    def _start_flicker(self) -> None:
        self.flicker.start()

    def _set_swipe(self, on: bool) -> None:
        self._window.desk.set_swipe(on)
        for line in self.lines:
            line.set_cursor(False)

    def _enlarge(self) -> None:
        self._window.desk.enlarge()

    def _start_box_zoom(self, on: bool) -> None:
        self._window.desk.gestures.start_box_zoom(on)

    def _fly(self) -> None:
        self._window.desk.gestures.fly_to_cursor()

    def _reset_panels(self) -> None:
        self._window.tabs.currentWidget().reset_layout()

    def _on_tab_changed(self, _: int) -> None:
        for desk in self._window.desks:
            desk.gestures.start_box_zoom(False)
        self._book.check("box_zoom", False)
        self.refresh()

    def _panel(self, title: str) -> QDockWidget:
        tabs = dict(zip(TABS, (self._window.tabs.widget(i) for i in range(len(TABS))), strict=True))
        docks = tabs[PANELS[title]].docks
        return next(dock for dock in docks if dock.windowTitle() == title)

    def _show_panel(self, title: str, on: bool) -> None:
        self._panel(title).setVisible(on)

    def _show_panels(self) -> None:
        """Check the panels that are shown; only those of this tab stand in the menu."""
        here = TABS[self._window.tabs.currentIndex()]
        for title, tab in PANELS.items():
            self._book[f"panel_{title}"].setVisible(tab == here)
            self._book.check(f"panel_{title}", not self._panel(title).isHidden())
