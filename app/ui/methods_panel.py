"""The methods panel: a block for every method and one slider for all of them."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from app.session import Session
from app.ui.controls import Coalesced
from app.ui.method_block import IterationControl, MethodBlock
from core.smoothing import METHODS
from core.study import MethodChoice

_REFRESH_MS = 60


class MethodsPanel(QWidget):
    """Which methods run, how far, and with which parameters.

    Parameters
    ----------
    session : Session
        The state; the panel listens and pushes studies.
    """

    selected = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.blocks = {method: MethodBlock(session, method) for method in METHODS}
        self.master = IterationControl("All methods")
        self._lay_out()
        for block in self.blocks.values():
            block.selected.connect(self.selected)
        self.master.changed.connect(self._move_all)
        self._states = Coalesced(self._refresh_states, _REFRESH_MS, self)
        session.study_changed.connect(self._refresh)
        session.run_changed.connect(self._states.request)
        session.meshes_changed.connect(self._states.request)
        self._refresh()

    def set_selected(self, method: str | None) -> None:
        """Mark a method's block and bring it into view."""
        for id_, block in self.blocks.items():
            block.set_selected(id_ == method)
        if method in self.blocks:
            self._area.ensureWidgetVisible(self.blocks[method], 0, 8)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh()

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setContentsMargins(16, 6, 14, 0)
        head.addWidget(QLabel("All methods"))
        head.addWidget(self.master, 1)
        self.master.setToolTip("Moves the iterations of all checked methods together.")
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(6, 2, 6, 6)
        column.setSpacing(6)
        for block in self.blocks.values():
            column.addWidget(block)
        column.addStretch()
        self._area = QScrollArea(frameShape=QFrame.Shape.NoFrame, widgetResizable=True)
        self._area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._area.setWidget(inside)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(head)
        layout.addWidget(self._area, 1)
        self.setMinimumWidth(260)

    def _enabled(self) -> list[MethodChoice]:
        return [choice for choice in self._session.study.methods if choice.enabled]

    def _move_all(self, iterations: int) -> None:
        study = self._session.study
        for choice in self._enabled():
            study = study.with_choice(choice.model_copy(update={"iterations": iterations}))
        self._session.apply(study, "Iterations of all methods")

    def _refresh(self, *_: object) -> None:
        for block in self.blocks.values():
            block.refresh()
        enabled = self._enabled()
        self.master.setEnabled(bool(enabled))
        self.master.set_value(max((choice.iterations for choice in enabled), default=0))

    def _refresh_states(self) -> None:
        for block in self.blocks.values():
            block.refresh_state()
