"""The status bar: what runs, how far it is, how long it takes, and a button that stops it."""

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtWidgets import QLabel, QStatusBar, QToolButton

from app.session import Session
from app.session.running import TaskState, together
from app.ui.controls import IconButton
from app.ui.progress_strip import ProgressStrip
from app.ui.task_list import TaskList

_MESSAGE_MS = 12_000
_UPDATE_MS = 250
_NOTICED = 0.3
_WIDTH = 420


class StatusBar(QStatusBar):
    """Sums up what runs; a click on it opens the list.

    Work that is over at once is not shown, and what is shown changes four times a second.

    Signals
    -------
    busy_changed() : work is shown, or no longer.

    Parameters
    ----------
    session : Session
        What to listen to.
    cancel : QAction
        The command that stops all work.
    """

    busy_changed = Signal()

    def __init__(self, session: Session, cancel: QAction) -> None:
        super().__init__()
        self._tasks = session.tasks
        self._place = QLabel()
        self.addWidget(self._place, 1)
        self.summary = _Summary(_WIDTH)
        self.opener = IconButton("mdi6.chevron-up", "List all that runs")
        self._button = QToolButton(autoRaise=True)
        self._button.setDefaultAction(cancel)
        for widget in (self.summary, self.opener, self._button):
            self.addPermanentWidget(widget)
            widget.hide()
        self.list = TaskList(session.tasks, cancel, self)
        self._timer = QTimer(self, interval=_UPDATE_MS)
        self._timer.timeout.connect(self._update)
        for source in (self.summary, self.opener):
            source.clicked.connect(self.open_list)
        session.tasks.changed.connect(self._follow)
        session.notified.connect(lambda text: self.showMessage(text, _MESSAGE_MS))

    @property
    def is_busy(self) -> bool:
        """Whether work is shown."""
        return not self.summary.isHidden()

    def show_place(self, text: str) -> None:
        """Tell what is under the cursor."""
        self._place.setText(text)

    def open_list(self) -> None:
        """Open the list of all that runs above the right end of the bar."""
        self.list.show_states(self._tasks.states(older_than=_NOTICED))
        self._timer.start()
        self.list.open_at(self.mapToGlobal(QPoint(self.width() - 4, -2)))

    def _follow(self) -> None:
        if self.list.isVisible():
            self._update()
        elif not self._timer.isActive():
            self._timer.start()

    def _update(self) -> None:
        # While something is shown, what follows is shown at once instead of an empty bar.
        states = self._tasks.states(older_than=0 if self.is_busy else _NOTICED)
        if states:
            self.summary.show_state(together(states))
        self._show_busy(bool(states))
        if self.list.isVisible():
            self.list.show_states(self._tasks.states(older_than=_NOTICED))
        elif not self._tasks.states():
            self._timer.stop()

    def _show_busy(self, busy: bool) -> None:
        if busy == self.is_busy:
            return
        for widget in (self.summary, self.opener, self._button):
            widget.setVisible(busy)
        self.busy_changed.emit()


class _Summary(ProgressStrip):
    """What runs, in one line; it can be clicked."""

    clicked = Signal()

    def __init__(self, width: int) -> None:
        super().__init__(width)
        # With a surface of its own, painting it (0.3 ms) does not have Qt put the whole window
        # together again with the viewports' pictures (25 ms).
        self.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
        self.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.rect().contains(event.position().toPoint()):
            self.clicked.emit()

    def show_state(self, state: TaskState) -> None:
        super().show_state(state)
        self.setToolTip(f"{state.title}: click for the list of all that runs.")
