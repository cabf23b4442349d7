"""Under each view: the slider of its resolution, which redraws while it is dragged."""

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSpinBox, QVBoxLayout, QWidget

from app.session import Session
from app.ui.controls import FaintLabel, JumpSlider, WheelGuard
from app.ui.skeleton_changes import change_view, current_view
from core.parameters import describe
from core.study import SkeletonView

_DECLARED = {parameter.name: parameter for parameter in describe(SkeletonView)}


class ResolutionBar(QWidget):
    """Slider, number and automatic choice of one view's R; says so when its graph was cancelled.

    Signals
    -------
    automatic_requested() : the button "Auto" was pressed.
    resume_requested() : the button "Compute" was pressed.
    """

    automatic_requested = Signal()
    resume_requested = Signal()

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
        self.notice = FaintLabel("Cancelled: this is not the graph of these settings.")
        self.resume = QPushButton("Compute")
        self.resume.setToolTip("Draw the graph after all; another R does so too")
        self.resume.clicked.connect(self.resume_requested)
        self._lay_out()
        session.study_changed.connect(self._refresh)
        self._refresh()
        self.show_cancelled(False)

    def show_cancelled(self, on: bool) -> None:
        """Say that the graph of these settings was cancelled, with a button to draw it."""
        self._row_of_notice.setVisible(on)

    def _lay_out(self) -> None:
        self._row_of_notice = _row((self.notice, 1), (self.resume, 0))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 2, 8, 2)
        layout.setSpacing(2)
        layout.addWidget(self._row_of_notice)
        layout.addWidget(
            _row((QLabel("<b>R</b>"), 0), (self.slider, 1), (self.number, 0), (self.automatic, 0))
        )

    def _refresh(self, *_: object) -> None:
        value = current_view(self._session, self._index).resolution
        for control in (self.slider, self.number):
            with QSignalBlocker(control):
                control.setValue(value)

    def _on_value(self, value: int) -> None:
        change_view(self._session, self._index, "Resolution", resolution=value)


def _row(*widgets: tuple[QWidget, int]) -> QWidget:
    row = QWidget()
    layout = QHBoxLayout(row)
    layout.setContentsMargins(0, 0, 0, 0)
    for widget, stretch in widgets:
        layout.addWidget(widget, stretch)
    return row
