"""The main window: menus, toolbar, tabs and status bar around one session."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QSettings
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QGuiApplication,
    QPalette,
)
from PySide6.QtWidgets import QMainWindow, QMenu, QTabWidget

from app.session import Session
from app.ui import dialogs, saving
from app.ui.actions import NEED_MODEL, ActionBook, escaped
from app.ui.denoise_tab import DenoiseTab
from app.ui.empty_panel import EmptyPanel
from app.ui.faults import FaultReports, show_log
from app.ui.help import show_about, show_errata, show_reference
from app.ui.menus import choice_menu, fill_toolbar
from app.ui.preferences import open_preferences
from app.ui.preferences_general import kept_budget
from app.ui.skeleton_export import ask_for_picture
from app.ui.skeleton_tab import SkeletonTab
from app.ui.statistics_tab import StatisticsTab
from app.ui.status import StatusBar
from app.ui.study_files import StudyFiles, dropped_file
from app.ui.tasks import Poster
from app.ui.theme import current_theme, set_mode
from app.ui.view_commands import ViewCommands
from core.io import bundled_samples
from core.metrics import METRICS
from core.study import MOST_ITERATIONS, SAMPLE_PREFIX, Study
from core.view import ViewSettings

_MORE = 5
_GEOMETRY = "window_geometry"
_MODE = "theme_mode"


class MainWindow(QMainWindow):
    """Burnish's window."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle("Burnish")
        self.setAcceptDrops(True)
        self.session = Session(Poster(self))
        self.denoise = DenoiseTab(self.session, current_theme())
        self.tabs = QTabWidget(documentMode=True)
        self.tabs.addTab(self.denoise, "Denoise")
        self.skeleton = SkeletonTab(self.session, current_theme())
        self.tabs.addTab(self.skeleton, "Skeleton")
        self.statistics = StatisticsTab(self.session, current_theme())
        self.tabs.addTab(self.statistics, "Statistics")
        self.setCentralWidget(self.tabs)
        self.files = StudyFiles(self)
        self.faults = FaultReports(self)
        self.view_commands = ViewCommands(self)
        self.actions_ = ActionBook(self, self._handlers())
        self._fill_menus()
        menus = {"undo": ("Sample", self._samples), "screenshot": ("Colour by", self._colours)}
        fill_toolbar(self, self.actions_, menus)
        self.setStatusBar(StatusBar(self.session, self.actions_["cancel"]))
        self.view_commands.attach(self.actions_)
        self.empty_panel = EmptyPanel(self, self.denoise.viewport)
        self._connect()
        self._restore()
        self._update_actions()

    def open_model(self, model: str) -> None:
        """Open a model by its path or, as ``sample:ID``, a bundled one."""
        self.files.open(model)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.files.may_close():
            event.ignore()
            return
        self.files.close()
        QSettings().setValue(_GEOMETRY, self.saveGeometry())
        self.denoise.save_layout()
        self.skeleton.save_layout()
        self.statistics.save_layout()
        self.session.close()
        self.denoise.close_graphics()
        self.skeleton.close_graphics()
        self.statistics.close_graphics()
        super().closeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if dropped_file(event.mimeData()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        if name := dropped_file(event.mimeData()):
            self.files.open(name)
            event.acceptProposedAction()

    def changeEvent(self, event: object) -> None:
        super().changeEvent(event)
        if event.type() == event.Type.PaletteChange and hasattr(self, "actions_"):
            self._apply_theme()

    def _handlers(self) -> dict[str, object]:
        viewport, session = self.denoise.viewport, self.session
        return {
            **self.files.handlers(),
            "preferences": lambda: open_preferences(self),
            "log": show_log,
            **self.view_commands.handlers(),
            "open_noisy": self._ask_for_noisy,
            "save_mesh": lambda: saving.ask_for_mesh(self),
            "save_plot": lambda: saving.ask_for_plot(self),
            "save_table": lambda: saving.ask_for_table(self),
            "screenshot": self._ask_for_screenshot,
            "quit": self.close,
            "undo": session.undo,
            "redo": session.redo,
            "copy_table": self.denoise.table.copy,
            "smooth_shading": partial(self._set_view, "smooth_shading", "Shading"),
            "edges": partial(self._set_view, "edges", "Edges"),
            "link": partial(self._set_view, "linked", "Link cameras"),
            "enlarge": lambda: viewport.toggle_enlarged(self.denoise.selected or "noisy"),
            "reset_view": lambda: self.view_commands.cameras.look_from("Oblique"),
            "box_zoom": viewport.start_box_zoom,
            "fly": viewport.fly_to_cursor,
            "advance": self._advance,
            "cancel": session.cancel,
            "methods": lambda: show_reference(self),
            "errata": lambda: show_errata(self),
            "about": lambda: show_about(self),
        }

    def _connect(self) -> None:
        session = self.session
        session.study_changed.connect(lambda *_: self._update_actions())
        self.files.documents.changed.connect(self._update_title)
        session.study_changed.connect(lambda *_: self._update_title())
        session.activity_changed.connect(self._update_actions)
        session.failed.connect(lambda message: dialogs.tell(self, message))
        session.broken.connect(self.faults.report)
        self.denoise.viewport.box_zoom_ended.connect(
            lambda: self.actions_["box_zoom"].setChecked(False)
        )
        self.denoise.noisy_file_requested.connect(self._ask_for_noisy)
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._follow_system)

    # -- menus

    def _fill_menus(self) -> None:
        samples = QMenu("Open &Sample", self)
        for sample in bundled_samples():
            action = samples.addAction(sample.title)
            action.triggered.connect(lambda *_, id_=sample.id: self.open_model(SAMPLE_PREFIX + id_))
        file_menu = self.actions_.menu("File")
        file_menu.insertMenu(self.actions_["open_noisy"], samples)
        file_menu.insertMenu(self.actions_["gallery"], self.files.recent.menu)
        self._samples = samples
        view = self.actions_.menu("View")
        view.addSeparator()
        self._colours = choice_menu(self, "&Colour by", self._colour_names(), self._set_colour)
        self._colours.addSeparator()
        self._colours.addAction(self.actions_["colour_bar"])
        view.addMenu(self._colours)
        view.addSeparator()
        modes = {mode: mode.capitalize() for mode in ("system", "light", "dark")}
        self._themes = choice_menu(self, "&Theme", modes, self._set_mode)
        view.addMenu(self._themes)

    # -- changes

    def change_view(self, step: str, view: ViewSettings) -> None:
        """Look at the meshes in another way, as an undoable step."""
        self.session.apply(self.session.study.model_copy(update={"view": view}), step)

    def _set_view(self, name: str, step: str, value: object) -> None:
        self.change_view(step, self.session.study.view.model_copy(update={name: value}))

    def _set_colour(self, metric: str, *_: object) -> None:
        self.change_view("Colour by", self.session.study.view.coloured_by(metric))

    @staticmethod
    def _colour_names() -> dict[str, str]:
        return {"none": "Nothing", **{id_: spec.heat_title for id_, spec in METRICS.items()}}

    def _ask_for_screenshot(self) -> None:
        if self.tabs.currentWidget() is self.skeleton:
            ask_for_picture(self.skeleton)
        else:
            saving.ask_for_screenshot(self)

    def _ask_for_noisy(self) -> None:
        def use(path: Path) -> None:
            study = self.session.study.model_copy(update={"noisy": str(path)})
            self.session.apply(study, "Noisy file")

        dialogs.ask_for_file(self, "Open a noisy file of the same model", use)

    def _advance(self) -> None:
        """Ask every checked method for a few iterations more."""
        study: Study = self.session.study
        for choice in study.methods:
            if choice.enabled:
                more = min(choice.iterations + _MORE, MOST_ITERATIONS)
                study = study.with_choice(choice.model_copy(update={"iterations": more}))
        self.session.apply(study, "More iterations")

    # -- listening

    def _update_actions(self) -> None:
        book, session = self.actions_, self.session
        view, history = session.study.view, session.history
        for command, value in (
            ("smooth_shading", view.smooth_shading),
            ("edges", view.edges),
            ("link", view.linked),
        ):
            book[command].blockSignals(True)
            book[command].setChecked(value)
            book[command].blockSignals(False)
        for command, word, name in (
            ("undo", "Undo", history.undo_name),
            ("redo", "Redo", history.redo_name),
        ):
            book[command].setEnabled(name is not None)
            book[command].setText(f"&{word} {escaped(name)}" if name else f"&{word}")
        book["cancel"].setEnabled(session.activity is not None)
        for command in NEED_MODEL:
            book[command].setEnabled(session.meshes is not None)
        for action in self._colours.actions():
            action.setChecked(action.data() == view.colour)

    def _update_title(self) -> None:
        self.setWindowTitle(self.files.title)

    def _set_mode(self, mode: str, *_: object) -> None:
        QSettings().setValue(_MODE, mode)
        set_mode(mode)
        self._apply_theme()

    def _follow_system(self, _: object) -> None:
        """Change colours with the desktop, unless a person has chosen."""
        if QSettings().value(_MODE, "system") == "system":
            self._set_mode("system")

    def _apply_theme(self) -> None:
        for action in self._themes.actions():
            action.setChecked(action.data() == QSettings().value(_MODE, "system"))
        self.actions_.set_icons(self.palette().color(QPalette.ColorRole.WindowText).name())
        self.denoise.set_theme(current_theme())
        self.skeleton.set_theme(current_theme())
        self.statistics.set_theme(current_theme())

    def apply_preferences(self) -> None:
        """Take on what is kept of the preferences."""
        self._set_mode(str(QSettings().value(_MODE, "system")))
        self.session.set_budget(kept_budget())
        self.view_commands.shortcuts.load()

    def _restore(self) -> None:
        self.apply_preferences()
        geometry = QSettings().value(_GEOMETRY)
        if geometry is None or not self.restoreGeometry(geometry):
            available = QGuiApplication.primaryScreen().availableSize()
            self.resize(available.boundedTo(self.sizeHint().expandedTo(available * 0.9)))
