"""The panel beside the statistics: what is compared, how it is measured, and the summary."""

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFrame,
    QGridLayout,
    QLabel,
    QMenu,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.export.statistics_reports import summary_rows
from app.export.statistics_series import SERIES_COLOURS
from app.ui.controls import FaintLabel, IconButton, WheelGuard
from app.ui.parameter_form import ParameterForm
from core.statistics import GeodesicParams, Summary
from core.statistics_view import StatisticsSettings

WIDTH = 288

COLOURINGS = {
    "none": "Nothing",
    "degree": "Degree",
    "assortativity": "K_nn",
    "clustering": "Clustering",
    "distance": "Distance from the picked vertex",
}
_MATRICES = {"laplacian": "Laplacian L = D − A", "normalized_laplacian": "Normalised Laplacian"}


class StatisticsSide(QWidget):
    """Choices and numbers.

    Signals
    -------
    changed(str) : a choice was changed, under the name of the step.
    second_chosen(str) : which model to lay over the first.
    resumed() : go on with work that was cancelled.
    """

    changed = Signal(str)
    second_chosen = Signal(str)
    resumed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.second = QComboBox()
        self.matrix = QComboBox()
        self.colour = QComboBox()
        self.geodesic = ParameterForm(GeodesicParams)
        self.relative = QCheckBox("As share of the longest")
        self.relative.setToolTip("Makes the distances of a large and a small model comparable.")
        self.tools = QToolButton(text="Mesh tools", autoRaise=False)
        self.tools.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.tools.setMenu(QMenu(self.tools))
        self._summary = QGridLayout()
        self._tables: list[list[tuple[str, str]]] = []
        self._text = FaintLabel()
        self.go_on = IconButton("mdi6.play-circle-outline", "Go on computing")
        self._fill()
        self._lay_out()
        self._connect()
        self.show_activity(None, cancelled=False)

    def settings(self) -> dict[str, Any]:
        """Return what is chosen, besides the second model."""
        return {
            "matrix": self.matrix.currentData(),
            "colour": self.colour.currentData(),
            "relative": self.relative.isChecked(),
            "geodesic": self.geodesic.values(),
        }

    def show_settings(self, settings: StatisticsSettings) -> None:
        """Show what a study has chosen."""
        for widget in (self.matrix, self.colour, self.relative):
            widget.blockSignals(True)
        self.matrix.setCurrentIndex(self.matrix.findData(settings.matrix))
        self.colour.setCurrentIndex(self.colour.findData(settings.colour))
        self.relative.setChecked(settings.relative)
        for widget in (self.matrix, self.colour, self.relative):
            widget.blockSignals(False)
        if self.geodesic.values() != settings.geodesic:
            self.geodesic.set_values(settings.geodesic)

    def offer_second(self, choices: dict[str, str], current: str) -> None:
        """List the models that can be laid over the first."""
        with QSignalBlocker(self.second):
            self.second.clear()
            for id_, name in choices.items():
                self.second.addItem(name, id_)
            self.second.setCurrentIndex(max(self.second.findData(current), 0))

    def show_summaries(self, summaries: Sequence[Summary]) -> None:
        """Show the numbers of one model or two side by side."""
        tables = [summary_rows(summary) for summary in summaries]
        if tables == self._tables:  # new labels would make the panel jump
            return
        self._tables = tables
        while item := self._summary.takeAt(0):
            item.widget().deleteLater()
        for row, cells in enumerate(zip(*tables, strict=True)):
            self._summary.addWidget(QLabel(_sentence(cells[0][0])), row, 0)
            for column, (_, value) in enumerate(cells):
                self._summary.addWidget(self._value(value, column, len(cells)), row, column + 1)

    def show_activity(self, activity: str | None, *, cancelled: bool) -> None:
        """Show what is being computed, or that it was cancelled, with a button to go on."""
        stopped = activity is None and cancelled
        self.go_on.setVisible(stopped)
        waiting = f"{activity} …" if activity else ""
        self._text.setText("Cancelled; some plots are not complete." if stopped else waiting)

    def _value(self, value: str, column: int, count: int) -> QLabel:
        label = QLabel(value)
        label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        label.setAlignment(Qt.AlignmentFlag.AlignRight)
        if count > 1:
            label.setStyleSheet(f"color: {SERIES_COLOURS[column]}")
        return label

    def _fill(self) -> None:
        for box, choices, name in (
            (self.matrix, _MATRICES, "Spectrum of"),
            (self.colour, COLOURINGS, "Colour the model by"),
            (self.second, {}, "Second model"),
        ):
            for id_, text in choices.items():
                box.addItem(text, id_)
            box.setAccessibleName(name)
            box.setSizeAdjustPolicy(
                QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
            )
            WheelGuard(self).guard(box)

    def _lay_out(self) -> None:
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(8, 6, 8, 6)
        column.setSpacing(3)
        for title, widget in (
            ("Second model", self.second),
            ("Colour the model by", self.colour),
            ("Spectrum of", self.matrix),
        ):
            column.addWidget(QLabel(title))
            column.addWidget(widget)
        column.addWidget(_heading("Summary"))
        self._summary.setHorizontalSpacing(6)
        self._summary.setColumnStretch(0, 1)
        self._summary.setVerticalSpacing(0)
        column.addLayout(self._summary)
        column.addWidget(self.tools)
        column.addWidget(_heading("Geodesic distances"))
        column.addWidget(self.relative)
        column.addWidget(self.geodesic)
        column.addStretch()
        scroll = QScrollArea(widgetResizable=True, frameShape=QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(inside)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(scroll, 1)
        layout.addLayout(self._progress_row())

    def _progress_row(self) -> QGridLayout:
        row = QGridLayout()
        row.setContentsMargins(8, 2, 4, 4)
        row.setColumnStretch(0, 1)
        row.addWidget(self._text, 0, 0)
        row.addWidget(self.go_on, 0, 1)
        return row

    def _connect(self) -> None:
        for signal, step in (
            (self.matrix.currentIndexChanged, "Spectrum"),
            (self.colour.currentIndexChanged, "Colour of the models"),
            (self.geodesic.changed, "Geodesic distances"),
            (self.relative.toggled, "Unit of the distances"),
        ):
            signal.connect(lambda *_, step=step: self.changed.emit(step))
        self.second.activated.connect(
            lambda index: self.second_chosen.emit(self.second.itemData(index))
        )
        self.go_on.clicked.connect(self.resumed)


def _heading(text: str) -> QLabel:
    label = QLabel(f"<b>{text}</b>")
    label.setContentsMargins(0, 8, 0, 2)
    return label


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
