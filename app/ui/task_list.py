"""The list of all that runs, which opens above the status bar."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.session import RunningTasks, Task, TaskState
from app.ui.controls import FaintLabel, IconButton
from app.ui.progress_strip import ProgressStrip

_WIDTH = 400
_ROW = 330


class TaskRow(QWidget):
    """One task: how it stands, and a button that cancels it.

    Parameters
    ----------
    task : Task
        The task.
    tasks : RunningTasks
        Cancels it.
    """

    def __init__(self, task: Task, tasks: RunningTasks) -> None:
        super().__init__()
        self.strip = ProgressStrip(_ROW)
        self.button = IconButton("mdi6.close", f"Cancel {task.title}")
        self.button.clicked.connect(lambda: tasks.cancel(task))
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.strip, 1)
        layout.addWidget(self.button)

    def show_state(self, state: TaskState) -> None:
        """Show how the task stands."""
        self.strip.show_state(state)
        self.button.setEnabled(state.task.can_cancel and not state.stopping)


class TaskList(QFrame):
    """A row for each task, and a button that cancels all.

    Parameters
    ----------
    tasks : RunningTasks
        What runs.
    cancel : QAction
        The command that stops all work.
    parent : QWidget
        Where it opens.
    """

    def __init__(self, tasks: RunningTasks, cancel: QAction, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self._tasks = tasks
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setFixedWidth(_WIDTH)
        self.rows: dict[Task, TaskRow] = {}
        self._nothing = FaintLabel("Nothing is running.")
        self.cancel_all = QPushButton("Cancel all")
        self.cancel_all.setToolTip(cancel.toolTip())
        self.cancel_all.clicked.connect(cancel.trigger)
        self._lay_out()

    def open_at(self, corner: QPoint) -> None:
        """Open with the lower right corner at a point of the screen."""
        self._corner = corner
        self._place()
        self.show()

    def show_states(self, states: Sequence[TaskState]) -> None:
        """Show the tasks that run now."""
        known = [state.task for state in states]
        if known != list(self.rows):
            self._fill(known)
        for state in states:
            self.rows[state.task].show_state(state)
        self.cancel_all.setEnabled(any(row.button.isEnabled() for row in self.rows.values()))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)

    def _lay_out(self) -> None:
        self._column = QVBoxLayout()
        self._column.setSpacing(8)
        head = QHBoxLayout()
        head.addWidget(QLabel("<b>What runs</b>"))
        head.addStretch()
        head.addWidget(self.cancel_all)
        layout = QVBoxLayout(self)
        layout.addLayout(head)
        layout.addLayout(self._column)
        layout.addWidget(self._nothing)

    def _fill(self, known: Sequence[Task]) -> None:
        """Add rows for what has begun, and take away those of what has ended."""
        for task in [task for task in self.rows if task not in known]:
            row = self.rows.pop(task)
            self._column.removeWidget(row)
            row.hide()
            row.deleteLater()
        rows = {task: self.rows.get(task) or TaskRow(task, self._tasks) for task in known}
        for row in rows.values():
            self._column.addWidget(row)
            row.show()  # at once: what is hidden does not count when the list is placed
        self.rows = rows
        self._nothing.setVisible(not rows)
        if self.isVisible():
            self._place()

    def _place(self) -> None:
        """Keep the lower right corner where it is, whatever the number of rows."""
        self.layout().activate()
        self.resize(self.width(), self.sizeHint().height())
        self.move(self._corner - QPoint(self.width(), self.height()))
