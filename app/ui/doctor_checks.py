"""What the mesh doctor has looked for and not found."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from app.ui.controls import FaintLabel
from app.ui.doctor_sign import SOUND_COLOUR, SOUND_ICON
from app.ui.icons import font_icon
from core.doctor import FindingSpec

_COLUMNS = 2
_ICON_PIXELS = 16


class DoctorChecks(QWidget):
    """A tick for each finding that a mesh has not."""

    def __init__(self) -> None:
        super().__init__()
        self.titles: list[str] = []
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 8, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(6)
        for column in range(_COLUMNS):
            self._grid.setColumnStretch(2 * column + 1, 1)

    def show_absent(self, specs: Sequence[FindingSpec]) -> None:
        """List them anew."""
        while item := self._grid.takeAt(0):
            item.widget().deleteLater()
        self.titles = [spec.title for spec in specs]
        self.setVisible(bool(specs))
        self._grid.addWidget(FaintLabel("Looked for and not found:"), 0, 0, 1, 2 * _COLUMNS)
        rows = -(-len(specs) // _COLUMNS)
        for place, spec in enumerate(specs):
            column, row = divmod(place, rows)
            self._add(spec, row + 1, 2 * column)

    def _add(self, spec: FindingSpec, row: int, column: int) -> None:
        tick, title = QLabel(), QLabel(spec.title)
        tick.setPixmap(font_icon(SOUND_ICON, color=SOUND_COLOUR).pixmap(_ICON_PIXELS, _ICON_PIXELS))
        title.setToolTip(f"<p>{spec.meaning}</p>")
        title.setTextFormat(Qt.TextFormat.PlainText)
        self._grid.addWidget(tick, row, column)
        self._grid.addWidget(title, row, column + 1)
