"""Mouse and keys for things that may vanish while they are touched."""

import time

from PySide6.QtCore import QEventLoop, QObject, QPoint, QPointF, QRect, Qt, QTimer
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QPushButton, QWidget
from shiboken6 import isValid

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
_PATIENCE = 0.4


def rest(milliseconds):
    """Let the window work for a while; QTest.qWait would leave nothing of Python to its workers."""
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()


def scope():
    """Return the window that gets what a person does now: a menu, a dialog, or one of several."""
    popup, modal = QApplication.activePopupWidget(), QApplication.activeModalWidget()
    return popup or modal


def file_dialog():
    """Return the file dialog that waits for an answer, or None."""
    dialogs = [w for w in QApplication.topLevelWidgets() if isinstance(w, QFileDialog)]
    return next((dialog for dialog in dialogs if dialog.isVisible()), None)


def windows():
    """Return what a person could touch now."""
    top = scope()
    shown = [w for w in QApplication.topLevelWidgets() if w.isVisible() and w.width() > 10]
    return [top] if top else shown


def targets(window):
    """Return the widgets of a window that can be seen and used, by kind."""
    kinds = {}
    for widget in [window, *window.findChildren(QWidget)]:
        if widget.isVisible() and widget.isEnabled() and not widget.visibleRegion().isEmpty():
            kinds.setdefault(type(widget).__name__, []).append(widget)
    return kinds


def some_point(random, widget):
    """Return a point of a widget that can be seen; often its middle."""
    area: QRect = widget.visibleRegion().boundingRect()
    if random.random() < 0.3:
        return area.center()
    return QPoint(
        area.left() + random.randrange(max(area.width(), 1)),
        area.top() + random.randrange(max(area.height(), 1)),
    )


def press_button(random, dialog):
    """Click one of a dialog's buttons, whichever."""
    buttons = [b for b in dialog.findChildren(QPushButton) if b.isVisible() and b.isEnabled()]
    if buttons:
        QTest.mouseClick(random.choice(buttons), LEFT)
    return bool(buttons)


def drag(widget, start, end, button=LEFT, modifier=NONE):
    """Press, move in steps and release."""
    QTest.mousePress(widget, button, modifier, start)
    for step in range(1, 5):
        if isValid(widget):
            place = start + (end - start) * step / 4
            QTest.mouseMove(widget, place)
    if isValid(widget):
        QTest.mouseRelease(widget, button, modifier, end)


def wheel(widget, point, steps, modifier=NONE):
    """Turn the wheel."""
    event = QWheelEvent(
        QPointF(point), QPointF(widget.mapToGlobal(point)), QPoint(), QPoint(0, 120 * steps),
        Qt.MouseButton.NoButton, modifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(widget, event)


class Rescuer(QObject):
    """Answers what Qt waits for inside an action: menus of buttons, questions, dragged text."""

    def __init__(self, random):
        super().__init__()
        self._random = random
        self._busy_since = None
        self._timer = QTimer(self, interval=100)
        self._timer.timeout.connect(self._look)
        self._timer.start()

    def begin(self):
        self._busy_since = time.monotonic()

    def end(self):
        self._busy_since = None

    def _look(self):
        if self._busy_since is None or time.monotonic() - self._busy_since < _PATIENCE:
            return
        waiting = scope()
        if QApplication.activePopupWidget() is None and waiting is not None:
            if self._random.random() < 0.7 and press_button(self._random, waiting):
                return
        elif waiting is not None and self._random.random() < 0.5:
            QTest.mouseClick(waiting, LEFT, NONE, some_point(self._random, waiting))
            return
        # Escape also ends the dragging of a text.
        if window := waiting or QApplication.activeWindow():
            QTest.keyClick(window, Qt.Key.Key_Escape)
