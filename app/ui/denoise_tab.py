"""The Denoise tab: panes in the middle, panels around them."""

import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QByteArray, QSettings, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QDockWidget, QMainWindow, QWidget

from app.scene.camera import OBLIQUE
from app.scene.colours import Theme
from app.scene.comparing import pair, swapped
from app.scene.comparison import ComparisonScene
from app.scene.marks import close_up
from app.scene.panes import Look, Pane
from app.session import Session
from app.ui.denoise_desk import DenoiseDesk
from app.ui.error_plot import ErrorPlot
from app.ui.methods_panel import MethodsPanel
from app.ui.model_panel import ModelPanel
from app.ui.results_table import ResultsTable
from app.ui.turns import Turns, Work
from app.ui.viewport import Viewport
from core.mesh import TriangleMesh
from core.smoothing import METHODS
from core.study import Study

_REDRAW_MS = 30
_BOTTOM_HEIGHT = 230
_PAUSE = 4
LEFT_WIDTH = 240
_LAYOUT = "denoise_layout"


class DenoiseTab(QMainWindow):
    """Compares denoisers side by side.

    Parameters
    ----------
    session : Session
        The state; the tab only listens and pushes studies.
    theme : Theme
        Colours to begin with.
    """

    noisy_file_requested = Signal()
    selection_changed = Signal(str)

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self.session = session
        self.selected: str | None = None
        self.flicker: tuple[str, str] | None = None
        self._theme = theme
        self._scene = ComparisonScene(session)
        self._fresh_model = True
        self._marks: tuple[TriangleMesh, np.ndarray] | None = None
        self._laid_out = False
        self._busy = False
        self._redraw_timer = QTimer(self, singleShot=True, interval=_REDRAW_MS)
        self._turns = Turns(self)
        self._redrawing = Work(self._turns, self._redraw_in_turn)
        self._redraw_timer.timeout.connect(self._redrawing.request)
        self._make_panels()
        self.desk = DenoiseDesk(self, self.viewport)
        self._connect()
        self.set_theme(theme)

    def panes(self) -> tuple[list[Pane], Look]:
        """Return what the viewport shows."""
        panes = self._scene.panes()
        scale = self.devicePixelRatioF()
        look = self._scene.look(panes, self._theme, self.selected, scale)
        return panes, replace(look, marks=self._marked())

    def show_marks(self, vertices: np.ndarray | None) -> None:
        """Point out vertices of the model and go close to them; None takes the dots away."""
        meshes = self.session.meshes
        self._marks = None
        if vertices is not None and meshes is not None:
            mesh = meshes.comparison.original
            self._marks = mesh, vertices
            self.viewport.set_pose(close_up(mesh, vertices, self.viewport.pose))
        self._redrawing.request()

    def _marked(self) -> np.ndarray | None:
        """Vertices that are pointed out, as long as the mesh is the one that they belong to."""
        meshes = self.session.meshes
        known = self._marks and meshes and self._marks[0] is meshes.comparison.original
        return self._marks[1] if known else None

    def set_flicker(self, on: bool) -> None:
        """Show another pane's mesh in the selected pane, or its own again."""
        grid = self.viewport.grid
        chosen = grid.enlarged or self.selected
        before, other = self.flicker, self.session.study.view.compare_with
        self.flicker = pair(grid.ids, chosen, other) if on else None
        if self.flicker != before:
            self._redraw()

    @property
    def is_drawn(self) -> bool:
        """Whether the viewport shows the current state."""
        waits = self._redraw_timer.isActive() or self._redrawing.is_active
        return not (waits or self.viewport.is_drawing)

    def select(self, pane: str | None) -> None:
        """Mark a pane, and its method in panel, plot and table."""
        if pane == self.selected:
            return
        self.selected = pane
        method = pane if pane in METHODS else None
        for view in (self.methods, self.plot, self.table):
            view.set_selected(method)
        self._redrawing.request()
        self.selection_changed.emit(pane or "")

    def set_theme(self, theme: Theme) -> None:
        """Draw panes and plot in a theme's colours."""
        self._theme = theme
        self.plot.set_theme(theme)
        self._redrawing.request()

    def save_layout(self) -> None:
        """Remember where the panels are."""
        QSettings().setValue(_LAYOUT, self.saveState())

    def save_plot(self, path: Path) -> None:
        """Save the error plot."""
        self.plot.save(path)

    def reset_layout(self) -> None:
        """Put all panels back where they were at the first start."""
        for dock, area in self._areas.items():
            dock.setFloating(False)
            self.addDockWidget(area, dock)
            dock.show()
        self._size_docks()

    def close_graphics(self) -> None:
        """Release the graphics before the window goes."""
        self._redraw_timer.stop()
        self._turns.stop()
        self.desk.gestures.stop()
        self.viewport.close_interactor()

    def _make_panels(self) -> None:
        self.viewport = Viewport(self._turns)
        self.setCentralWidget(self.viewport)
        self.model = ModelPanel(self.session)
        self.model.setMinimumWidth(LEFT_WIDTH)
        self.methods = MethodsPanel(self.session)
        self.plot = ErrorPlot(self.session, self._turns)
        self.table = ResultsTable(self.session, self._turns)
        self.setDockNestingEnabled(True)
        self._areas: dict[QDockWidget, Qt.DockWidgetArea] = {}
        left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        bottom = Qt.DockWidgetArea.BottomDockWidgetArea
        self.setCorner(Qt.Corner.BottomRightCorner, right)
        docks = [
            self._dock("Model and noise", self.model, left),
            self._dock("Methods", self.methods, right),
            self._dock("Error", self.plot, bottom),
            self._dock("Table", self.table, bottom),
        ]
        self.docks = docks

    def _dock(self, title: str, widget: QWidget, area: Qt.DockWidgetArea) -> QDockWidget:
        dock = QDockWidget(title, self)
        dock.setObjectName(title)
        dock.setWidget(widget)
        self.addDockWidget(area, dock)
        self._areas[dock] = area
        return dock

    def _connect(self) -> None:
        self.session.study_changed.connect(self._on_study_changed)
        self.session.meshes_changed.connect(self._redrawing.request)
        self.session.run_changed.connect(self._on_run_changed)
        self.session.activity_changed.connect(self._on_activity_changed)
        for view in (self.viewport, self.methods, self.plot, self.table):
            view.selected.connect(self.select)
        self.model.noisy_file_requested.connect(self.noisy_file_requested)

    def _on_run_changed(self, _: str) -> None:
        """Redraw soon, but leave the worker most of the time: drawing keeps it waiting."""
        if not self._redraw_timer.isActive():
            view = self.viewport
            until = view.drawn_at + _PAUSE * view.draw_seconds if self.session.activity else 0.0
            pause = round(1000 * (until - time.perf_counter()))
            self._redraw_timer.start(max(_REDRAW_MS, pause))

    def _on_activity_changed(self) -> None:
        was_busy, self._busy = self._busy, self.session.activity is not None
        if was_busy and not self._busy:
            self._redrawing.request()

    def _on_study_changed(self, study: Study, before: Study) -> None:
        if study.compares_like(before):
            return
        self._fresh_model |= study.model != before.model
        self._redrawing.request()

    def _redraw_in_turn(self) -> Iterator[None]:
        while self.viewport.is_drawing:  # else a slider that is dragged would keep it from ending
            yield
        self._redraw()

    def _redraw(self) -> None:
        panes, look = self.panes()
        if not panes:
            return
        if self.flicker:
            panes = swapped(panes, *self.flicker)
        self.viewport.show_panes(panes, look)
        self.viewport.set_linked(self.session.study.view.linked, self.selected)
        if self._fresh_model:
            self._fresh_model = False
            self.viewport.look_from(OBLIQUE)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if not self._laid_out:
            self._laid_out = True
            # Docks take sizes only once the window has its own.
            QTimer.singleShot(0, self, self._lay_out)

    def _lay_out(self) -> None:
        state = QSettings().value(_LAYOUT)
        if not (isinstance(state, QByteArray) and self.restoreState(state)):
            self._size_docks()

    def _size_docks(self) -> None:
        model, methods, plot, table = self.docks
        self.resizeDocks([model, methods], [250, 300], Qt.Orientation.Horizontal)
        bottom = self.width() - methods.width()
        self.resizeDocks([plot, table], [bottom // 2] * 2, Qt.Orientation.Horizontal)
        self.resizeDocks([plot, table], [_BOTTOM_HEIGHT] * 2, Qt.Orientation.Vertical)

    def sizeHint(self) -> QSize:
        return QSize(1280, 760)
