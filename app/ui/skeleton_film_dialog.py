"""Asks what to film, in which format and how fast."""

from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QFormLayout, QSpinBox, QWidget

from app.export.skeleton_films import FILM_SUFFIXES


@dataclass(frozen=True)
class FilmRequest:
    """An animation as the user wants it; `frames` counts for a turn only."""

    subject: Literal["turn", "growth"] = "turn"
    suffix: str = ".gif"
    frames: int = 72
    per_second: float = 24.0


class FilmDialog(QDialog):
    """Dialog for an animation."""

    wanted = Signal(FilmRequest)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Animation")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.subject = QComboBox()
        self.subject.addItem("A full turn of the model", "turn")
        self.subject.addItem("The growth, band by band", "growth")
        self.format = QComboBox()
        for suffix in FILM_SUFFIXES:
            self.format.addItem(suffix[1:].upper(), suffix)
        self.frames = QSpinBox(minimum=8, maximum=720, value=72, singleStep=8)
        self.per_second = QSpinBox(minimum=1, maximum=60, value=24, suffix=" a second")
        self._lay_out()
        self.subject.currentIndexChanged.connect(self._update)

    def _lay_out(self) -> None:
        form = QFormLayout(self)
        form.addRow("Film", self.subject)
        form.addRow("Format", self.format)
        form.addRow("Frames", self.frames)
        form.addRow("Speed", self.per_second)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        buttons.addButton("Save…", QDialogButtonBox.ButtonRole.AcceptRole).setDefault(True)
        buttons.accepted.connect(self._accept)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)

    def _update(self) -> None:
        turn = self.subject.currentData() == "turn"
        self.frames.setEnabled(turn)
        self.per_second.setValue(24 if turn else 4)

    def _accept(self) -> None:
        self.wanted.emit(
            FilmRequest(
                self.subject.currentData(),
                self.format.currentData(),
                self.frames.value(),
                float(self.per_second.value()),
            )
        )
        self.accept()
