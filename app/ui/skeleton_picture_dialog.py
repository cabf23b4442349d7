"""Asks how large a picture of the skeletal graphs shall be, and on which ground."""

from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QSpinBox,
    QWidget,
)

_LARGEST = 8


@dataclass(frozen=True)
class PictureRequest:
    """A picture as the user wants it."""

    scale: int = 1
    transparent: bool = False
    selected_only: bool = False


class PictureDialog(QDialog):
    """Dialog for a picture.

    Parameters
    ----------
    parent : QWidget
        The tab.
    size : (int, int)
        Size of the views on the screen in pixels.
    count : int
        Number of views that are shown.
    """

    wanted = Signal(PictureRequest)

    def __init__(self, parent: QWidget, size: tuple[int, int], count: int) -> None:
        super().__init__(parent)
        self.setWindowTitle("Picture")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._size = size
        self.subject = QComboBox()
        self.subject.addItem("Both views" if count > 1 else "The view", False)
        if count > 1:
            self.subject.addItem("The selected view", True)
        self.scale = QSpinBox(minimum=1, maximum=_LARGEST, value=2, prefix="× ")
        self.transparent = QCheckBox("Transparent background")
        self.size_label = QLabel()
        form = QFormLayout(self)
        form.addRow("Picture of", self.subject)
        form.addRow("Size", self.scale)
        form.addRow("", self.size_label)
        form.addRow("", self.transparent)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        buttons.addButton("Save…", QDialogButtonBox.ButtonRole.AcceptRole).setDefault(True)
        buttons.accepted.connect(self._accept)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)
        self.subject.currentIndexChanged.connect(self._update)
        self.scale.valueChanged.connect(self._update)
        self._update()

    def _update(self) -> None:
        width, height = self._size
        width = width // 2 if self.subject.currentData() else width
        scale = self.scale.value()
        self.size_label.setText(f"{width * scale:,} × {height * scale:,} pixels")

    def _accept(self) -> None:
        selected_only = bool(self.subject.currentData())
        self.wanted.emit(
            PictureRequest(self.scale.value(), self.transparent.isChecked(), selected_only)
        )
        self.accept()
