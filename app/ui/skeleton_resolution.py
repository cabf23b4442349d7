"""Under each view: the slider of its resolution, which redraws while it is dragged."""

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSpinBox, QWidget

from app.session import Session
from app.ui.controls import JumpSlider, WheelGuard
from app.ui.skeleton_changes import change_view, current_view
from core.parameters import describe
from core.study import SkeletonView

_DECLARED = {parameter.name: parameter for parameter in describe(SkeletonView)}


class ResolutionBar(QWidget):
    """Slider, number and automatic choice of one view's R.

    Signals
    -------
    automatic_requested() : the button was pressed.
    """

    automatic_requested = Signal()

    def __init__(self, session: Session, index: int) -> None:
        super().__init__()
        self._session, self._index = session, index
        declared = _DECLARED["resolution"]
        self.slider = JumpSlider()
        self.number = QSpinBox(keyboardTracking=False)
        for control in (self.slider, self.number):
            control.setRange(int(declared.low), int(declared.high))
            control.setToolTip(declared.help)
            control.setAccessibleName(f"Resolution R of the {('left', 'right')[index]} view")
            control.valueChanged.connect(self._on_value)
        self.automatic = QPushButton("Auto")
        self.automatic.setToolTip(
            "The smallest R that shows every loop and branch longer than 5 % of the field's range"
        )
        self.automatic.clicked.connect(self.automatic_requested)
        WheelGuard(self).guard(self.slider, self.number)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(8, 2, 8, 2)
        for widget, stretch in (
            (QLabel("<b>R</b>"), 0),
            (self.slider, 1),
            (self.number, 0),
            (self.automatic, 0),
        ):
            layout.addWidget(widget, stretch)
        session.study_changed.connect(self._refresh)
        self._refresh()

    def _refresh(self, *_: object) -> None:
        value = current_view(self._session, self._index).resolution
        for control in (self.slider, self.number):
            with QSignalBlocker(control):
                control.setValue(value)

    def _on_value(self, value: int) -> None:
        change_view(self._session, self._index, "Resolution", resolution=value)
