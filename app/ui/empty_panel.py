"""What stands in the viewport before a model is there: what to do next."""

from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.ui.controls import FaintLabel
from app.ui.surfaces import take_own_surface
from core.io import SUPPORTED_READ, bundled_samples
from core.study import SAMPLE_PREFIX

_WIDTH, _MARGIN = 420, 16


class EmptyPanel(QWidget):
    """Covers a viewport while no model is open, with the ways to open one.

    Parameters
    ----------
    window : MainWindow
        Opens what is chosen.
    viewport : QWidget
        What is covered.
    """

    def __init__(self, window: Any, viewport: QWidget) -> None:
        super().__init__(viewport)
        self._window, self._viewport = window, viewport
        self.setAutoFillBackground(True)
        take_own_surface(self)
        self._choices = QWidget()
        self._loading = QLabel("Loading …", alignment=Qt.AlignmentFlag.AlignCenter)
        self.buttons: dict[str, QPushButton] = {}
        self._fill()
        layout = QVBoxLayout(self)
        layout.addWidget(self._choices, 0, Qt.AlignmentFlag.AlignCenter)
        layout.addWidget(self._loading)
        viewport.installEventFilter(self)
        window.session.meshes_changed.connect(self.refresh)
        window.session.activity_changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show or hide the panel; while something is loading it says so."""
        session = self._window.session
        self._choices.setVisible(session.activity is None)
        self._loading.setVisible(session.activity is not None)
        self.setVisible(session.meshes is None)
        # What is covered need not be drawn: the first picture of the window would have to wait.
        self._viewport.interactor.setUpdatesEnabled(session.meshes is not None)
        self._cover()

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._cover()
        return False

    def _cover(self) -> None:
        self.setGeometry(self._viewport.rect())
        self._choices.setFixedWidth(max(min(_WIDTH, self.width() - _MARGIN), 0))
        self.raise_()

    def _fill(self) -> None:
        title = QLabel("Open a model to work on", wordWrap=True)
        title.setAlignment(Qt.AlignmentFlag.AlignCenter)
        font = title.font()
        font.setPointSizeF(1.35 * font.pointSizeF())
        font.setBold(True)
        title.setFont(font)
        formats = ", ".join(suffix.removeprefix(".").upper() for suffix in SUPPORTED_READ)
        column = QVBoxLayout(self._choices)
        column.setSpacing(10)
        column.addWidget(title)
        column.addWidget(_centred(f"Drop a file on the window: {formats}, or a study."))
        column.addLayout(self._row({"open": "Open a file…", "gallery": "Gallery…"}))
        column.addSpacing(8)
        column.addWidget(_centred("Or begin with a bundled model:"))
        samples = QHBoxLayout()
        for sample in bundled_samples():
            button = QPushButton(sample.title)
            button.clicked.connect(
                lambda *_, id_=sample.id: self._window.open_model(SAMPLE_PREFIX + id_)
            )
            self.buttons[sample.id] = button
            samples.addWidget(button)
        column.addLayout(samples)

    def _row(self, commands: dict[str, str]) -> QHBoxLayout:
        row = QHBoxLayout()
        for command, text in commands.items():
            button = QPushButton(text)
            action: QAction = self._window.actions_[command]
            button.setToolTip(action.toolTip())
            button.clicked.connect(action.trigger)
            self.buttons[command] = button
            row.addWidget(button)
        return row


def _centred(text: str) -> QLabel:
    label = FaintLabel(text)
    label.setAlignment(Qt.AlignmentFlag.AlignCenter)
    return label
