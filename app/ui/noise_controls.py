"""How the noisy mesh comes about: added noise, or a file of its own."""

import math
import random
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSignalBlocker, QTimer, Signal
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QDoubleSpinBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.session import Session
from app.ui.controls import FaintLabel, IconButton, JumpSlider, WheelGuard
from core.noise import NoiseParams
from core.parameters import describe

_DEBOUNCE_MS = 150
_POSITIONS = 1000
_BEND = 999.0
_SEEDS = 100_000


class NoiseControls(QWidget):
    """σ and seed of the added noise, and the choice of a separate noisy file."""

    file_requested = Signal()

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._help = {parameter.name: parameter for parameter in describe(NoiseParams)}
        self._guard = WheelGuard(self)
        self._make_noise()
        self._make_file()
        self._lay_out()
        self._apply_later = QTimer(self, singleShot=True, interval=_DEBOUNCE_MS)
        self._apply_later.timeout.connect(self._apply)
        session.study_changed.connect(self._refresh)
        session.meshes_changed.connect(self._refresh)
        session.failed.connect(self._refresh)
        self._refresh()

    def _make_noise(self) -> None:
        self.slider = JumpSlider()
        self.slider.setRange(0, _POSITIONS)
        self.slider.setPageStep(50)
        self.sigma = QDoubleSpinBox(decimals=4, maximum=1.0, suffix=" ℓ̄", keyboardTracking=False)
        self.sigma.setStepType(QAbstractSpinBox.StepType.AdaptiveDecimalStepType)
        self.seed = QSpinBox(maximum=int(self._help["seed"].high or 0), keyboardTracking=False)
        self.dice = IconButton("mdi6.dice-5-outline", "New seed")
        for widget, name in ((self.slider, "sigma"), (self.sigma, "sigma"), (self.seed, "seed")):
            widget.setToolTip(self._help[name].help)
        self.slider.setAccessibleName("Noise")
        self.sigma.setAccessibleName("Standard deviation of the noise")
        self.seed.setAccessibleName("Seed of the noise")
        self._guard.guard(self.slider, self.sigma, self.seed)
        self.slider.valueChanged.connect(self._on_slider)
        self.sigma.valueChanged.connect(self._on_sigma)
        self.seed.valueChanged.connect(self._on_seed)
        self.dice.clicked.connect(lambda: self.seed.setValue(random.randrange(_SEEDS)))

    def _make_file(self) -> None:
        self.choose_file = QPushButton("Separate noisy file…")
        self.choose_file.setToolTip(
            "Compare with a scan of the same model instead of adding noise; "
            "it must have the same vertices in the same order."
        )
        self.choose_file.clicked.connect(self.file_requested)
        self.clear_file = IconButton("mdi6.close", "Go back to added noise")
        self.clear_file.clicked.connect(self._clear_file)
        self.note = FaintLabel()

    def _lay_out(self) -> None:
        title = QLabel("Noise σ")
        font = title.font()
        font.setBold(True)
        title.setFont(font)
        grid = QGridLayout()
        grid.setColumnStretch(1, 1)
        grid.addWidget(title, 0, 0)
        grid.addWidget(self.sigma, 0, 1, 1, 2)
        grid.addWidget(self.slider, 1, 0, 1, 3)
        grid.addWidget(QLabel("Seed"), 2, 0)
        grid.addWidget(self.seed, 2, 1)
        grid.addWidget(self.dice, 2, 2)
        file_row = QHBoxLayout()
        file_row.addWidget(self.choose_file, 1)
        file_row.addWidget(self.clear_file)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addLayout(grid)
        layout.addLayout(file_row)
        layout.addWidget(self.note)

    def _refresh(self, *_: Any) -> None:
        """Show the study, but leave a handle alone that a person holds."""
        study = self._session.study
        if not (self.slider.isSliderDown() or self._apply_later.isActive()):
            self._show_sigma(study.noise.sigma)
        with QSignalBlocker(self.seed):
            self.seed.setValue(study.noise.seed)
        own_file = study.noisy is not None
        for widget in (self.slider, self.sigma, self.seed, self.dice):
            widget.setDisabled(own_file)
        self.clear_file.setVisible(own_file)
        self.note.setVisible(own_file)
        if study.noisy is not None:
            self.note.setText(f"No noise is added: the noisy mesh is {Path(study.noisy).name}.")
            self.note.setToolTip(study.noisy)

    def _show_sigma(self, sigma: float) -> None:
        with QSignalBlocker(self.slider), QSignalBlocker(self.sigma):
            self.slider.setValue(position_of(sigma))
            self.sigma.setValue(sigma)

    def _on_slider(self, position: int) -> None:
        with QSignalBlocker(self.sigma):
            self.sigma.setValue(sigma_at(position))
        self._apply_later.start()

    def _on_sigma(self, sigma: float) -> None:
        with QSignalBlocker(self.slider):
            self.slider.setValue(position_of(sigma))
        self._apply_later.start()

    def _on_seed(self, seed: int) -> None:
        self._change(NoiseParams(sigma=self.sigma.value(), seed=seed), "Seed")

    def _apply(self) -> None:
        noise = NoiseParams(sigma=self.sigma.value(), seed=self.seed.value())
        self._change(noise, "Noise")

    def _change(self, noise: NoiseParams, step: str) -> None:
        self._apply_later.stop()
        self._session.apply(self._session.study.model_copy(update={"noise": noise}), step)

    def _clear_file(self) -> None:
        study = self._session.study.model_copy(update={"noisy": None})
        self._session.apply(study, "Added noise")


def sigma_at(position: int) -> float:
    """Return σ in ℓ̄ at a place of the slider, which is nearly logarithmic but reaches 0."""
    share = math.expm1(position / _POSITIONS * math.log1p(_BEND)) / _BEND
    return round(share, 3)


def position_of(sigma: float) -> int:
    """Return the place of the slider that shows a σ in ℓ̄."""
    return round(_POSITIONS * math.log1p(_BEND * sigma) / math.log1p(_BEND))
