"""Loops against genus, component by component, and the check of invariance."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.session.skeleton_maker import Skeleton
from app.ui.controls import FaintLabel
from core.skeleton import LoopCheck

_HEADS = ("Part", "Loops", "Genus", "Why")
_MOST = 200
_ROW_HEIGHT = 22
_ROWS_IN_SIGHT = 6


class FactsPanel(QWidget):
    """Numbers of the selected view.

    Signals
    -------
    check_requested() : the button "Check invariance" was pressed.
    """

    check_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.notes = FaintLabel()
        self.table = QTableWidget(0, len(_HEADS))
        self.table.setHorizontalHeaderLabels(_HEADS)
        self.table.verticalHeader().hide()
        rows = self.table.verticalHeader()
        rows.setMinimumSectionSize(_ROW_HEIGHT)
        rows.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        head = self.table.horizontalHeader()
        head.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        head.setStretchLastSection(True)
        self.check = QPushButton("Check invariance")
        self.check.setToolTip(
            "Turn, move, scale and mirror the model at random, draw its graph again and compare"
        )
        self.check.clicked.connect(self.check_requested)
        self.outcome = FaintLabel()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for widget in (self.notes, self.table, self.check, self.outcome):
            layout.addWidget(widget)
        layout.addStretch()
        self.outcome.hide()
        # The last column wraps, so that its width decides how high the rows are.
        rows.sectionResized.connect(lambda *_: self._fit_table())
        self._fit_table()

    def show_skeleton(self, skeleton: Skeleton | None) -> None:
        """Show the numbers of a graph."""
        checks = skeleton.checks if skeleton else ()
        self.check.setEnabled(skeleton is not None)
        notes = " ".join(skeleton.field.notes) if skeleton else ""
        self.notes.setText(notes)
        self.notes.setVisible(bool(notes))
        self.table.setRowCount(min(len(checks), _MOST))
        self.table.setColumnHidden(0, len(checks) < 2)
        for row, check in enumerate(checks[:_MOST]):
            for column, text in enumerate(_cells(row, check)):
                self.table.setItem(row, column, _item(text))
        self._fit_table()

    def show_outcome(self, text: str) -> None:
        """Show what a check of invariance found."""
        self.outcome.setText(text)
        self.outcome.setVisible(bool(text))

    def _fit_table(self) -> None:
        """Make the table as high as its rows, so that the button below stays in sight."""
        rows = min(self.table.rowCount(), _ROWS_IN_SIGHT)
        inside = sum(self.table.rowHeight(row) for row in range(rows)) or _ROW_HEIGHT
        head = self.table.horizontalHeader().sizeHint().height()
        self.table.setFixedHeight(head + inside + 2 * self.table.frameWidth())


def _cells(row: int, check: LoopCheck) -> tuple[str, ...]:
    genus = "–" if check.genus is None else str(check.genus)
    return str(row + 1), str(check.loops), genus, check.reason


def _item(text: str) -> QTableWidgetItem:
    item = QTableWidgetItem(text)
    item.setToolTip(text)
    item.setFlags(Qt.ItemFlag.ItemIsEnabled)
    return item
