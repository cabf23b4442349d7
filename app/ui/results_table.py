"""The table of results."""

import os
from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QResizeEvent, QShowEvent
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

_REFRESH_MS = 80
_NARROWEST_TITLE = 74
_NOTE_ICON = 26

_FORMATS: dict[str, Callable[[Sequence[ResultRow]], str]] = {
    "Copy as Text": as_text,
    "Copy as CSV": as_csv,
    "Copy as Markdown": as_markdown,
    "Copy as LaTeX": as_latex,
}


class ResultsTable(QWidget):
    """Numbers of the noisy input and of every method.

    Parameters
    ----------
    session : Session
        The state; the table only listens.
    """

    selected = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._selected: str | None = None
        self.model = ResultsModel(self)
        self.view = QTableView(self)
        self._dress()
        self._add_actions()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.view)
        self.view.selectionModel().currentRowChanged.connect(self._on_row)
        self._refresh_soon = Coalesced(self._refresh, _REFRESH_MS, self)
        for signal in (session.study_changed, session.meshes_changed, session.run_changed):
            signal.connect(self._refresh_soon.request)
        self._refresh()

    def set_selected(self, method: str | None) -> None:
        """Mark a method's row."""
        self._selected = method
        self._mark_selected()

    def copy(self, write: Callable[[Sequence[ResultRow]], str] = as_text) -> None:
        """Copy the table to the clipboard, as text of fixed width unless told otherwise."""
        QGuiApplication.clipboard().setText(write(self.model.rows))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Save the table as CSV, Markdown, LaTeX or text, by the suffix.

        Raises
        ------
        SaveError
            If the suffix is another.
        """
        save_table(path, self.model.rows)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_columns()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._fit_columns()

    def sizeHint(self) -> QSize:
        return QSize(560, 220)

    def _dress(self) -> None:
        view = self.view
        view.setModel(self.model)
        font = view.font()
        font.setPointSizeF(0.92 * font.pointSizeF())
        view.setFont(font)
        font.setPointSizeF(0.94 * font.pointSizeF())
        view.horizontalHeader().setFont(font)
        view.setFrameShape(QFrame.Shape.NoFrame)
        view.setShowGrid(False)
        view.setAlternatingRowColors(True)
        view.setTabKeyNavigation(False)
        view.setIconSize(QSize(12, 12))
        view.setTextElideMode(Qt.TextElideMode.ElideRight)
        view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        view.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        view.setAccessibleName("Table of results")
        rows, columns = view.verticalHeader(), view.horizontalHeader()
        rows.hide()
        rows.setDefaultSectionSize(view.fontMetrics().height() + 6)
        columns.setSectionsClickable(False)
        columns.setHighlightSections(False)
        columns.setMinimumSectionSize(_NOTE_ICON)
        columns.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)

    def _add_actions(self) -> None:
        for text, write in _FORMATS.items():
            action = QAction(text, self.view)
            action.triggered.connect(partial(self.copy, write))
            if write is as_text:
                action.setShortcut(QKeySequence.StandardKey.Copy)
                action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            self.view.addAction(action)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)

    def _refresh(self) -> None:
        meshes = self._session.meshes
        outcomes = session_outcomes(self._session)
        metric = self._session.study.metric
        noisy = meshes.comparison.noisy_errors if meshes else None
        self.model.show(result_rows(noisy, outcomes, metric) if noisy else ())
        self._mark_selected()
        self._fit_columns()

    def _fit_columns(self) -> None:
        """Give the numbers what they need, then the names, then the notes."""
        columns = self.view.horizontalHeader()
        needed = [
            max(self.view.sizeHintForColumn(column), columns.sectionSizeHint(column))
            for column in range(self.model.columnCount())
        ]
        room = self.view.viewport().width() - sum(needed[TITLE + 1 : NOTE])
        needed[TITLE] = max(min(needed[TITLE], room - _NOTE_ICON), _NARROWEST_TITLE)
        needed[NOTE] = max(room - needed[TITLE], _NOTE_ICON)
        for column, width in enumerate(needed):
            columns.resizeSection(column, width)

    def _mark_selected(self) -> None:
        """Select the row of the selected method; `_on_row` sees that nothing is new."""
        methods = [row.method for row in self.model.rows]
        selection = self.view.selectionModel()
        if self._selected not in methods:
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
