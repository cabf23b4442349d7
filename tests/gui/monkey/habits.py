"""What the random user does: each habit acts once and says what it did."""

import hands
from aims import Aims, name_of
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QDockWidget,
    QLineEdit,
)
from pyvistaqt import QtInteractor

from app.ui.actions import COMMANDS, THEMES

_KEYS = (
    "Tab", "Return", "Escape", "Space", "Left", "Right", "Up", "Down", "Home", "End", "PgUp",
    "PgDown", "Delete", "Backspace", "5", "A", "Shift+Tab", "Alt+F", "Alt+E", "F10",
)  # fmt: skip
_TEXTS = ("0", "1", "-3", "0.5", "1e9", "7", "22", "", "nan", "999999999999", "mean")
_BUTTONS = (hands.LEFT,) * 8 + (Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton)
_MODIFIERS = (
    *[hands.NONE] * 6,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
)


class Habits(Aims):
    """Everything that can be done with a window."""

    def __init__(self, random, good, bad, say):
        super().__init__(random, good, bad, say)
        self._weights = {
            self.click: 24, self.double_click: 4, self.drag: 7, self.drag_in_viewport: 5,
            self.turn_wheel: 6, self.type_key: 8, self.shortcut: 12, self.command: 12,
            self.type_text: 6, self.choose: 3, self.slide: 5, self.turn_to_tab: 4,
            self.open_file: 4, self.drop_file: 2, self.close_something: 4, self.cancel: 2,
            self.resize: 3, self.switch_theme: 1, self.undo_or_redo: 5, self.rest: 4,
            self.close_window: 0.2,
        }  # fmt: skip

    def act(self):
        """Do something and return what it was."""
        if hands.file_dialog() and self.random.random() < 0.8:
            return self.answer_file_dialog()
        if isinstance(hands.scope(), QDialog) and self.random.random() < 0.25:
            return self.answer_dialog()
        habits, weights = zip(*self._weights.items(), strict=True)
        return self.random.choices(habits, weights)[0]()

    # -- the mouse

    def click(self):
        widget, point = self._aim()
        button, modifier = self.random.choice(_BUTTONS), self.random.choice(_MODIFIERS)
        QTest.mouseClick(widget, button, modifier, point)
        return f"click {name_of(widget)} at {point.toTuple()} with {button.name}, {modifier.name}"

    def double_click(self):
        widget, point = self._aim()
        QTest.mouseClick(widget, hands.LEFT, hands.NONE, point)
        if hands.isValid(widget):
            QTest.mouseDClick(widget, hands.LEFT, hands.NONE, point)
        return f"double-click {name_of(widget)} at {point.toTuple()}"

    def drag(self, widget=None):
        widget = widget or self._aim()[0]
        start, end = (hands.some_point(self.random, widget) for _ in range(2))
        button, modifier = self.random.choice(_BUTTONS), self.random.choice(_MODIFIERS)
        hands.drag(widget, start, end, button, modifier)
        return f"drag {name_of(widget)} {start.toTuple()} to {end.toTuple()} with {button.name}"

    def drag_in_viewport(self):
        areas = self._shown(QtInteractor)
        return self.drag(self.random.choice(areas)) if areas else self.rest()

    def turn_wheel(self):
        widget, point = self._aim()
        steps = self.random.choice((-5, -1, 1, 5))
        hands.wheel(widget, point, steps, self.random.choice(_MODIFIERS))
        return f"wheel {steps} on {name_of(widget)} at {point.toTuple()}"

    # -- keys

    def type_key(self):
        key = self.random.choice(_KEYS)
        self._press(QKeySequence(key))
        return f"key {key}"

    def shortcut(self):
        key = self.random.choice([command.key for command in COMMANDS if command.key])
        self._press(QKeySequence(key))
        return f"shortcut {key}"

    def type_text(self):
        boxes = self._shown(QAbstractSpinBox) + self._shown(QLineEdit)
        if not boxes:
            return self.type_key()
        box, text = self.random.choice(boxes), self.random.choice(_TEXTS)
        box.setFocus()
        box.selectAll()
        QTest.keyClicks(box, text)
        if hands.isValid(box):
            QTest.keyClick(box, Qt.Key.Key_Return)
        return f"type {text!r} into {name_of(box)}"

    # -- widgets with a value

    def choose(self):
        boxes = [box for box in self._shown(QComboBox) if box.count()]
        if not boxes:
            return self.click()
        box = self.random.choice(boxes)
        place = self.random.randrange(box.count())
        box.setCurrentIndex(place)
        box.activated.emit(place)
        return f"choose {place} of {name_of(box)}"

    def slide(self):
        sliders = self._shown(QAbstractSlider)
        if not sliders:
            return self.turn_wheel()
        slider = self.random.choice(sliders)
        value = self.random.randint(slider.minimum(), slider.maximum())
        if slider.maximum() > 100:  # many iterations take long and show nothing new
            value = slider.minimum() + (value - slider.minimum()) // 20
        slider.setValue(value)
        return f"slide {name_of(slider)} to {value}"

    # -- commands

    def command(self):
        usable = [c.id for c in COMMANDS if self.window.actions_[c.id].isEnabled()]
        return self._trigger(self.random.choice([id_ for id_ in usable if id_ != "quit"]))

    def cancel(self):
        return self._trigger("cancel")

    def switch_theme(self):
        return self._trigger(f"theme_{self.random.choice(list(THEMES))}")

    def undo_or_redo(self):
        return self._trigger(self.random.choice(("undo", "undo", "redo")))

    def turn_to_tab(self):
        place = self.random.randrange(self.window.tabs.count())
        return self._trigger(f"tab_{place + 1}")

    # -- files

    def open_file(self):
        file = self._some_file()
        if hands.scope() is None:
            self.window.open_model(str(file))
        return f"open {file.name}"

    def drop_file(self):
        file = self._some_file()
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(file))])
        event = QDropEvent(
            QPointF(99, 99), Qt.DropAction.CopyAction, data, hands.LEFT, hands.NONE
        )  # fmt: skip
        if hands.scope() is None:
            QApplication.sendEvent(self.window, event)
        return f"drop {file.name}"

    def answer_file_dialog(self):
        dialog = hands.file_dialog()
        if self.random.random() < 0.4:
            QTest.keyClick(dialog, Qt.Key.Key_Escape)
            return f"leave the file dialog {dialog.windowTitle()!r}"
        line = dialog.findChild(QLineEdit, "fileNameEdit")
        if dialog.acceptMode() == dialog.AcceptMode.AcceptOpen:
            line.setText(str(self._some_file()))
        else:
            line.setText(line.text() or "something")
        said = f"answer {dialog.windowTitle()!r} with {line.text()!r}"
        QTest.keyClick(line, Qt.Key.Key_Return)
        return said

    # -- windows

    def answer_dialog(self):
        dialog = hands.scope()
        said = f"answer {name_of(dialog)} {dialog.windowTitle()!r}"
        if self.random.random() < 0.4 or not hands.press_button(self.random, dialog):
            QTest.keyClick(dialog, self.random.choice((Qt.Key.Key_Escape, Qt.Key.Key_Return)))
        return said

    def close_something(self):
        top = hands.scope()
        others = [w for w in hands.windows() if w is not self.window]
        docks = [] if top else self._shown(QDockWidget)
        closable = others * 3 + docks
        if not closable:
            return self.rest()
        widget = self.random.choice(closable)
        said = f"close {name_of(widget)}"
        widget.close()
        return said

    def resize(self):
        size = self.random.randint(200, 1900), self.random.randint(150, 1060)
        window = hands.scope() or self.window
        window.resize(*size)
        return f"resize {name_of(window)} to {size}"

    def close_window(self):
        if hands.scope() is None:
            self.window.close()
        return "close the window"

    def rest(self):
        milliseconds = self.random.choice((10, 50, 100, 300))
        hands.rest(milliseconds)
        return f"rest {milliseconds} ms"
