"""The main window: menus, toolbar, tabs and status bar around one session."""

from pathlib import Path

from PySide6.QtCore import QSettings
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QGuiApplication, QPalette
from PySide6.QtWidgets import QMainWindow, QTabWidget

from app.session import Session
from app.ui import dialogs, saving
from app.ui.action_book import ActionBook, escaped
from app.ui.actions import TABS
from app.ui.collecting import Collector
from app.ui.denoise_tab import DenoiseTab
from app.ui.desk import Desk
from app.ui.doctor_dialog import DoctorDialog
from app.ui.empty_panel import EmptyPanel
from app.ui.faults import FaultReports, show_log
from app.ui.floating_panels import FloatingPanels
from app.ui.help import show_about, show_errata, show_reference
from app.ui.preferences import open_preferences
from app.ui.preferences_general import kept_budget
from app.ui.skeleton_export import ask_for_film, ask_for_graph
from app.ui.skeleton_tab import SkeletonTab
from app.ui.statistics_saving import ask_for_bundle, ask_for_cell, ask_for_tables
from app.ui.statistics_tab import StatisticsTab
from app.ui.status import StatusBar
from app.ui.study_files import StudyFiles
from app.ui.surfaces import Uncovering
from app.ui.tasks import Poster
from app.ui.theme import current_theme
from app.ui.theme_choice import ThemeChoice
from app.ui.toolbar import fill_toolbar
from app.ui.view_commands import ViewCommands
from core.io import bundled_samples
from core.study import MOST_ITERATIONS, SAMPLE_PREFIX, Study
from core.view import ViewSettings

_MORE = 5
_GEOMETRY = "window_geometry"


