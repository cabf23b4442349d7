"""The drawing area of the Skeleton tab: a click picks a node and selects its view."""

import time

from PySide6.QtCore import QEvent, QPoint, QPointF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.scene.camera import CameraPose
from app.scene.due import Due
from app.scene.skeleton_grid import SHAPE, SkeletonGrid
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane
from app.ui.interactor import Interactor
from app.ui.stage import View, share_of

_CLICK_PIXELS = 4
_REST_MS = 300
# Depth peeling takes about this many times as long as a drawing without it, and the window waits
# meanwhile: where that would be felt, the picture at rest stays without it.
_PEELING_FACTOR = 5.0
_FELT_SECONDS = 0.25


class SkeletonViewport(QWidget):
    """Shows one or two skeletal graphs.

    Signals
    -------
    clicked(int, object) : the pane, and the node there or None.
    """

    clicked = Signal(int, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.interactor = Interactor(self, SHAPE)
        self.interactor.installEventFilter(self)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.interactor)
        self.grid = SkeletonGrid(self.interactor)
        self._panes: list[SkeletonPane] = []
        self._look: SkeletonLook | None = None
        self._pressed: QPoint | None = None
        self._started = 0.0
        self._resting = False
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._draw_precisely)
        window = self.interactor.render_window
        self._due = Due(window, self.grid.seen)
        self.interactor.pixels_lost.connect(self._due.forget)
        window.AddObserver("StartEvent", self._before_drawing)
        window.AddObserver("EndEvent", self._after_drawing)

    def minimumSizeHint(self) -> QSize:
        return QSize(320, 200)

    def show_panes(self, panes: list[SkeletonPane], look: SkeletonLook) -> None:
        """Draw panes; the camera stays where it is."""
        self._panes, self._look = panes, look
        self._hurry()
        self.grid.set_ground(look.theme.ground, look.theme.ground_top)
        self.grid.show(panes, look, self.pixel_size())
        self.interactor.update()

    def pixel_size(self) -> tuple[int, int]:
        """Size of the drawing area in device pixels."""
        return self.interactor.pixel_size()

    def look_from(self, preset: str) -> None:
        """Show the whole model from a preset direction."""
        self.grid.look_from(preset, self.pixel_size())
        self.camera_moved()

    @property
    def pose(self) -> CameraPose:
        """Where the camera stands."""
        return self.grid.pose

    def set_pose(self, pose: CameraPose) -> None:
        """Put the camera into a pose."""
        self.grid.set_pose(pose)
        self.camera_moved()

    @property
    def panes(self) -> list[SkeletonPane]:
        """Panes as they were drawn last."""
        return self._panes

    def close_interactor(self) -> None:
        """Release the graphics; the widget cannot be used any more."""
        self._rest.stop()
        self.interactor.removeEventFilter(self)
        self.interactor.close()

    def view_at(self, x: float, y: float) -> View | None:
        """Return the view at a point, in shares of the widget from its lower left corner."""
        pane = self.grid.pane_at(x, y)
        return None if pane is None else View(self.grid.renderer(pane), self.grid.viewports[pane])

    def camera_moved(self) -> None:
        """Draw what is seen after a camera was moved."""
        self._hurry()
        self.interactor.update()

    def part(self, share: float | None) -> None:
        """Show both views as one, parted by a line at a share of the width; None as two."""
        self.grid.part(share)
        self._redraw()
        self.camera_moved()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # The interactor gets its size after this event; draw with the new one.
        QTimer.singleShot(0, self, self._redraw)

    def eventFilter(self, watched: QWidget, event: QEvent) -> bool:
        if isinstance(event, QMouseEvent):
            if event.type() == QEvent.Type.MouseButtonPress:
                self._pressed = event.position().toPoint()
            elif event.type() == QEvent.Type.MouseButtonRelease:
                self._release(event.position().toPoint())
            elif self._pressed is not None:
                self._hurry()
        elif event.type() == QEvent.Type.Wheel:
            self._hurry()
        return False

    def _release(self, point: QPoint) -> None:
        pressed, self._pressed = self._pressed, None
        if pressed is None or (point - pressed).manhattanLength() >= _CLICK_PIXELS:
            return
        x, y = share_of(self, QPointF(point))
        pane = self.grid.pane_at(x, y)
        if pane is not None:
            self.clicked.emit(pane, self.grid.node_at(pane, x, y, self.pixel_size()))

    def _before_drawing(self, *_: object) -> None:
        """Draw only what is new: while one view's R is dragged, the other keeps its pixels."""
        self.grid.fit_clipping()
        self._due.begin()
        self._started = time.perf_counter()

    def _after_drawing(self, *_: object) -> None:
        self._due.end()
        seconds = time.perf_counter() - self._started
        if self._resting and _PEELING_FACTOR * seconds < _FELT_SECONDS:
            self._draw_at_rest(precise=True)
        self._resting = False

    def _hurry(self) -> None:
        """Draw fast while something moves, and precisely once it rests."""
        self._resting = False
        self.grid.set_precise(False)
        self._rest.start()

    def _draw_precisely(self) -> None:
        """Draw the surface itself; how long that takes tells whether peeling would be felt."""
        if QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._rest.start()
            return
        self._draw_at_rest(precise=False)
        self._resting = True

    def _draw_at_rest(self, *, precise: bool) -> None:
        self._due.forget()
        self.grid.set_precise(precise, coarse=False)
        self.interactor.update()

    def _redraw(self) -> None:
        if self._look is not None:
            self.show_panes(self._panes, self._look)
