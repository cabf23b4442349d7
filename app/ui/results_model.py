"""The rows of the results table, as Qt asks for them."""

from functools import cache
from textwrap import wrap
from typing import Any, ClassVar

from PySide6.QtCore import QAbstractTableModel, QModelIndex, Qt
from PySide6.QtGui import QColor, QFont, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import QWidget

from app.export.tables import ResultRow, best_rows, cells, headers
from app.scene.colours import NOISY_COLOUR, WARNING_COLOUR, method_colour
from app.ui.icons import font_icon
from core.metrics import METRICS
from core.smoothing import METHODS

TITLE, NOTE = 0, len(headers()) - 1

_FIRST_METRIC = 2
_DISPLAY = Qt.ItemDataRole.DisplayRole
_NOWHERE = QModelIndex()
_HEADER_WIDTH = 9
_MANY_WORDS = 4
_SHORT = {"Iteration": "Iter.", "Best at": "Best\nat", "ms/iteration": "ms/\niter.", "Note": ""}


class ResultsModel(QAbstractTableModel):
    """The rows of the table, as Qt asks for them."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.rows: tuple[ResultRow, ...] = ()
        self._titles = headers()
        self._texts: list[tuple[str, ...]] = []
        self._best: dict[int, frozenset[int]] = {}
        self._warning = font_icon("mdi6.alert-outline", color=WARNING_COLOUR)
        self._dots = {method: _dot(method_colour(method)) for method in METHODS}
        self._noisy_dot = _dot(NOISY_COLOUR)

    def show(self, rows: tuple[ResultRow, ...]) -> None:
        """Replace the rows; the selection stays where the methods are the same."""
        same = [row.method for row in rows] == [row.method for row in self.rows]
        if not same:
            self.beginResetModel()
        self.rows = rows
        self._titles = headers(rows)
        self._texts = [cells(row, digits=3) for row in rows]
        columns = enumerate(METRICS, start=_FIRST_METRIC)
        self._best = {column: best_rows(rows, metric) for column, metric in columns}
        if not same:
            self.endResetModel()
        elif rows:
            last = self.index(len(rows) - 1, NOTE)
            self.dataChanged.emit(self.index(0, 0), last)

    def rowCount(self, parent: QModelIndex = _NOWHERE) -> int:
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: QModelIndex = _NOWHERE) -> int:
        return 0 if parent.isValid() else len(self._titles)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = _DISPLAY) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        title = self._titles[section]
        answers = {
            _DISPLAY: _short_header(title),
            Qt.ItemDataRole.ToolTipRole: title,
            Qt.ItemDataRole.TextAlignmentRole: _alignment(section),
        }
        return answers.get(role)

    def data(self, index: QModelIndex, role: int = _DISPLAY) -> Any:
        answer = self._ANSWERS.get(role)
        return answer(self, self.rows[index.row()], index) if answer else None

    def _text(self, _: ResultRow, index: QModelIndex) -> str:
        return self._texts[index.row()][index.column()]

    def _hint(self, row: ResultRow, index: QModelIndex) -> str:
        if index.column() in {TITLE, NOTE} and row.note:
            return f"{row.title}: {row.note}"
        return cells(row, digits=8)[index.column()]

    def _font(self, _: ResultRow, index: QModelIndex) -> QFont | None:
        font = QFont()
        font.setBold(index.row() in self._best.get(index.column(), ()))
        return font if font.bold() else None

    def _icon(self, row: ResultRow, index: QModelIndex) -> QIcon | None:
        if index.column() == NOTE and row.note:
            return self._warning
        return self._dots.get(row.method, self._noisy_dot) if index.column() == TITLE else None

    def _align(self, _: ResultRow, index: QModelIndex) -> Qt.AlignmentFlag:
        return _alignment(index.column())

    _ANSWERS: ClassVar = {
        Qt.ItemDataRole.DisplayRole: _text,
        Qt.ItemDataRole.ToolTipRole: _hint,
        Qt.ItemDataRole.FontRole: _font,
        Qt.ItemDataRole.DecorationRole: _icon,
        Qt.ItemDataRole.TextAlignmentRole: _align,
    }


@cache
def _short_header(title: str) -> str:
    """Break a title into short lines, without brackets and without what goes without saying."""
    words = title.replace("(", "").replace(")", "").split()
    brief = [word for word in words if word != "error" or len(words) < _MANY_WORDS]
    return _SHORT.get(title, "\n".join(wrap(" ".join(brief), _HEADER_WIDTH)))


def _alignment(column: int) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignLeft if column in {TITLE, NOTE} else Qt.AlignmentFlag.AlignRight
    return side | Qt.AlignmentFlag.AlignVCenter


def _dot(colour: str) -> QIcon:
    """A dot in the colour of a line."""
    pixmap = QPixmap(24, 24)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(colour))
    painter.drawEllipse(2, 2, 20, 20)
    painter.end()
    icon = QIcon(pixmap)
    # The colour has a meaning: it stays when the row is selected.
    icon.addPixmap(pixmap, QIcon.Mode.Selected)
    return icon