class MainWindow(QMainWindow):
    """Burnish's window."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle("Burnish")
        self.setAcceptDrops(True)
        self._collector = Collector(self)
        Uncovering(self)
        self.session = Session(Poster(self))
        self.denoise = DenoiseTab(self.session, current_theme())
        self.skeleton = SkeletonTab(self.session, current_theme())
        self.statistics = StatisticsTab(self.session, current_theme())
        self.tabs = QTabWidget(documentMode=True)
        for tab, title in zip((self.denoise, self.skeleton, self.statistics), TABS, strict=True):
            self.tabs.addTab(tab, title)
        self.setCentralWidget(self.tabs)
        self.floating = FloatingPanels(self.tabs)
        self.files = StudyFiles(self)
        self.faults = FaultReports(self, self.files.autosave.write)
        self.view_commands = ViewCommands(self)
        self.theme = ThemeChoice(self, self._apply_theme)
        self.actions_ = ActionBook(self, self._handlers())
        book = self.actions_
        book.menu("File").insertMenu(book["gallery"], self.files.recent.menu)
        book.menu("View/&Colour by").addSeparator()
        book.menu("View/&Colour by").addAction(book["colour_bar"])
        self.skeleton.centre.exports.offer(book)
        menus = {
            "undo": ("Sample", book.menu("File/Open &Sample")),
            "screenshot": ("Colour by", book.menu("View/&Colour by")),
        }
        fill_toolbar(self, self.actions_, menus)
        self.setStatusBar(StatusBar(self.session, self.actions_["cancel"]))
        self.view_commands.attach(self.actions_)
        views = (self.denoise.viewport, self.skeleton.viewport, self.statistics.view)
        self.empty_panels = [EmptyPanel(self, view) for view in views]
        self._connect()
        self._restore()
        self._update_actions()

    @property
    def desks(self) -> tuple[Desk, ...]:
        """The tabs as the commands see them."""
        return self.denoise.desk, self.skeleton.desk, self.statistics.desk

    @property
    def desk(self) -> Desk:
        """The tab that is shown as the commands see it."""
        return self.desks[self.tabs.currentIndex()]

    def open_model(self, model: str) -> None:
        """Open a model by its path or, as ``sample:ID``, a bundled one."""
        self.files.open(model)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.files.may_close():
            event.ignore()
            return
        self.session.close()
        self.files.close()
        QSettings().setValue(_GEOMETRY, self.saveGeometry())
        self.floating.show_all()
        self.denoise.save_layout()
        self.skeleton.save_layout()
        self.statistics.save_layout()
        self.denoise.close_graphics()
        self.skeleton.close_graphics()
        self.statistics.close_graphics()
        self._collector.close()
        super().closeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if self.files.may_drop(event.mimeData()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        if self.files.drop(event.mimeData()):
            event.acceptProposedAction()

    def changeEvent(self, event: object) -> None:
        super().changeEvent(event)
        if event.type() == event.Type.PaletteChange and hasattr(self, "actions_"):
            self._apply_theme()

    def _handlers(self) -> dict[str, object]:
        session, statistics = self.session, self.statistics
        samples = {
            f"sample_{id_}": lambda id_=id_: self.open_model(SAMPLE_PREFIX + id_)
            for id_ in (sample.id for sample in bundled_samples())
        }
        plots = {
            f"save_plot_{id_}": lambda id_=id_: ask_for_cell(statistics, id_)
            for id_ in statistics.plots
        }
        return {
            **self.files.handlers(),
            **self.view_commands.handlers(),
            **self.theme.handlers(),
            **samples,
            **plots,
            "save_matrix": lambda: ask_for_cell(statistics, "matrix"),
            "save_statistics": lambda: ask_for_bundle(statistics),
            "save_graph": lambda: ask_for_graph(self.skeleton),
            "save_film": lambda: ask_for_film(self.skeleton),
            "preferences": lambda: open_preferences(self),
            "log": lambda: show_log(self),
            "open_noisy": self._ask_for_noisy,
            "save_mesh": lambda: saving.ask_for_mesh(self),
            "save_plot": self._ask_for_plot,
            "save_table": self._ask_for_table,
            "screenshot": lambda: saving.ask_for_screenshot(self),
            "quit": self.close,
            "undo": session.undo,
            "redo": session.redo,
            "doctor": lambda: DoctorDialog.open_for(self),
            "copy_table": self.denoise.table.copy,
            "advance": self._advance,
            "cancel": session.cancel,
            "tasks": lambda: self.statusBar().open_list(),
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
        self.statusBar().busy_changed.connect(self._update_actions)
        session.failed.connect(lambda message: dialogs.tell(self, message))
        session.broken.connect(self.faults.report)
        self.denoise.noisy_file_requested.connect(self._ask_for_noisy)
        self.denoise.model.doctor_requested.connect(lambda: DoctorDialog.open_for(self))

    # -- changes

    def change_view(self, step: str, view: ViewSettings) -> None:
        """Look at the meshes in another way, as an undoable step."""
        self.session.apply(self.session.study.model_copy(update={"view": view}), step)

    def _ask_for_plot(self) -> None:
        """Ask where to save the error plot, or the large plot of the Statistics tab."""
        if self.tabs.currentWidget() is self.statistics:
            large = self.statistics.enlarged or next(iter(self.statistics.plots))
            ask_for_cell(self.statistics, large)
        else:
            saving.ask_for_plot(self)

    def _ask_for_table(self) -> None:
        if self.tabs.currentWidget() is self.statistics:
            ask_for_tables(self.statistics)
        else:
            saving.ask_for_table(self)

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
        history = session.history
        for command, word, name in (
            ("undo", "Undo", history.undo_name),
            ("redo", "Redo", history.redo_name),
        ):
            book[command].setEnabled(name is not None)
            book[command].setText(f"&{word} {escaped(name)}" if name else f"&{word}")
        busy = session.activity is not None or self.statusBar().is_busy
        book["cancel"].setEnabled(busy)

    def _update_title(self) -> None:
        self.setWindowTitle(self.files.title)

    def _apply_theme(self) -> None:
        self.theme.show(self.actions_)
        self.actions_.set_icons(self.palette().color(QPalette.ColorRole.WindowText).name())
        self.denoise.set_theme(current_theme())
        self.skeleton.set_theme(current_theme())
        self.statistics.set_theme(current_theme())

    def apply_preferences(self) -> None:
        """Take on what is kept of the preferences."""
        self.theme.refresh()
        self.session.set_budget(kept_budget())
        self.view_commands.shortcuts.load()

    def _restore(self) -> None:
        self.apply_preferences()
        geometry = QSettings().value(_GEOMETRY)
        if geometry is None or not self.restoreGeometry(geometry):
            available = QGuiApplication.primaryScreen().availableSize()
            self.resize(available.boundedTo(self.sizeHint().expandedTo(available * 0.9)))
