"""A form for declared parameters, made from their declaration alone."""

from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from PySide6.QtCore import QLocale, QSignalBlocker, Signal, SignalInstance
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QSpinBox,
    QWidget,
)

from app.ui.controls import FaintLabel, IconButton, WheelGuard
from core.parameters import Parameter, Params, describe, value_text

_MOST = 1e9


class ParameterForm(QWidget):
    """Fields for all parameters of a model, with help and a way back to the default.

    `changed` carries the values that differ from their defaults, by name.
    """

    changed = Signal(dict)

    def __init__(self, params: type[Params], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._guard = WheelGuard(self)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setVerticalSpacing(1)
        self._grid.setColumnStretch(1, 1)
        self.fields = {parameter.name: self._add(parameter) for parameter in describe(params)}

    def values(self) -> dict[str, Any]:
        """Return the values that differ from their defaults."""
        return {
            name: field.value() for name, field in self.fields.items() if not field.is_default()
        }

    def set_values(self, values: dict[str, Any]) -> None:
        """Show values, and the defaults where there are none, without a signal."""
        for name, field in self.fields.items():
            value = values.get(name, field.parameter.default)
            if value != field.value():
                field.set_value(value)

    def _add(self, parameter: Parameter) -> "ParameterField":
        field = ParameterField(parameter, self._guard)
        label = QLabel(_sentence(parameter.label))
        label.setBuddy(field.editor)
        short_help = FaintLabel(_short(parameter.help))
        row = self._grid.rowCount()
        self._grid.addWidget(label, row, 0)
        self._grid.addWidget(field, row, 1)
        self._grid.addWidget(field.reset, row, 2)
        self._grid.addWidget(short_help, row + 1, 0, 1, 3)
        self._grid.setRowMinimumHeight(row + 2, 6)
        for widget in (label, field, short_help):
            widget.setToolTip(_tip(parameter))
        field.changed.connect(lambda: self.changed.emit(self.values()))
        return field


class ParameterField(QWidget):
    """Editor of one parameter, with its "auto" box and its reset button."""

    changed = Signal()

    def __init__(self, parameter: Parameter, guard: WheelGuard) -> None:
        super().__init__()
        self.parameter = parameter
        self._access = _EDITORS[parameter.kind](parameter)
        self.editor = self._access.widget
        self.editor.setAccessibleName(_sentence(parameter.label))
        self.auto = QCheckBox("auto") if parameter.optional else None
        self.reset = IconButton("mdi6.restore", f"Back to {value_text(parameter.default)}")
        _keep_room(self.reset)
        guard.guard(self.editor)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.editor, 1)
        if self.auto:
            layout.addWidget(self.auto)
            self.auto.toggled.connect(self._on_edited)
        self._access.edited.connect(self._on_edited)
        self.reset.clicked.connect(self._on_reset)
        self.set_value(parameter.default)

    def value(self) -> Any:
        """Return the value; None means automatic."""
        return None if self.auto and self.auto.isChecked() else self._access.read()

    def set_value(self, value: Any) -> None:
        """Show a value without a signal."""
        with QSignalBlocker(self.editor):
            if value is not None:
                self._access.write(value)
        if self.auto:
            with QSignalBlocker(self.auto):
                self.auto.setChecked(value is None)
        self._update()

    def is_default(self) -> bool:
        """Whether the value is the declared default."""
        return self.value() == self.parameter.default

    def _on_edited(self) -> None:
        self._update()
        self.changed.emit()

    def _on_reset(self) -> None:
        self.set_value(self.parameter.default)
        self.changed.emit()

    def _update(self) -> None:
        self.reset.setVisible(not self.is_default())
        self.editor.setDisabled(bool(self.auto and self.auto.isChecked()))


@dataclass(frozen=True)
class _Access:
    """How to read and write an editor."""

    widget: QWidget
    read: Callable[[], Any]
    write: Callable[[Any], None]
    edited: SignalInstance


class PlainSpinBox(QDoubleSpinBox):
    """Spin box that shows a number with as many digits as it needs."""

    def textFromValue(self, value: float) -> str:
        locale = self.locale()
        locale.setNumberOptions(QLocale.NumberOption.OmitGroupSeparator)
        return locale.toString(value, "g", 8)


def _float_editor(parameter: Parameter) -> _Access:
    box = PlainSpinBox(keyboardTracking=False)
    step = parameter.step or 0.1
    known = (step, parameter.default or step, parameter.low if parameter.logarithmic else step)
    box.setDecimals(max(_decimals(number or 0.0) for number in known) + 1)
    _set_range(box, parameter)
    box.setSingleStep(step)
    if parameter.logarithmic:
        box.setStepType(QAbstractSpinBox.StepType.AdaptiveDecimalStepType)
    # Where the default is automatic, the first value of one's own is ten steps.
    box.setValue(10 * step)
    return _Access(box, box.value, box.setValue, box.valueChanged)


def _int_editor(parameter: Parameter) -> _Access:
    box = QSpinBox(keyboardTracking=False)
    _set_range(box, parameter)
    box.setSingleStep(int(parameter.step or 1))
    return _Access(box, box.value, box.setValue, box.valueChanged)


def _set_range(box: QSpinBox | QDoubleSpinBox, parameter: Parameter) -> None:
    kind = int if isinstance(box, QSpinBox) else float
    low = -_MOST if parameter.low is None else parameter.low
    high = _MOST if parameter.high is None else parameter.high
    box.setRange(kind(low), kind(high))
    box.setSuffix(f" {parameter.unit}" if parameter.unit else "")
    box.setMinimumWidth(80)


def _bool_editor(_: Parameter) -> _Access:
    box = QCheckBox()
    return _Access(box, box.isChecked, box.setChecked, box.toggled)


def _choice_editor(parameter: Parameter) -> _Access:
    box = QComboBox()
    box.addItems(parameter.choices)
    return _Access(box, box.currentText, box.setCurrentText, box.currentTextChanged)


def _text_editor(_: Parameter) -> _Access:
    line = QLineEdit()
    return _Access(line, line.text, line.setText, line.editingFinished)


_EDITORS: dict[str, Callable[[Parameter], _Access]] = {
    "float": _float_editor,
    "int": _int_editor,
    "bool": _bool_editor,
    "choice": _choice_editor,
    "text": _text_editor,
}


def _decimals(number: float) -> int:
    """Digits after the point."""
    return max(0, -int(Decimal(str(number)).normalize().as_tuple().exponent))


def _keep_room(widget: QWidget) -> None:
    """Let a hidden widget keep its place, so that nothing moves when it appears."""
    policy = widget.sizePolicy()
    policy.setRetainSizeWhenHidden(True)
    widget.setSizePolicy(policy)


def _tip(parameter: Parameter) -> str:
    default = value_text(parameter.default)
    return f"{parameter.help}\nAllowed: {parameter.domain}. Default: {default}."


def _sentence(text: str) -> str:
    """Begin with a capital, unless it is a symbol."""
    return text if len(text) == 1 else text[:1].upper() + text[1:]


def _short(text: str) -> str:
    """First clause of a help text; the tooltip has all of it."""
    return text.partition(";")[0].partition(". ")[0].rstrip(".") + "."
