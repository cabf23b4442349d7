"""The dialog of a figure: which panes, in which order, with which captions, how large."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QSpinBox,
    QVBoxLayout,
)

from app.export.montage import montage_pictures
from app.export.montage_files import write_montage
from app.export.montage_plan import Montage
from app.ui.controls import FaintLabel
from app.ui.dialogs import ask_where_to_save
from app.ui.exporting import Drawer, export
from app.ui.montage_cells import CellList
from app.ui.montage_preview import MontagePreview

_FILTERS = "PNG (*.png);;PDF (*.pdf);;TIFF (*.tiff)"
_GROUNDS = {"white": "White", "transparent": "Transparent", "theme": "As in the window"}
_KEPT = "figure"


class MontageDialog(QDialog):
    """Arranges panes in a figure; the preview is drawn by what draws the file.

    Parameters
    ----------
    window : MainWindow
        Where the panes are.
    """

    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Figure")
        self.resize(1060, 640)
        self._window = window
        self.source = window.desk.montage()
        entries = self.source.entries()
        self.cells = CellList(entries)
        self.columns = QSpinBox(minimum=1, maximum=9, value=min(3, len(entries)))
        self.letters = QCheckBox("Letters (a), (b), (c)", checked=True)
        self.bar = QCheckBox("Colour bar", checked=True)
        self.bar.setEnabled(bool(self.source.look.colour_title))
        if not self.bar.isEnabled():
            self.bar.setToolTip("Nothing is coloured. View → Colour by gives the panes colours.")
        self.ground = QComboBox()
        for key, name in _GROUNDS.items():
            self.ground.addItem(name, key)
        self.width_box, self.height_box = _centimetres(3, 16), _centimetres(0, 0)
        self.height_box.setSpecialValueText("automatic")
        self.dpi = QSpinBox(minimum=50, maximum=1200, value=300, suffix=" dpi", singleStep=50)
        self.font_box = QSpinBox(minimum=4, maximum=36, value=9, suffix=" pt")
        self.preview = MontagePreview(self.source, window.session)
        self.size_label = FaintLabel()
        self._restore()
        self._lay_out()
        self._connect()

    @classmethod
    def open_for(cls, window: Any) -> "MontageDialog":
        """Show the dialog of a window."""
        dialog = cls(window)
        dialog.open()
        return dialog

    def montage(self) -> Montage:
        """Return the figure as it is wanted."""
        return Montage(
            cells=self.cells.chosen(),
            columns=self.columns.value(),
            letters=self.letters.isChecked(),
            bar=self.bar.isChecked(),
            ground=self.ground.currentData(),
            width=self.width_box.value(),
            height=self.height_box.value(),
            dpi=self.dpi.value(),
            font_size=self.font_box.value(),
        )

    def save(self, path: Path) -> None:
        """Write the figure beside the window, which the dialog sets free."""
        montage, source = self.montage(), self.source

        def begin(path: Path, drawer: Drawer) -> Iterator[float]:
            pictures = drawer(iter(montage_pictures(montage, source)))
            yield from write_montage(montage, source, path, pictures)

        export(self._window.session, path, begin)
        self.accept()

    def done(self, result: int) -> None:
        """Keep the settings for the next figure."""
        self.preview.close_work()
        montage = self.montage()
        for name in ("columns", "letters", "bar", "ground", "width", "height", "dpi", "font_size"):
            QSettings().setValue(f"{_KEPT}/{name}", getattr(montage, name))
        super().done(result)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._update()

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.addRow("&Columns", self.columns)
        form.addRow("&Width", self.width_box)
        form.addRow("&Height", self.height_box)
        form.addRow("&Resolution", self.dpi)
        form.addRow("&Text", self.font_box)
        form.addRow("&Ground", self.ground)
        form.addRow("", self.letters)
        form.addRow("", self.bar)
        left = QVBoxLayout()
        left.addWidget(FaintLabel("Check panes, drag them into order, double-click a caption."))
        left.addWidget(self.cells, 1)
        left.addLayout(form)
        left.addWidget(self.size_label)
        row = QHBoxLayout()
        row.addLayout(left)
        row.addWidget(self.preview, 1)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        save = buttons.addButton("Save…", QDialogButtonBox.ButtonRole.AcceptRole)
        save.setDefault(True)
        buttons.accepted.connect(self._ask)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(row, 1)
        layout.addWidget(buttons)
        self.save_button = save
        self.cells.setFixedWidth(290)
        self.size_label.setFixedWidth(290)

    def _connect(self) -> None:
        for box in (self.columns, self.width_box, self.height_box, self.dpi, self.font_box):
            box.valueChanged.connect(self._update)
        for check in (self.letters, self.bar):
            check.toggled.connect(self._update)
        self.ground.currentIndexChanged.connect(self._update)
        self.cells.changed.connect(self._update)
        self.preview.told.connect(self._tell)

    def _restore(self) -> None:
        """Take the settings of the last figure."""
        kept = QSettings()
        for name, box in (
            ("columns", self.columns), ("width", self.width_box), ("height", self.height_box),
            ("dpi", self.dpi), ("font_size", self.font_box),
        ):  # fmt: skip
            value = kept.value(f"{_KEPT}/{name}")
            if value is not None:
                box.setValue(type(box.value())(float(value)))
        for name, check in (("letters", self.letters), ("bar", self.bar)):
            check.setChecked(str(kept.value(f"{_KEPT}/{name}", True)).lower() == "true")
        self.ground.setCurrentIndex(self.ground.findData(kept.value(f"{_KEPT}/ground", "white")))

    def _update(self, *_: object) -> None:
        self.preview.show_montage(self.montage())

    def _tell(self, text: str, possible: bool) -> None:
        self.size_label.setText(text)
        self.save_button.setEnabled(possible)

    def _ask(self) -> None:
        stem = Path(self._window.session.meshes.name).stem
        ask_where_to_save(self, "Save the figure", f"{stem}_figure.png", _FILTERS, self.save)


def _centimetres(low: float, value: float) -> QDoubleSpinBox:
    return QDoubleSpinBox(
        minimum=low, maximum=200, value=value, decimals=1, singleStep=0.5, suffix=" cm"
    )
