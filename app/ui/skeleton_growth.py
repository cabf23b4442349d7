"""The growth bar: shows the graphs band by band, figure 5.4, by hand or by itself."""

from PySide6.QtCore import QSignalBlocker, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from app.ui.controls import IconButton, JumpSlider

_STEP_MS = 220
_LONGEST = "all 64 bands"


class GrowthBar(QWidget):
    """Slider from no band to all of them.

    Signals
    -------
    changed(object) : the number of bands that have grown, None for all.
    """

    changed = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.play = IconButton("mdi6.play", "Let the graphs grow band by band")
        self.pause = IconButton("mdi6.pause", "Stop the growth here")
        self.pause.hide()
        self.slider = JumpSlider()
        self.slider.setRange(0, 1)
        self.slider.setValue(1)
        self.slider.setAccessibleName("Bands that have grown")
        self.slider.setToolTip("Show the graphs up to this band")
        self.label = QLabel()
        # One size for every text: else the whole window is laid out anew whenever R changes it.
        self.label.setFixedSize(self.label.fontMetrics().size(0, _LONGEST))
        self._timer = QTimer(self, interval=_STEP_MS)
        self._timer.timeout.connect(self._advance)
        self.play.clicked.connect(self.start)
        self.pause.clicked.connect(self.stop)
        self.slider.valueChanged.connect(self._on_value)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(8, 2, 8, 2)
        layout.addWidget(QLabel("Growth"))
        for widget in (self.play, self.pause):
            layout.addWidget(widget)
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.label)
        self.set_last(1)

    @property
    def step(self) -> int | None:
        """Number of bands that have grown; None for all."""
        value = self.slider.value()
        return None if value == self.slider.maximum() else value

    @property
    def is_playing(self) -> bool:
        """Whether the graphs grow by themselves."""
        return self._timer.isActive()

    def set_last(self, last: int) -> None:
        """Set the number of bands there are; a graph that is whole stays whole."""
        whole = self.step is None
        with QSignalBlocker(self.slider):
            self.slider.setRange(0, last)
            self.slider.setValue(last if whole else min(self.slider.value(), last))
        self._tell()

    def start(self) -> None:
        """Grow from here, or from the first band if all are there."""
        if self.step is None:
            self.slider.setValue(0)
        self._set_playing(True)

    def stop(self) -> None:
        """Stay where the growth is."""
        self._set_playing(False)

    def _set_playing(self, playing: bool) -> None:
        self.play.setVisible(not playing)
        self.pause.setVisible(playing)
        if playing:
            self._timer.start()
        else:
            self._timer.stop()

    def _advance(self) -> None:
        self.slider.setValue(self.slider.value() + 1)
        if self.step is None:
            self.stop()

    def _on_value(self) -> None:
        self._tell()
        self.changed.emit(self.step)

    def _tell(self) -> None:
        last = self.slider.maximum()
        self.label.setText(f"all {last} bands" if self.step is None else f"{self.step} of {last}")
