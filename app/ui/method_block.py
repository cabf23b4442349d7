"""One method of the methods panel: switch, iterations, state, parameters."""

from html import escape
from typing import Any

from PySide6.QtCore import QEvent, QObject, QRectF, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.export.tables import WORSE, significant
from app.scene.colours import WARNING_COLOUR, method_colour
from app.session import Run, Session
from app.ui.controls import FaintLabel, IconButton, JumpSlider, WheelGuard
from app.ui.help import HelpButton
from app.ui.parameter_form import ParameterForm
from core.smoothing import METHODS, MethodSpec
from core.study import MOST_ITERATIONS, MethodChoice

_SLIDER_REACH = 30
_BY_HAND = {
    Qt.FocusReason.MouseFocusReason,
    Qt.FocusReason.TabFocusReason,
    Qt.FocusReason.BacktabFocusReason,
}


class IterationControl(QWidget):
    """Slider and number of iterations; `changed` carries the number a person chose."""

    changed = Signal(int)

    def __init__(self, name: str) -> None:
        super().__init__()
        self.slider = JumpSlider()
        self.slider.setAccessibleName(f"{name}: iterations")
        self.box = QSpinBox(minimum=0, maximum=MOST_ITERATIONS, keyboardTracking=False)
        self.box.setAccessibleName(f"{name}: number of iterations")
        self._guard = WheelGuard(self)
        self._guard.guard(self.slider, self.box)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.box)
        self.set_value(0)
        self.slider.valueChanged.connect(self._on_changed)
        self.box.valueChanged.connect(self._on_changed)
        self.slider.sliderReleased.connect(lambda: self.set_value(self.slider.value()))

    def set_value(self, value: int) -> None:
        """Show a number without a signal."""
        with QSignalBlocker(self.slider), QSignalBlocker(self.box):
            # The scale must not change under the pointer that drags the handle.
            if not self.slider.isSliderDown():
                self.slider.setMaximum(max(_SLIDER_REACH, value))
            self.slider.setValue(value)
            self.box.setValue(value)

    def _on_changed(self, value: int) -> None:
        self.set_value(value)
        self.changed.emit(value)


class Swatch(QWidget):
    """A dot in a method's colour."""

    def __init__(self, colour: str) -> None:
        super().__init__()
        self._colour = QColor(colour)
        self.setFixedSize(QSize(12, 12))

    def paintEvent(self, _: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._colour)
        painter.setOpacity(1.0 if self.isEnabled() else 0.45)
        painter.drawEllipse(self.rect().adjusted(1, 1, -1, -1))


