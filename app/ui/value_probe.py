"""The value under the cursor: which vertex or face it is, and its error."""

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent
from vtkmodules.vtkRenderingCore import vtkWorldPointPicker

from app.scene.panes import Look, Pane
from app.ui.controls import Coalesced
from app.ui.viewport import Viewport

_INTERVAL_MS = 60
_FAR = 0.999999


class ValueProbe(QObject):
    """Tells what is under the cursor; `changed` carries a line of text, empty over nothing.

    The depth of the pixel that is already drawn gives the point, so that nothing is searched but
    the nearest vertex: moving the mouse over a large mesh costs next to nothing.

    Parameters
    ----------
    viewport : Viewport
        Where the cursor moves.
    """

    changed = Signal(str)

    def __init__(self, viewport: Viewport) -> None:
        super().__init__(viewport)
        self._viewport = viewport
        self._place: QPointF | None = None
        self._text = ""
        self._picker = vtkWorldPointPicker()
        self._soon = Coalesced(self._look, _INTERVAL_MS, self)
        viewport.interactor.installEventFilter(self)

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self._tell("")
            self._place = None
        elif isinstance(event, QMouseEvent) and event.type() == QEvent.Type.MouseMove:
            self._place = event.position()
            if event.buttons() == Qt.MouseButton.NoButton:
                self._soon.request()
        return False

    def _look(self) -> None:
        if self._place is not None and self._viewport.isVisible():
            self._tell(self.text_at(self._place))

    def text_at(self, place: QPointF) -> str:
        """Describe what is seen at a place of the viewport."""
        grid = self._viewport.grid
        share = self._viewport.share(place)
        pane, seen = grid.pane_at(*share), grid.mesh_at(*share)
        if pane is None or seen is None:
            return ""
        x, y = self._viewport.device(place)
        window = self._viewport.interactor.render_window
        if window.GetZbufferDataAtPoint(int(x), int(y)) > _FAR:
            return ""
        self._picker.Pick(x, y, 0, grid.renderer(pane))
        shown = next(p for p in grid.panes if p.id == seen)
        return description(shown, grid.look, np.array(self._picker.GetPickPosition()))

    def _tell(self, text: str) -> None:
        if text != self._text:
            self._text = text
            self.changed.emit(text)


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
