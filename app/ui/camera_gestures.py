"""Zooming into a rectangle and flying to a point, in any drawing area."""

import numpy as np
from PySide6.QtCore import (
    QEvent,
    QObject,
    QPoint,
    QPointF,
    QRect,
    QSize,
    Qt,
    QVariantAnimation,
    Signal,
)
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QRubberBand
from vtkmodules.vtkRenderingCore import vtkCellPicker

from app.scene.camera import pan_and_dolly, point_on_focal_plane
from app.ui.stage import Stage, View, device_place, share_of

_LEAST_PIXELS = 4
_FLY_MS = 180
_FLY_FACTOR = 1.8


class CameraGestures(QObject):
    """Moves the cameras of a drawing area by a rectangle that is dragged, or to the cursor.

    Parameters
    ----------
    stage : Stage
        The drawing area.

    Signals
    -------
    box_zoom_ended() : the rectangle of a box zoom was drawn or given up.
    """

    box_zoom_ended = Signal()

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage.interactor)
        self._stage, self._area = stage, stage.interactor
        self._band = QRubberBand(QRubberBand.Shape.Rectangle, self._area)
        self._zooms = False
        self._pressed: QPoint | None = None
        self._flight: QVariantAnimation | None = None
        self._area.installEventFilter(self)

    def start_box_zoom(self, on: bool) -> None:
        """Let the next drag draw a rectangle to zoom into, or give that up."""
        self._zooms, self._pressed = on, None
        self._band.hide()
        shape = Qt.CursorShape.CrossCursor if on else Qt.CursorShape.ArrowCursor
        self._area.setCursor(shape)

    def fly_to_cursor(self) -> None:
        """Fly to the point of the surface under the cursor, with all cameras that are linked."""
        cursor = QPointF(self._area.mapFromGlobal(self._area.cursor().pos()))
        view = self._stage.view_at(*share_of(self._stage, cursor))
        if view is None:
            return
        picker = vtkCellPicker()
        x, y = device_place(self._stage, cursor)
        if picker.Pick(x, y, 0, view.renderer):
            self._fly(view, picker.GetPickPosition())

    def stop(self) -> None:
        """Move nothing more."""
        if self._flight:
            self._flight.stop()
        self._area.removeEventFilter(self)

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if not (self._zooms and isinstance(event, QMouseEvent)):
            return False
        handlers = {
            QEvent.Type.MouseButtonPress: self._press,
            QEvent.Type.MouseMove: self._drag,
            QEvent.Type.MouseButtonRelease: self._release,
        }
        handler = handlers.get(event.type())
        if handler:
            handler(event.position().toPoint())
        return True

    def _press(self, point: QPoint) -> None:
        self._pressed = point
        self._band.setGeometry(QRect(point, QSize()))
        self._band.show()

    def _drag(self, point: QPoint) -> None:
        if self._pressed is not None:
            self._band.setGeometry(QRect(self._pressed, point).normalized())

    def _release(self, point: QPoint) -> None:
        if self._pressed is None:
            return
        box = QRect(self._pressed, point).normalized()
        self.start_box_zoom(False)
        self._zoom_into(box)
        self.box_zoom_ended.emit()

    def _zoom_into(self, box: QRect) -> None:
        """Move the camera so that a rectangle of one view fills it."""
        view = self._stage.view_at(*share_of(self._stage, QPointF(box.center())))
        if view is None or min(box.width(), box.height()) < _LEAST_PIXELS:
            return
        left, top, width, height = view.place.pixels(self._area.width(), self._area.height())
        x = 2 * (box.center().x() - left) / width - 1
        y = 1 - 2 * (box.center().y() - top) / height
        camera = view.renderer.GetActiveCamera()
        target = point_on_focal_plane(camera, x, y, width / height)
        pan_and_dolly(camera, target, min(width / box.width(), height / box.height()))
        self._stage.camera_moved()

    def _fly(self, view: View, target: tuple[float, float, float]) -> None:
        """Approach a point in a few frames."""
        camera = view.renderer.GetActiveCamera()
        start = np.array(camera.GetFocalPoint())
        reached = 0.0

        def advance(share: float) -> None:
            nonlocal reached
            point = start + (np.array(target) - start) * share
            pan_and_dolly(camera, point, _FLY_FACTOR ** (share - reached))
            reached = share
            self._stage.camera_moved()

        self._flight = QVariantAnimation(self, startValue=0.0, endValue=1.0, duration=_FLY_MS)
        self._flight.valueChanged.connect(advance)
        self._flight.start()
