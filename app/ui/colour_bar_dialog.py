"""The settings of the colour bar that all panes share; each change shows at once."""

from typing import Any, get_args

import numpy as np
from matplotlib import colormaps
from PySide6.QtCore import QSignalBlocker, QSize, Qt
from PySide6.QtGui import QIcon, QImage, QPixmap
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QWidget,
)

from app.ui.parameter_form import PlainSpinBox
from core.metrics import METRICS
from core.parameters import describe
from core.view import ColourMap, ViewSettings

_RANGES = {
    "percentile": "98th percentile",
    "full": "Smallest to largest",
    "manual": "By hand",
}
_NAMES = {"gray": "Grey"}
_SWATCH = QSize(88, 12)
_MOST = 1e9
_HELP = {parameter.name: parameter.help for parameter in describe(ViewSettings)}


class ColourBarDialog(QDialog):
    """Changes the colour settings of a window's study.

    Parameters
    ----------
    window : MainWindow
        The window, which stays usable.
    """

    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Colour bar")
        self._window = window
        metrics = {id_: spec.heat_title for id_, spec in METRICS.items()}
        self.metric_box = _combo({"none": "Nothing", **metrics})
        self.range = _combo(_RANGES)
        self.low, self.high = _number("Lower end"), _number("Upper end")
        maps = {name: _NAMES.get(name, name.capitalize()) for name in get_args(ColourMap)}
        self.map = _combo(maps)
        self.map.setIconSize(_SWATCH)
        self.reversed = QCheckBox("Reversed")
        self.histogram = QCheckBox("Histogram beside the bar")
        self._lay_out()
        self._connect()
        self.refresh()

    @classmethod
    def open_for(cls, window: Any) -> "ColourBarDialog":
        """Show the dialog of a window; there is one at a time."""
        dialog = window.findChild(cls) or cls(window)
        dialog.show()
        dialog.raise_()
        dialog.activateWindow()
        return dialog

    def refresh(self, *_: object) -> None:
        """Show the study."""
        view = self._view()
        boxes = {
            self.metric_box: view.colour,
            self.range: view.colour_range,
            self.map: view.colour_map,
        }
        for box, value in boxes.items():
            box.setCurrentIndex(box.findData(value))
        for check, on in ((self.reversed, view.colour_reversed), (self.histogram, view.histogram)):
            with QSignalBlocker(check):
                check.setChecked(on)
        low, high = self._ends(view)
        for number, value in ((self.low, low), (self.high, high)):
            number.setEnabled(view.colour_range == "manual")
            with QSignalBlocker(number):
                number.setValue(value)
        for index, name in enumerate(get_args(ColourMap)):
            self.map.setItemIcon(index, _swatch(name + ("_r" if view.colour_reversed else "")))

    def _lay_out(self) -> None:
        ends = QHBoxLayout()
        ends.addWidget(self.low, 1)
        ends.addWidget(QLabel("to"))
        ends.addWidget(self.high, 1)
        form = QFormLayout(self)
        form.addRow("Colour &by", self.metric_box)
        form.addRow("&Range", self.range)
        form.addRow("", ends)
        form.addRow("&Colours", self.map)
        form.addRow("", self.reversed)
        form.addRow("", self.histogram)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)
        tips = {
            self.metric_box: "colour", self.range: "colour_range", self.low: "colour_low",
            self.high: "colour_high", self.map: "colour_map", self.reversed: "colour_reversed",
            self.histogram: "histogram",
        }  # fmt: skip
        for widget, name in tips.items():
            widget.setToolTip(_HELP[name])

    def _connect(self) -> None:
        self.metric_box.activated.connect(self._choose_metric)
        self.map.activated.connect(lambda _: self._change(colour_map=self.map.currentData()))
        self.range.activated.connect(self._choose_range)
        for number in (self.low, self.high):
            number.valueChanged.connect(self._set_ends)
        self.reversed.toggled.connect(lambda on: self._change(colour_reversed=on))
        self.histogram.toggled.connect(lambda on: self._change(histogram=on))
        session = self._window.session
        session.study_changed.connect(self.refresh)

    def done(self, result: int) -> None:
        self._window.session.study_changed.disconnect(self.refresh)
        super().done(result)

    def _choose_metric(self) -> None:
        view = self._view().coloured_by(self.metric_box.currentData())
        self._window.change_view("Colour by", view)

    def _choose_range(self) -> None:
        """Start from the ends that are shown, so that nothing jumps."""
        low, high = self._ends(self._view())
        self._change(colour_range=self.range.currentData(), colour_low=low, colour_high=high)

    def _set_ends(self) -> None:
        if self.low.value() < self.high.value():
            self._change(colour_low=self.low.value(), colour_high=self.high.value())

    def _ends(self, view: ViewSettings) -> tuple[float, float]:
        if view.colour_range == "manual":
            return view.colour_low, view.colour_high
        ends = self._window.denoise.panes()[1].colour_range
        return tuple(float(f"{end:.4g}") for end in ends)

    def _view(self) -> ViewSettings:
        return self._window.session.study.view

    def _change(self, **update: object) -> None:
        self._window.change_view("Colour bar", self._view().model_copy(update=update))


def _combo(names: dict[str, str]) -> QComboBox:
    box = QComboBox()
    for key, name in names.items():
        box.addItem(name, key)
    return box


def _number(name: str) -> QWidget:
    box = PlainSpinBox(keyboardTracking=False)
    box.setDecimals(8)
    box.setRange(-_MOST, _MOST)
    box.setStepType(PlainSpinBox.StepType.AdaptiveDecimalStepType)
    box.setAccessibleName(name)
    box.setMinimumWidth(90)
    return box


def _swatch(colour_map: str) -> QIcon:
    """Picture of a colour map, from its lower to its upper end."""
    colours = colormaps[colour_map](np.linspace(0, 1, _SWATCH.width()), bytes=True)[:, :3]
    rows = np.ascontiguousarray(np.broadcast_to(colours, (_SWATCH.height(), *colours.shape)))
    width, height = _SWATCH.width(), _SWATCH.height()
    image = QImage(rows.data, width, height, 3 * width, QImage.Format.Format_RGB888)
    return QIcon(QPixmap.fromImage(image.copy()))
