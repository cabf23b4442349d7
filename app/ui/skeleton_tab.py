"""The Skeleton tab: two graphs on their surfaces, their flat drawings, and panels around them."""

import random
from dataclasses import replace

from PySide6.QtCore import QByteArray, QSettings, QSize, Qt, QTimer
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QDockWidget, QMainWindow, QWidget

from app.scene.camera import OBLIQUE
from app.scene.colours import Theme
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane, build_pane, missing_pane
from app.session import Session
from app.session.skeleton_invariance import InvarianceReport
from app.session.skeleton_views import VIEW_COUNT, SkeletonViews
from app.ui.skeleton_centre import SkeletonCentre
from app.ui.skeleton_desk import SkeletonDesk
from app.ui.skeleton_side import SkeletonSide

_LAYOUT = "skeleton_layout"
_LEFT_WIDTH = 286
_BOTTOM_HEIGHT = 170
_SEEDS = 100_000


class SkeletonTab(QMainWindow):
    """Draws skeletal graphs while the resolution slider moves.

    Nothing is computed before the tab is shown.

    Parameters
    ----------
    session : Session
        The state; the tab only listens and pushes studies.
    theme : Theme
        Colours to begin with.
    """

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self.session = session
        self.views = SkeletonViews(session)
        self.selected = VIEW_COUNT - 1
        self.step: int | None = None
        self.picked: dict[int, int] = {}
        self.flickers = False
        self._theme = theme
        self._fresh_model = True
        self._laid_out = False
        self._redraw_timer = QTimer(self, singleShot=True, interval=0)
        self._redraw_timer.timeout.connect(self._redraw)
        self.centre = SkeletonCentre(session)
        self.viewport, self.growth = self.centre.viewport, self.centre.growth
        self.side = SkeletonSide(session)
        self.setCentralWidget(self.centre)
        self._areas: dict[QDockWidget, Qt.DockWidgetArea] = {}
        self.docks = [
            self._dock("Views", self.side, Qt.DockWidgetArea.LeftDockWidgetArea),
            self._dock("Graph", self.centre.drawings, Qt.DockWidgetArea.BottomDockWidgetArea),
        ]
        self.setCorner(Qt.Corner.BottomLeftCorner, Qt.DockWidgetArea.LeftDockWidgetArea)
        self.desk = SkeletonDesk(self, self.viewport)
        self._connect()

    def panes(self, text_scale: float) -> tuple[list[SkeletonPane], SkeletonLook]:
        """Return what the viewport shows; empty before a model is there."""
        settings = self.session.study.skeleton
        shown = self.views.shown
        chosen = shown.index(self.selected) if self.selected in shown else 0
        look = SkeletonLook(settings.drawing, self._theme, text_scale, chosen)
        if self.session.meshes is None:
            return [], look
        return [self._pane(view) for view in shown], look

    def set_flicker(self, on: bool) -> None:
        """Show the other view's graph in the selected view, or its own again."""
        if on != self.flickers:
            self.flickers = on
            self._redraw()

    @staticmethod
    def without_frame(look: SkeletonLook) -> SkeletonLook:
        """Return a look in which no pane is marked as selected."""
        return replace(look, selected=None)

    def select(self, view: int) -> None:
        """Mark a view and show its settings and numbers."""
        self.selected = view
        self.side.select(view)
        self._show_facts()
        self._redraw_timer.start()

    def pick(self, view: int, node: int | None) -> None:
        """Light up a node of a view with its piece of surface, or none."""
        self.picked.pop(view, None)
        if node is not None:
            self.picked[view] = node
        self.select(view)

    def set_theme(self, theme: Theme) -> None:
        """Draw everything in a theme's colours."""
        self._theme = theme
        self._redraw_timer.start()

    def save_layout(self) -> None:
        """Remember where the panels are, if they have ever been shown."""
        if self._laid_out:
            QSettings().setValue(_LAYOUT, self.saveState())

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
        self.growth.stop()
        self.desk.gestures.stop()
        self.viewport.close_interactor()

    def _dock(self, title: str, widget: QWidget, area: Qt.DockWidgetArea) -> QDockWidget:
        dock = QDockWidget(title, self)
        dock.setObjectName(f"skeleton {title}")
        dock.setWidget(widget)
        self.addDockWidget(area, dock)
        self._areas[dock] = area
        return dock

    def _connect(self) -> None:
        self.session.study_changed.connect(self._on_study_changed)
        self.views.changed.connect(self._on_graph_changed)
        self.views.cancelled_changed.connect(self._on_cancelled_changed)
        self.views.invariance_checked.connect(self._on_checked)
        self.viewport.clicked.connect(lambda pane, node: self.pick(self.views.shown[pane], node))
        for view, drawing in enumerate(self.centre.flat):
            drawing.clicked.connect(lambda node, view=view: self.pick(view, node))
        for view, bar in enumerate(self.centre.resolutions):
            bar.automatic_requested.connect(lambda view=view: self.views.find_resolution(view))
            bar.resume_requested.connect(lambda view=view: self.views.resume(view))
        self.growth.changed.connect(self._on_growth)
        self.side.selected.connect(self.select)
        self.side.facts.check_requested.connect(self._check)

    def _pane(self, view: int) -> SkeletonPane:
        centre = self.session.meshes.comparison.original.vertices.mean(axis=0)
        skeleton = self.views.skeleton(view)
        if skeleton is None:
            settings = self.session.study.skeleton.views[view]
            problem = self.views.problem(view)
            waiting = "Cancelled." if self.views.is_cancelled(view) else "Drawing …"
            return missing_pane(settings, centre, problem or waiting, warning=bool(problem))
        return build_pane(skeleton, centre, self.step, self.picked.get(view))

    def _on_study_changed(self, study: object, before: object) -> None:
        self._fresh_model |= study.model != before.model
        if study.skeleton != before.skeleton:
            if not study.skeleton.compare:
                self.selected = VIEW_COUNT - 1
                self.side.select(self.selected)
            self._redraw_timer.start()

    def _on_graph_changed(self, view: int) -> None:
        self.picked.pop(view, None)
        self.side.show_outcome("")
        self._show_facts()
        self._redraw_timer.start()

    def _on_cancelled_changed(self, view: int) -> None:
        self.centre.resolutions[view].show_cancelled(self.views.is_cancelled(view))
        self._redraw_timer.start()

    def _on_growth(self, step: int | None) -> None:
        self.step = step
        self._redraw_timer.start()

    def _on_checked(self, _: int, report: InvarianceReport) -> None:
        self.side.show_outcome(report.text)
        self.session.notified.emit(report.text)

    def _check(self) -> None:
        self.views.check_invariance(self.selected, random.randrange(_SEEDS))

    def _show_facts(self) -> None:
        self.side.facts.show_skeleton(self.views.skeleton(self.selected))

    def _redraw(self) -> None:
        panes, look = self.panes(self.devicePixelRatioF())
        if not panes or not self.isVisible():
            return
        graphs = [pane.skeleton for pane in panes if pane.skeleton]
        self.growth.set_last(max((graph.view.resolution for graph in graphs), default=1))
        self.step = self.growth.step
        drawn = [panes[1 - look.selected]] * 2 if self.flickers and len(panes) > 1 else panes
        self.viewport.show_panes(drawn, look)
        self.centre.show_panes(dict(zip(self.views.shown, panes, strict=True)), look)
        if self._fresh_model and len(graphs) == len(panes) and self.views.is_settled:
            self._fresh_model = False
            self.viewport.look_from(OBLIQUE)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.views.set_awake(True)
        self._redraw_timer.start()
        if not self._laid_out:
            self._laid_out = True
            # Docks take sizes only once the window has its own.
            QTimer.singleShot(0, self, self._lay_out)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.growth.stop()
        self.views.set_awake(False)

    def _lay_out(self) -> None:
        state = QSettings().value(_LAYOUT)
        if not (isinstance(state, QByteArray) and self.restoreState(state)):
            self._size_docks()

    def _size_docks(self) -> None:
        side, graph = self.docks
        self.resizeDocks([side], [_LEFT_WIDTH], Qt.Orientation.Horizontal)
        self.resizeDocks([graph], [_BOTTOM_HEIGHT], Qt.Orientation.Vertical)

    def sizeHint(self) -> QSize:
        return QSize(1280, 760)
