"""The table of results."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QRect, QSize, Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from app.export.outcomes import session_outcomes
from app.export.tables import (
    ResultRow,
    as_csv,
    as_latex,
    as_markdown,
    as_text,
    result_rows,
    save_table,
)
from app.session import Session
from app.ui.controls import Coalesced
from app.ui.results_model import NOTE, TITLE, ResultsModel
from app.ui.turns import Turns, Work
from core.study import Study

_REFRESH_MS = 80
_NOTE_ICON = 26
_BESIDE_WORDS = 14
_BETWEEN_ROWS = 6
_SPACE = 12

_FORMATS: dict[str, Callable[[Sequence[ResultRow]], str]] = {
    "Copy as Text": as_text,
    "Copy as CSV": as_csv,
    "Copy as Markdown": as_markdown,
    "Copy as LaTeX": as_latex,
}


class ResultsView(QTableView):
    """Table view whose columns always fill its width; if a name needs more lines, all get them."""

    def __init__(self, model: ResultsModel) -> None:
        super().__init__()
        self.setModel(model)
        self._dress()

    def fit_columns(self) -> None:
        """Give the numbers what they need, then the names, then space, then the notes."""
        self._fit_widths()
        rows = self.verticalHeader()
        wraps = self.columnWidth(TITLE) < self.sizeHintForColumn(TITLE)
        height = max(rows.defaultSectionSize(), wraps * (self._tallest_name() + _BETWEEN_ROWS))
        for row in range(self.model().rowCount()):
            rows.resizeSection(row, height)

    def _fit_widths(self) -> None:
        columns = self.horizontalHeader()
        widths = [
            max(self.sizeHintForColumn(column), columns.sectionSizeHint(column))
            for column in range(self.model().columnCount())
        ]
        numbers = range(TITLE + 1, NOTE)
        room = self.viewport().width() - sum(widths[column] for column in numbers) - _NOTE_ICON
        widths[TITLE] = max(min(widths[TITLE], room), self._widest_word())
        space = min(max(room - widths[TITLE], 0) // len(numbers), _SPACE)
        for column in numbers:
            widths[column] += space
        widths[NOTE] = max(self.viewport().width() - sum(widths[:NOTE]), _NOTE_ICON)
        for column, width in enumerate(widths):
            columns.resizeSection(column, width)

    def _widest_word(self) -> int:
        """Width that no word of a name needs more than, with the dot before it."""
        names = (row.title for row in self.model().rows)
        words = (word for name in names for word in name.split())
        widest = max(map(self.fontMetrics().horizontalAdvance, words), default=0)
        return widest + self.iconSize().width() + _BESIDE_WORDS

    def _tallest_name(self) -> int:
        """Height that no name needs more than in the lines that its column gives it."""
        room = QRect(0, 0, self.columnWidth(TITLE) - self.iconSize().width() - _BESIDE_WORDS, 0)
        wrap, metrics = Qt.TextFlag.TextWordWrap, self.fontMetrics()
        names = (row.title for row in self.model().rows)
        return max((metrics.boundingRect(room, wrap, name).height() for name in names), default=0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.fit_columns()

    def _dress(self) -> None:
        font = self.font()
        font.setPointSizeF(0.92 * font.pointSizeF())
        self.setFont(font)
        font.setPointSizeF(0.94 * font.pointSizeF())
        self.horizontalHeader().setFont(font)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setTabKeyNavigation(False)
        self.setIconSize(QSize(12, 12))
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setAccessibleName("Table of results")
        rows, columns = self.verticalHeader(), self.horizontalHeader()
        rows.hide()
        rows.setDefaultSectionSize(self.fontMetrics().height() + _BETWEEN_ROWS)
        columns.setSectionsClickable(False)
        columns.setHighlightSections(False)
        columns.setMinimumSectionSize(_NOTE_ICON)
        columns.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)


class ResultsTable(QWidget):
    """Numbers of the noisy input and of every method.

    Parameters
    ----------
    session : Session
        The state; the table only listens.
    turns : Turns or None
        In which it is filled; None for turns of its own.
    """

    selected = Signal(str)

    def __init__(self, session: Session, turns: Turns | None = None) -> None:
        super().__init__()
        self._session = session
        self._selected: str | None = None
        self.model = ResultsModel(self)
        self.view = ResultsView(self.model)
        self._add_actions()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.view)
        self.view.selectionModel().currentRowChanged.connect(self._on_row)
        self._refreshing = Work(turns or Turns(self), self._refresh)
        self._refresh_soon = Coalesced(self._refreshing.request, _REFRESH_MS, self)
        for signal in (session.meshes_changed, session.run_changed):
            signal.connect(self._refresh_soon.request)
        session.study_changed.connect(self._on_study_changed)
        self._refreshing.request()

    def set_selected(self, method: str | None) -> None:
        """Mark a method's row."""
        self._selected = method
        self._mark_selected()

    def copy(self, write: Callable[[Sequence[ResultRow]], str] = as_text) -> None:
        """Copy the table to the clipboard, as text of fixed width unless told otherwise."""
        QGuiApplication.clipboard().setText(write(self.model.rows))

    def writer(self) -> Callable[[Path], None]:
        """Return what saves the table of now as CSV, Markdown, LaTeX or text, by the suffix."""
        return partial(save_table, rows=self.model.rows)

    def sizeHint(self) -> QSize:
        return QSize(560, 220)

    def _add_actions(self) -> None:
        for text, write in _FORMATS.items():
            action = QAction(text, self.view)
            action.triggered.connect(partial(self.copy, write))
            if write is as_text:
                action.setShortcut(QKeySequence.StandardKey.Copy)
                action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            self.view.addAction(action)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)

    def _on_study_changed(self, study: Study, before: Study) -> None:
        if not study.compares_like(before):
            self._refresh_soon.request()

    def _refresh(self) -> Iterator[None]:
        meshes = self._session.meshes
        outcomes = session_outcomes(self._session)
        metric = self._session.study.metric
        noisy = meshes.comparison.noisy_errors if meshes else None
        metrics = self._session.study.metrics
        self.model.show(result_rows(noisy, outcomes, metric, metrics) if noisy else ())
        self._mark_selected()
        yield
        self.view.fit_columns()

    def _mark_selected(self) -> None:
        """Select the row of the selected method; `_on_row` sees that nothing is new."""
        methods = [row.method for row in self.model.rows]
        selection = self.view.selectionModel()
        if self._selected is None or self._selected not in methods:
            selection.clear()
            return
        row = self.model.index(methods.index(self._selected), TITLE)
        flags = QItemSelectionModel.SelectionFlag
        selection.setCurrentIndex(row, flags.ClearAndSelect | flags.Rows)

    def _on_row(self, current: QModelIndex) -> None:
        method = self.model.rows[current.row()].method if current.isValid() else None
        if method and method != self._selected:
            self._selected = method
            self.selected.emit(method)
