"""One line of text above a thin bar, painted by itself alone."""

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.session import TaskState

_GAP, _BAR, _MARGIN = 2, 4, 1
_SPACE = 12
_SWING = 0.35
_PIECE = 0.25
_Role = QPalette.ColorRole


class ProgressStrip(QWidget):
    """Shows how a task stands: what it is, how far, how long it will still take.

    It covers its ground itself and keeps its size, so that a change repaints nothing else, while
    a QProgressBar has all of the window repainted.

    Parameters
    ----------
    width : int
        Width it asks for.
    """

    def __init__(self, width: int) -> None:
        super().__init__()
        self._state: TaskState | None = None
        self._width = width
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def show_state(self, state: TaskState) -> None:
        """Show another state."""
        self._state = state
        self.setAccessibleName(f"{state.title}: {state.words}")
        self.setToolTip(state.title)
        self.update()

    @property
    def text(self) -> str:
        """What is to be read."""
        return self.accessibleName()

    def sizeHint(self) -> QSize:
        return QSize(self._width, self.fontMetrics().height() + _GAP + _BAR + 2 * _MARGIN)

    def minimumSizeHint(self) -> QSize:
        return QSize(120, self.sizeHint().height())

    def paintEvent(self, _: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().color(_Role.Window))
        if self._state is not None:
            self._paint_text(painter, self._state)
            self._paint_bar(painter, self._state)
        painter.end()

    def _paint_text(self, painter: QPainter, state: TaskState) -> None:
        metrics = self.fontMetrics()
        words, middle = state.words, Qt.AlignmentFlag.AlignVCenter
        line = self.rect().adjusted(0, _MARGIN, 0, -(_MARGIN + _BAR + _GAP))
        painter.setPen(self.palette().color(_Role.PlaceholderText))
        painter.drawText(line, Qt.AlignmentFlag.AlignRight | middle, words)
        line.setRight(line.right() - metrics.horizontalAdvance(words) - _SPACE)
        title = metrics.elidedText(state.title, Qt.TextElideMode.ElideRight, line.width())
        painter.setPen(self.palette().color(_Role.WindowText))
        painter.drawText(line, Qt.AlignmentFlag.AlignLeft | middle, title)

    def _paint_bar(self, painter: QPainter, state: TaskState) -> None:
        """Fill the share that is done; a piece that swings tells that it is not known."""
        groove = QRectF(0, self.height() - _MARGIN - _BAR, self.width(), _BAR)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        done = QRectF(groove)
        if state.share is None:
            place = abs(1 - _SWING * state.seconds % 2)
            done.setWidth(_PIECE * groove.width())
            done.moveLeft(place * (groove.width() - done.width()))
        else:
            done.setWidth(state.share * groove.width())
        faint = _Role.Mid if state.stopping else _Role.Highlight
        for area, role in ((groove, _Role.Mid), (done, faint)):
            painter.setBrush(self.palette().color(role))
            painter.drawRoundedRect(area, _BAR / 2, _BAR / 2)
