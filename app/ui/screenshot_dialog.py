"""Asks what to picture, how large, and on which ground."""

from collections.abc import Mapping
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
class Request:
    """A screenshot as the user wants it."""

    subject: str
    scale: int
    transparent: bool


class ScreenshotDialog(QDialog):
    """Dialog for a screenshot.

    Parameters
    ----------
    parent : QWidget
        The window.
    subjects : dict of str to (str, (int, int))
        What can be pictured by id: its title, and its size in pixels at scale 1.
    """

    wanted = Signal(Request)

    def __init__(
        self, parent: QWidget, subjects: Mapping[str, tuple[str, tuple[int, int]]]
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Screenshot")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._sizes = {subject: size for subject, (_, size) in subjects.items()}
        self.subject = QComboBox()
        for subject, (name, _) in subjects.items():
            self.subject.addItem(name, subject)
        self.scale = QSpinBox(minimum=1, maximum=_LARGEST, value=2, prefix="× ")
        self.transparent = QCheckBox("Transparent background")
        self.size_label = QLabel()
        self._lay_out()
        self.subject.currentIndexChanged.connect(self._update)
        self.scale.valueChanged.connect(self._update)
        self._update()

    def _lay_out(self) -> None:
        form = QFormLayout(self)
        form.addRow("Picture of", self.subject)
        form.addRow("Size", self.scale)
        form.addRow("", self.size_label)
        form.addRow("", self.transparent)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        save = buttons.addButton("Save…", QDialogButtonBox.ButtonRole.AcceptRole)
        save.setDefault(True)
        buttons.accepted.connect(self._accept)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)

    def _update(self) -> None:
        """The window is pictured as it is on the screen: its widgets have no other ground."""
        window = self.subject.currentData() == "window"
        self.transparent.setEnabled(not window)
        width, height = self._sizes[self.subject.currentData()]
        scale = self.scale.value()
        self.size_label.setText(f"{width * scale:,} × {height * scale:,} pixels")

    def _accept(self) -> None:
        window = self.subject.currentData() == "window"
        self.wanted.emit(
            Request(
                self.subject.currentData(),
                self.scale.value(),
                self.transparent.isChecked() and not window,
            )
        )
        self.accept()
