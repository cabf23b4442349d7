"""The flat drawing of a skeletal graph: bands from left to right, same colours, same pick."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from app.scene.skeleton_colours import node_colours
from app.scene.skeleton_layout import flat_places
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane, grown_nodes, node_text
from app.session.skeleton_maker import Skeleton

_MARGIN_X, _TOP, _SCALE, _BOTTOM = 16.0, 10.0, 18.0, 26.0
_LARGEST, _SMALLEST = 5.5, 3.6
_REACH = 9.0


class FlatDrawing(QWidget):
    """Draws one graph; a click picks a node, a pause over one tells what it is.

    Signals
    -------
    clicked(object) : the node, or None beside all nodes.
    """

    clicked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pane: SkeletonPane | None = None
        self._look: SkeletonLook | None = None
        self._placed: Skeleton | None = None
        self._flat = np.zeros((0, 2))
        self.setMouseTracking(True)
        self.setAccessibleName("Flat drawing of the skeletal graph")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return QSize(400, 150)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, 80)

    def show_pane(self, pane: SkeletonPane, look: SkeletonLook) -> None:
        """Draw the graph of a pane."""
        known = self._pane
        same = known and (known.skeleton, known.step, known.picked, self._look) == (
            pane.skeleton, pane.step, pane.picked, look
        )  # fmt: skip
        self._pane, self._look = pane, look
        if same:
            return
        if pane.skeleton is not None and pane.skeleton is not self._placed:
            self._placed = pane.skeleton
            self._flat = flat_places(pane.skeleton.graph)
        self.update()

    def places(self) -> np.ndarray:
        """Points of the widget at which the nodes stand, (k, 2)."""
        skeleton = self._pane.skeleton if self._pane else None
        if skeleton is None:
            return np.zeros((0, 2))
        first = -1.0 if skeleton.graph.root is not None else 0.0
        bands = max(skeleton.view.resolution - 1 - first, 1.0)
        rows = max(float(self._flat[:, 1].max()), 1.0)
        x = _MARGIN_X + (self._flat[:, 0] - first) / bands * (self.width() - 2 * _MARGIN_X)
        y = _TOP + self._flat[:, 1] / rows * (self.height() - _TOP - _BOTTOM)
        return np.column_stack([x, y])

    def node_at(self, point: QPointF) -> int | None:
        """Return the node next to a point of the widget, or None if none is near."""
        places = self.places()
        if not len(places):
            return None
        distances = np.linalg.norm(places - (point.x(), point.y()), axis=1)
        nearest = int(np.argmin(distances))
        return nearest if distances[nearest] < _REACH else None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.clicked.emit(self.node_at(event.position()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        node = self.node_at(event.position())
        if node is None or self._pane is None or self._pane.skeleton is None:
            QToolTip.hideText()
            return
        text = node_text(self._pane.skeleton, node)
        QToolTip.showText(event.globalPosition().toPoint(), text, self)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._look is None or self._pane is None:
            return
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._look.theme.panel))
        if self._pane.skeleton is not None:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint_scale(painter, self._pane.skeleton)
            self._paint_graph(painter, self._pane.skeleton)
        painter.end()

    def _paint_scale(self, painter: QPainter, skeleton: Skeleton) -> None:
        painter.setPen(self.palette().placeholderText().color())
        room = QRectF(_MARGIN_X, self.height() - _SCALE, self.width() - 2 * _MARGIN_X, _SCALE)
        flags = Qt.AlignmentFlag
        first = "root" if skeleton.graph.root is not None else "band 1"
        painter.drawText(room, flags.AlignLeft | flags.AlignVCenter, first)
        last = f"band {skeleton.view.resolution}"
        painter.drawText(room, flags.AlignRight | flags.AlignVCenter, last)

    def _paint_graph(self, painter: QPainter, skeleton: Skeleton) -> None:
        graph, places = skeleton.graph, self.places()
        grown = grown_nodes(graph, self._pane.step)
        ink = QColor(self._look.theme.ink)
        ink.setAlpha(150)
        painter.setPen(QPen(ink, 1.3))
        for a, b in graph.arcs[grown[graph.arcs].all(axis=1)].tolist():
            painter.drawPath(_curve(QPointF(*places[a]), QPointF(*places[b])))
        radius = self._radius(skeleton)
        colours = node_colours(graph, self._look.settings.node_colour, self._look.theme)
        painter.setPen(QPen(QColor(self._look.theme.panel), 0.8))
        for node in np.flatnonzero(grown).tolist():
            painter.setBrush(QColor(*colours[node].tolist()))
            painter.drawEllipse(QPointF(*places[node]), radius, radius)
        if self._pane.picked is not None:
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(QColor(self._look.theme.accent), 2.4))
            painter.drawEllipse(QPointF(*places[self._pane.picked]), radius + 3, radius + 3)

    def _radius(self, skeleton: Skeleton) -> float:
        """Radius at which neighbours do not touch, as far as they can be seen then."""
        across = (self.width() - 2 * _MARGIN_X) / max(skeleton.view.resolution, 1)
        rows = 1 + float(self._flat[:, 1].max(initial=0))
        room = min(across, 1.2 * (self.height() - _TOP - _BOTTOM) / rows)
        return float(np.clip(0.4 * room, _SMALLEST, _LARGEST))


def _curve(start: QPointF, end: QPointF) -> QPainterPath:
    """A line that leaves both nodes level."""
    middle = (start.x() + end.x()) / 2
    path = QPainterPath(start)
    path.cubicTo(QPointF(middle, start.y()), QPointF(middle, end.y()), end)
    return path
