"""A slider for the share of the faces that decimation keeps."""

import math

from PySide6.QtCore import QSignalBlocker, QTimer, Signal
from PySide6.QtWidgets import QDoubleSpinBox, QHBoxLayout, QWidget

from app.ui.controls import JumpSlider, WheelGuard
from core.parameters import describe
from core.study import SkeletonView

_DEBOUNCE_MS = 200
_POSITIONS = 200
_LEAST = next(p.low for p in describe(SkeletonView) if p.name == "keep") or 0.005


class ShareControl(QWidget):
    """Slider and number; the slider is logarithmic, since a quarter of a quarter is a step.

    Signals
    -------
    changed(float) : the share, a moment after the last movement.
    """

    changed = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self.slider = JumpSlider()
        self.slider.setRange(0, _POSITIONS)
        self.number = QDoubleSpinBox(
            minimum=100 * _LEAST, maximum=100, decimals=1, suffix=" %", keyboardTracking=False
        )
        self._timer = QTimer(self, singleShot=True, interval=_DEBOUNCE_MS)
        self._timer.timeout.connect(lambda: self.changed.emit(round(self.number.value() / 100, 4)))
        WheelGuard(self).guard(self.slider, self.number)
        self.slider.valueChanged.connect(self._on_slider)
        self.number.valueChanged.connect(self._on_number)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.number)
        self.set_share(1.0)

    def set_share(self, share: float) -> None:
        """Show a share without a signal, unless a person is about to choose another."""
        if self._timer.isActive() or self.slider.isSliderDown():
            return
        with QSignalBlocker(self.slider), QSignalBlocker(self.number):
            self.slider.setValue(position_of(share))
            self.number.setValue(100 * share)

    def _on_slider(self, position: int) -> None:
        with QSignalBlocker(self.number):
            self.number.setValue(100 * share_at(position))
        self._timer.start()

    def _on_number(self, percent: float) -> None:
        with QSignalBlocker(self.slider):
            self.slider.setValue(position_of(percent / 100))
        self._timer.start()


def share_at(position: int) -> float:
    """Share at a place of the slider."""
    return float(_LEAST ** (1 - position / _POSITIONS))


def position_of(share: float) -> int:
    """Place of the slider that shows a share."""
    return round(_POSITIONS * (1 - math.log(share) / math.log(_LEAST)))