class MethodBlock(QWidget):
    """Controls of one method; `selected` says that a person turned to it."""

    selected = Signal(str)

    def __init__(self, session: Session, method: str) -> None:
        super().__init__()
        self._session = session
        self._spec = METHODS[method]
        self._is_selected = False
        self._make_controls()
        self._lay_out()
        self._connect()
        self.setToolTip(_tip(self._spec))
        self.refresh()

    @property
    def method(self) -> str:
        """Id of the method."""
        return self._spec.id

    def set_selected(self, selected: bool) -> None:
        """Frame the block, or not."""
        self._is_selected = selected
        self.update()

    def refresh(self, *_: Any) -> None:
        """Show the study and what has been computed for it."""
        choice = self._choice()
        with QSignalBlocker(self.check):
            self.check.setChecked(choice.enabled)
        self.title.setEnabled(choice.enabled)
        self._swatch.setEnabled(choice.enabled)
        self.iterations.setVisible(choice.enabled)
        self.iterations.set_value(choice.iterations)
        self.form.set_values(choice.params)
        self.refresh_state()

    def refresh_state(self) -> None:
        """Show how far the method is."""
        choice = self._choice()
        run = self._session.run(self.method) if choice.enabled else None
        self.state.setVisible(choice.enabled)
        self.state.setText(self._progress(choice, run) if run else "")
        warns = run is not None and run.diverged is not None
        role = QPalette.ColorRole.WindowText if warns else QPalette.ColorRole.PlaceholderText
        self.state.setForegroundRole(role)

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        entered = event.type() == QEvent.Type.FocusIn and event.reason() in _BY_HAND
        if entered or event.type() == QEvent.Type.MouseButtonPress:
            self.selected.emit(self.method)
        return False

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.selected.emit(self.method)
        super().mousePressEvent(event)

    def paintEvent(self, _: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        accent = self.palette().color(QPalette.ColorRole.Highlight)
        line = self.palette().color(QPalette.ColorRole.Mid)
        painter.setPen(accent if self._is_selected else line)
        ground = QColor(accent)
        ground.setAlpha(28 if self._is_selected else 0)
        painter.setBrush(ground)
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5)

    def _choice(self) -> MethodChoice:
        return self._session.study.choice(self.method)

    def _progress(self, choice: MethodChoice, run: Run) -> str:
        if run.diverged is not None:
            return f"✕ diverged at iteration {run.diverged}"
        if run.computed < choice.iterations:
            return f"{run.computed} of {choice.iterations} …"
        metric = self._session.study.metrics[self._session.study.metric]
        errors = run.values(metric.id)
        error, noisy_error = errors[choice.iterations], errors[0]
        note = f", {WORSE}" if error > noisy_error * (1 + 1e-9) else ""
        return f"{significant(error, 3)} {metric.unit}{note}"

    def _make_controls(self) -> None:
        spec = self._spec
        self.check = QCheckBox()
        self.check.setAccessibleName(spec.title)
        self._swatch = Swatch(method_colour(spec.id))
        self.title = QLabel(spec.title)
        self.title.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.gear = IconButton("mdi6.cog-outline", f"Parameters of {spec.title}")
        self.gear.setCheckable(True)
        self.help = HelpButton(lambda: spec.id, f"Reference of {spec.title}")
        self.iterations = IterationControl(spec.title)
        self.state = FaintLabel()
        palette = self.state.palette()
        palette.setColor(QPalette.ColorRole.WindowText, QColor(WARNING_COLOUR))
        self.state.setPalette(palette)
        self.form = ParameterForm(spec.params)
        self.details = QWidget()
        self.details.hide()

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(6)
        head.addWidget(self.check)
        head.addWidget(self._swatch)
        head.addWidget(self.title, 1)
        head.addWidget(self.help)
        head.addWidget(self.gear)
        inside = QVBoxLayout(self.details)
        inside.setContentsMargins(0, 4, 0, 2)
        inside.addWidget(FaintLabel(f"{self._spec.summary} {self._spec.departure}".strip()))
        inside.addWidget(self.form)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 4, 6, 6)
        layout.setSpacing(2)
        layout.addLayout(head)
        for widget in (self.iterations, self.state, self.details):
            layout.addWidget(widget)

    def _connect(self) -> None:
        title = self._spec.title
        self.check.toggled.connect(lambda on: self._change(f"Show {title}", enabled=on))
        self.iterations.changed.connect(
            lambda count: self._change(f"Iterations of {title}", iterations=count)
        )
        self.form.changed.connect(
            lambda values: self._change(f"Parameters of {title}", params=values)
        )
        self.gear.toggled.connect(self.details.setVisible)
        editors = [field.editor for field in self.form.fields.values()]
        own = (self.check, self.gear, self.iterations.slider, self.iterations.box, *editors)
        for control in own:
            control.installEventFilter(self)

    def _change(self, step: str, **update: Any) -> None:
        choice = self._choice().model_copy(update=update)
        self._session.apply(self._session.study.with_choice(choice), step)


def _tip(spec: MethodSpec) -> str:
    """Rich text, so that long lines wrap."""
    lines = [f"<b>{escape(spec.title)}</b>", escape(spec.summary), f"<i>{escape(spec.formula)}</i>"]
    lines += [escape(line) for line in (spec.departure, spec.reference) if line]
    return "<br>".join(lines)
