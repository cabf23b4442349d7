"""What the random user touches: widgets, points, commands and files, chosen by chance."""

import hands
from PySide6.QtGui import QCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication


class Aims:
    """Chooses and touches what is there now.

    Parameters
    ----------
    random : random.Random
        Decides.
    good, bad : list of Path
        Files that open, and files that do not.
    say : callable
        Hears of the widget that is about to be touched: it may be the last thing that happens.
    """

    def __init__(self, random, good, bad, say):
        self.random, self._good, self._bad = random, good, bad
        self.window, self._say = None, say

    def _aim(self):
        """Choose a widget, rare kinds as often as common ones, and a point of it."""
        window = self.random.choice(hands.windows())
        if window is hands.file_dialog():  # it could lead anywhere on the disk
            window = self.window
        kinds = hands.targets(window)
        if not kinds:
            return self.window, self.window.rect().center()
        widget = self.random.choice(kinds[self.random.choice(sorted(kinds))])
        point = hands.some_point(self.random, widget)
        self._say(f"aim at {name_of(widget)} in {name_of(window)}, {point.toTuple()}")
        QCursor.setPos(widget.mapToGlobal(point))
        return widget, point

    def _shown(self, kind):
        window = self.random.choice(hands.windows())
        if window is hands.file_dialog():
            return []
        known = window.findChildren(kind)
        return [w for w in known if w.isEnabled() and not w.visibleRegion().isEmpty()]

    def _press(self, sequence):
        """Press a key where the focus is."""
        keys = sequence[0]
        widget = hands.scope() or QApplication.focusWidget() or self.window
        if hands.file_dialog() is None:
            QTest.keyClick(widget, keys.key(), keys.keyboardModifiers())

    def _trigger(self, command):
        action = self.window.actions_[command]
        self._say(f"about to {command}")
        if hands.scope() is None and action.isEnabled():
            action.trigger()
        return f"command {command}"

    def _some_file(self):
        files = self._good if self.random.random() < 0.75 else self._bad
        return self.random.choice(files)


def name_of(widget):
    """Say which widget it is, for the log."""
    if not hands.isValid(widget):
        return "something that is gone"
    name = widget.accessibleName() or widget.objectName() or widget.windowTitle()
    return f"{type(widget).__name__} {name!r}"
