"""The general page of the preferences: theme, memory for results, and the way to the defaults."""

from typing import Any

from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.session import Session
from app.session.memory import default_budget, machine_memory
from app.ui.actions import THEMES
from app.ui.controls import FaintLabel
from app.ui.dialogs import ask_whether

_BUDGET = "memory_megabytes"
_MEGABYTE = 1024**2
_LEAST = 64


def kept_budget() -> int:
    """Return the memory for results in bytes: the one chosen, or a quarter of the machine's."""
    try:
        chosen = int(QSettings().value(_BUDGET, 0))
    except (TypeError, ValueError):
        chosen = 0
    return max(chosen, _LEAST) * _MEGABYTE if chosen else default_budget()


class GeneralPage(QWidget):
    """Settings of the whole program.

    Parameters
    ----------
    window : MainWindow
        What they are applied to.
    """

    title = "General"

    def __init__(self, window: Any) -> None:
        super().__init__()
        self._window = window
        self._session: Session = window.session
        self.theme = QComboBox()
        for mode, name in THEMES.items():
            self.theme.addItem(name, mode)
        self.budget = QSpinBox(minimum=_LEAST, maximum=machine_memory() // _MEGABYTE, suffix=" MB")
        self.budget.setSingleStep(256)
        self.budget.setKeyboardTracking(False)
        self.budget.setGroupSeparatorShown(True)
        self.budget.setAccessibleName("Memory for results")
        self.reset_button = QPushButton("Reset everything to defaults…")
        self._lay_out()
        self._show()
        self.theme.activated.connect(lambda _: window.theme.choose(self.theme.currentData()))
        self.budget.valueChanged.connect(self._change)
        self.reset_button.clicked.connect(self.ask_to_reset)

    def ask_to_reset(self) -> None:
        """Forget what was chosen, after asking."""
        ask_whether(
            self, "Reset everything to defaults?", "It cannot be undone.", "Reset", self.reset
        )

    def reset(self) -> None:
        """Forget all that was chosen: keys, theme, memory, recent files, places of panels."""
        QSettings().clear()
        self._window.apply_preferences()
        self._show()

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.addRow("&Theme", self.theme)
        form.addRow("&Memory for results", self.budget)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(
            FaintLabel(
                "Results stay in memory, so that undo brings them back at once. When they take "
                "more than this, those not used for longest go first and are computed again when "
                "they are needed. The default is a quarter of the machine's memory."
            )
        )
        layout.addStretch()
        layout.addWidget(self.reset_button, alignment=Qt.AlignmentFlag.AlignLeft)
        layout.addWidget(
            FaintLabel("Keys, theme, memory, recent files and, at the next start, the panels.")
        )

    def _show(self) -> None:
        self.theme.setCurrentIndex(self.theme.findData(self._window.theme.mode))
        self.budget.blockSignals(True)
        self.budget.setValue(kept_budget() // _MEGABYTE)
        self.budget.blockSignals(False)

    def _change(self, megabytes: int) -> None:
        QSettings().setValue(_BUDGET, megabytes)
        self._session.set_budget(kept_budget())
