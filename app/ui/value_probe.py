"""The value under the cursor: which vertex or face it is, and its error."""

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent
from vtkmodules.vtkRenderingCore import vtkWorldPointPicker

from app.scene.panes import Look, Pane
from app.ui.controls import Coalesced
from app.ui.desk import Desk
from app.ui.stage import Stage, device_place, share_of
from app.ui.viewport import Viewport

_INTERVAL_MS = 60
_FAR = 0.999999


class ValueProbe(QObject):
    """Tells what is under the cursor; `changed` carries a line of text, empty over nothing.

    Parameters
    ----------
    desk : Desk
        The tab over whose drawing area the cursor moves.
    """

    changed = Signal(str)

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self._desk, self._area = desk, desk.stage.interactor
        self._place: QPointF | None = None
        self._text = ""
        self._soon = Coalesced(self._look, _INTERVAL_MS, self)
        self._area.installEventFilter(self)

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.Leave, QEvent.Type.Hide}:
            self._tell("")
            self._place = None
        elif isinstance(event, QMouseEvent) and event.type() == QEvent.Type.MouseMove:
            self._place = event.position()
            if event.buttons() == Qt.MouseButton.NoButton:
                self._soon.request()
        return False

    def _look(self) -> None:
        if self._place is not None and self._area.isVisible():
            self._tell(self._desk.describe(self._place))

    def _tell(self, text: str) -> None:
        if text != self._text:
            self._text = text
            self.changed.emit(text)


def point_under(stage: Stage, place: QPointF) -> np.ndarray | None:
    """Point of an opaque surface that is seen at a place, None where nothing is.

    The depth of the pixel that is already drawn gives the point, so that nothing is searched:
    moving the mouse over a large mesh costs next to nothing.
    """
    view = stage.view_at(*share_of(stage, place))
    x, y = device_place(stage, place)
    window = stage.interactor.render_window
    if view is None or window.GetZbufferDataAtPoint(int(x), int(y)) > _FAR:
        return None
    picker = vtkWorldPointPicker()
    picker.Pick(x, y, 0, view.renderer)
    return np.array(picker.GetPickPosition())


def text_at(viewport: Viewport, place: QPointF) -> str:
    """Describe what is seen at a place of the viewport of the Denoise tab."""
    grid = viewport.grid
    seen, point = grid.mesh_at(*share_of(viewport, place)), point_under(viewport, place)
    if seen is None or point is None:
        return ""
    shown = next(pane for pane in grid.panes if pane.id == seen)
    return description(shown, grid.look, point)


def description(pane: Pane, look: Look, point: np.ndarray) -> str:
    """Describe the vertex of a pane that is nearest to a point, or its face if faces have values.

    Examples
    --------
    "Mean filter: face 12,345, normal angle 3.21 °".
    """
    vertex = int(np.argmin(((pane.points - point.astype(np.float32)) ** 2).sum(axis=1)))
    if pane.values is None or not look.colour_title:
        return f"{pane.title}: vertex {vertex:,}"
    title, _, unit = look.colour_title.replace("\n", " ").rpartition(" ")
    number = vertex
    if look.values_on == "face":
        number = _nearest_face(pane, look, vertex, point)
    value = f"{pane.values[number]:.4g} {unit.strip('()')}".strip()
    return f"{pane.title}: {look.values_on} {number:,}, {title[:1].lower()}{title[1:]} {value}"


def _nearest_face(pane: Pane, look: Look, vertex: int, point: np.ndarray) -> int:
    """Face around a vertex whose corners are nearest to a point."""
    around = np.flatnonzero((look.faces == vertex).any(axis=1))
    if not len(around):
        return vertex
    corners = pane.points[look.faces[around]].astype(float)
    return int(around[_least_outside(corners, point)])


def _least_outside(corners: np.ndarray, point: np.ndarray) -> int:
    """Index of the triangle in which a point lies, by the smallest barycentric coordinate."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normals = np.cross(b - a, c - a)
    doubled = np.maximum((normals**2).sum(axis=1), 1e-300)
    parts = [
        (np.cross(second - first, point - first) * normals).sum(axis=1) / doubled
        for first, second in ((a, b), (b, c), (c, a))
    ]
    return int(np.argmax(np.min(parts, axis=0)))
