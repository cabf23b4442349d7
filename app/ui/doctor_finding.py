"""One finding of the mesh doctor: what it is, what it means, where it is, and a repair."""

from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QPushButton

from app.ui.controls import FaintLabel
from app.ui.doctor_sign import DEFECT_COLOUR, DEFECT_ICON, NOTE_ICON
from app.ui.icons import font_icon
from app.ui.parameter_form import ParameterForm
from core.doctor import Finding, repair_spec
from core.parameters import describe

_ICON_PIXELS = 18


class FindingCard(QFrame):
    """A finding with its buttons.

    Parameters
    ----------
    finding : Finding
        What was found.

    Signals
    -------
    repair_requested(str, dict) : a repair by its id, with the parameters that are not default.
    place_requested(object) : the vertices to point out, None to leave them.
    """

    repair_requested = Signal(str, dict)
    place_requested = Signal(object)

    def __init__(self, finding: Finding) -> None:
        super().__init__(frameShape=QFrame.Shape.NoFrame)
        self.finding = finding
        self._icon = QLabel()
        self.text = QLabel(finding.found.text, wordWrap=True)
        self.meaning = FaintLabel(finding.spec.meaning)
        self.show_button = QPushButton("Show", checkable=True, autoDefault=False)
        self.show_button.setToolTip("Point the place out on the model and go close to it")
        self.repair_button: QPushButton | None = None
        self.form: ParameterForm | None = None
        self.show_button.toggled.connect(self._on_shown)
        self._lay_out()
        self._draw_icon()

    def _lay_out(self) -> None:
        title = QLabel(self.finding.spec.title)
        font = title.font()
        font.setBold(True)
        title.setFont(font)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 4, 0, 8)
        grid.setColumnStretch(1, 1)
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(3)
        for row, widget in enumerate((title, self.text, self.meaning)):
            grid.addWidget(widget, row, 1)
        grid.addWidget(self._icon, 0, 0)
        row = grid.rowCount()
        if self.finding.repair:
            row = self._add_repair(grid, row)
        buttons = QHBoxLayout()
        buttons.setSpacing(8)
        if self.repair_button:
            buttons.addWidget(self.repair_button)
        buttons.addWidget(self.show_button)
        buttons.addStretch()
        grid.addLayout(buttons, row, 1)

    def _add_repair(self, grid: QGridLayout, row: int) -> int:
        spec = repair_spec(self.finding.repair)
        self.repair_button = QPushButton(spec.title, autoDefault=False)
        self.repair_button.setToolTip(spec.summary)
        self.repair_button.clicked.connect(self._on_repair)
        if describe(spec.params):
            self.form = ParameterForm(spec.params)
            grid.addWidget(self.form, row, 1)
            row += 1
        return row

    def set_busy(self, busy: bool) -> None:
        """Take no repairs while one is under way."""
        if self.repair_button:
            self.repair_button.setDisabled(busy)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._draw_icon()

    def _on_repair(self) -> None:
        values = self.form.values() if self.form else {}
        self.repair_requested.emit(self.finding.repair, values)

    def _on_shown(self, on: bool) -> None:
        self.place_requested.emit(self.finding.found.vertices if on else None)

    def _draw_icon(self) -> None:
        ink = self.palette().color(QPalette.ColorRole.PlaceholderText).name()
        defect = self.finding.is_defect
        icon = font_icon(
            DEFECT_ICON if defect else NOTE_ICON, color=DEFECT_COLOUR if defect else ink
        )
        self._icon.setPixmap(icon.pixmap(_ICON_PIXELS, _ICON_PIXELS))
        self._icon.setToolTip("Wrong with the file" if defect else "Worth knowing; may be meant")
