"""The viewport: the grid of panes on the screen, with mouse and camera."""

import time

import numpy as np
from PySide6.QtCore import (
    QEvent,
    QPoint,
    QPointF,
    QRect,
    QSize,
    Qt,
    QTimer,
    QVariantAnimation,
    Signal,
)
from PySide6.QtGui import QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QRubberBand, QVBoxLayout, QWidget
from vtkmodules.vtkRenderingCore import vtkCellPicker

from app.scene.camera import CameraPose, pan_and_dolly, point_on_focal_plane
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from app.ui.interactor import Interactor

_CLICK_PIXELS = 4
_FLY_MS = 180
_FLY_FACTOR = 1.8


class Viewport(QWidget):
    """Shows panes; a click selects one, a double click enlarges it and brings it back.

    Signals
    -------
    selected(str) : the pane that was clicked.
    bar_opened() : the colour bar was double-clicked.
    box_zoom_ended() : the rectangle of a box zoom was drawn or given up.
    """

    selected = Signal(str)
    box_zoom_ended = Signal()
    bar_opened = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.interactor = Interactor(self, GRID_SHAPE)
        self.interactor.installEventFilter(self)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.interactor)
        self.grid = PaneGrid(self.interactor)
        self._panes: list[Pane] = []
        self._look: Look | None = None
        self._pressed: QPoint | None = None
        self._box_zoom = False
        self._band = QRubberBand(QRubberBand.Shape.Rectangle, self.interactor)
        self._flight: QVariantAnimation | None = None
        self.draw_seconds = 0.0
        self._draw_started = 0.0
        window = self.interactor.render_window
        window.AddObserver("StartEvent", self._before_drawing)
        window.AddObserver("EndEvent", self._after_drawing)

    def minimumSizeHint(self) -> QSize:
        return QSize(320, 240)

    def show_panes(self, panes: list[Pane], look: Look) -> None:
        """Draw panes; the cameras stay where they are."""
        self._panes, self._look = panes, look
        self.grid.set_ground(look.theme.ground, look.theme.ground_top)
        self.grid.show(panes, look, self.pixel_size())
        self.interactor.update()

    def redraw(self) -> None:
        """Draw what is shown once more, after the grid was told to arrange it otherwise."""
        if self._look is not None:
            self.show_panes(self._panes, self._look)

    def pixel_size(self) -> tuple[int, int]:
        """Size of the drawing area in device pixels."""
        return self.interactor.pixel_size()

    def look_from(self, preset: str) -> None:
        """Show the whole model from a preset direction."""
        self.grid.look_from(preset)
        self.interactor.update()

    @property
    def pose(self) -> CameraPose:
        """Where the camera of the selected pane stands."""
        chosen = self._look.selected if self._look else None
        place = self.grid.ids.index(chosen) if chosen in self.grid.ids else 0
        return self.grid.poses()[place]

    def set_pose(self, pose: CameraPose) -> None:
        """Put the cameras of all panes into a pose."""
        self.grid.set_poses([pose])
        self.interactor.update()

    def set_linked(self, linked: bool, leader: str | None) -> None:
        """Link or unlink the cameras; nothing jumps on unlinking."""
        if linked != self.grid.linked:
            self.grid.link(linked, leader)
            self.interactor.update()

    def toggle_enlarged(self, pane: str | None) -> None:
        """Enlarge one pane to the whole viewport, or bring the others back."""
        self.grid.enlarged = None if self.grid.enlarged else pane
        self.redraw()

    def start_box_zoom(self, on: bool) -> None:
        """Let the next drag draw a rectangle to zoom into."""
        self._box_zoom = on
        shape = Qt.CursorShape.CrossCursor if on else Qt.CursorShape.ArrowCursor
        self.interactor.setCursor(shape)

    def fly_to_cursor(self) -> None:
        """Fly to the point of the surface under the cursor, in all linked panes at once."""
        cursor = self.interactor.mapFromGlobal(self.cursor().pos())
        pane = self._pane_at(cursor)
        if pane is None:
            return
        picker = vtkCellPicker()
        x, y = self.device(QPointF(cursor))
        if picker.Pick(x, y, 0, self.grid.renderer(pane)):
            self._fly(pane, picker.GetPickPosition())

    def share(self, point: QPointF) -> tuple[float, float]:
        """Turn a point of the widget into shares of its size from the lower left corner."""
        size = self.interactor.size()
        return point.x() / max(size.width(), 1), 1 - point.y() / max(size.height(), 1)

    def device(self, point: QPointF) -> tuple[float, float]:
        """Turn a point of the widget into device pixels from the lower left corner."""
        width, height = self.pixel_size()
        x, y = self.share(point)
        return x * width, y * height

    def close_interactor(self) -> None:
        """Release the graphics; the widget cannot be used any more."""
        if self._flight:
            self._flight.stop()
        self.interactor.removeEventFilter(self)
        self.interactor.close()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # The interactor gets its size after this event; draw with the new one.
        QTimer.singleShot(0, self, self.redraw)

    def eventFilter(self, watched: QWidget, event: QEvent) -> bool:
        if not isinstance(event, QMouseEvent):
            return False
        handlers = {
            QEvent.Type.MouseButtonPress: self._press,
            QEvent.Type.MouseMove: self._drag,
            QEvent.Type.MouseButtonRelease: self._release,
            QEvent.Type.MouseButtonDblClick: self._double_click,
        }
        handler = handlers.get(event.type())
        return handler(event) if handler else False

    def _press(self, event: QMouseEvent) -> bool:
        self._pressed = event.position().toPoint()
        if self._box_zoom:
            self._band.setGeometry(QRect(self._pressed, QSize()))
            self._band.show()
        return self._box_zoom

    def _drag(self, event: QMouseEvent) -> bool:
        if self._box_zoom and self._pressed is not None:
            corner = event.position().toPoint()
            self._band.setGeometry(QRect(self._pressed, corner).normalized())
        return self._box_zoom

    def _release(self, event: QMouseEvent) -> bool:
        pressed, self._pressed = self._pressed, None
        if pressed is None:
            return False
        if self._box_zoom:
            self._band.hide()
            self._zoom_into(QRect(pressed, event.position().toPoint()).normalized())
            self.start_box_zoom(False)
            self.box_zoom_ended.emit()
            return True
        moved = (event.position().toPoint() - pressed).manhattanLength()
        pane = self._pane_at(pressed)
        if moved < _CLICK_PIXELS and pane:
            self.selected.emit(pane)
        return False

    def _double_click(self, event: QMouseEvent) -> bool:
        pane = self._pane_at(event.position().toPoint())
        if pane is None:
            self.bar_opened.emit()
        elif self.grid.swipe is None:
            self.toggle_enlarged(pane)
        return True

    def _before_drawing(self, *_: object) -> None:
        self.grid.fit_clipping()
        self._draw_started = time.perf_counter()

    def _after_drawing(self, *_: object) -> None:
        self.draw_seconds = time.perf_counter() - self._draw_started

    def _pane_at(self, point: QPoint) -> str | None:
        return self.grid.pane_at(*self.share(QPointF(point)))

    def _zoom_into(self, box: QRect) -> None:
        """Move the camera so that a rectangle of one pane fills it."""
        pane = self._pane_at(box.center())
        if pane is None or min(box.width(), box.height()) < _CLICK_PIXELS:
            return
        left, top, width, height = self.grid.viewports[pane].pixels(
            self.interactor.width(), self.interactor.height()
        )
        x = 2 * (box.center().x() - left) / width - 1
        y = 1 - 2 * (box.center().y() - top) / height
        camera = self.grid.renderer(pane).GetActiveCamera()
        target = point_on_focal_plane(camera, x, y, width / height)
        pan_and_dolly(camera, target, min(width / box.width(), height / box.height()))
        self.interactor.update()

    def _fly(self, pane: str, target: tuple[float, float, float]) -> None:
        """Approach a point in a few frames."""
        camera = self.grid.renderer(pane).GetActiveCamera()
        start = np.array(camera.GetFocalPoint())
        reached = 0.0

        def advance(share: float) -> None:
            nonlocal reached
            point = start + (np.array(target) - start) * share
            pan_and_dolly(camera, point, _FLY_FACTOR ** (share - reached))
            reached = share
            self.interactor.update()

        self._flight = QVariantAnimation(self, startValue=0.0, endValue=1.0, duration=_FLY_MS)
        self._flight.valueChanged.connect(advance)
        self._flight.start()
