"""Small controls that several panels share."""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QMouseEvent, QPalette
from PySide6.QtWidgets import QLabel, QSlider, QStyle, QStyleOptionSlider, QToolButton, QWidget

from app.ui.icons import font_icon


class Coalesced(QTimer):
    """Calls a function once for many requests, at most every `interval` milliseconds."""

    def __init__(self, call: Callable[[], None], interval: int, parent: QObject) -> None:
        super().__init__(parent, singleShot=True, interval=interval)
        self.timeout.connect(call)

    def request(self, *_: Any) -> None:
        """Ask for a call; takes whatever a signal sends."""
        if not self.isActive():
            self.start()


class WheelGuard(QObject):
    """Lets the wheel scroll a panel unless the control under the pointer has the focus."""

    def guard(self, *controls: QWidget) -> None:
        """Guard controls, which a click still gives the focus."""
        for control in controls:
            control.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            control.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() != QEvent.Type.Wheel or watched.hasFocus():
            return False
        event.ignore()
        return True


class JumpSlider(QSlider):
    """Horizontal slider whose handle jumps to where the groove is pressed."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and not self._on_handle(event):
            self.setValue(self._value_at(event.position().x()))
        super().mousePressEvent(event)

    def _part(self, part: QStyle.SubControl) -> Any:
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        kind = QStyle.ComplexControl.CC_Slider
        return self.style().subControlRect(kind, option, part, self)

    def _on_handle(self, event: QMouseEvent) -> bool:
        return self._part(QStyle.SubControl.SC_SliderHandle).contains(event.position().toPoint())

    def _value_at(self, x: float) -> int:
        groove = self._part(QStyle.SubControl.SC_SliderGroove)
        handle = self._part(QStyle.SubControl.SC_SliderHandle).width()
        place, room = round(x) - groove.x() - handle // 2, groove.width() - handle
        return QStyle.sliderValueFromPosition(self.minimum(), self.maximum(), place, room)


class IconButton(QToolButton):
    """Flat button whose icon has the colour of the text, in light and dark."""

    def __init__(self, icon: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent, autoRaise=True)
        self._icon = icon
        self.setToolTip(tip)
        self.setAccessibleName(tip)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._colour_icon()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._colour_icon()

    def _colour_icon(self) -> None:
        ink = self.palette().color(QPalette.ColorRole.WindowText)
        self.setIcon(font_icon(self._icon, color=ink))


class FaintLabel(QLabel):
    """Small, pale text that wraps."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent, wordWrap=True)
        self.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        font = self.font()
        font.setPointSizeF(0.9 * font.pointSizeF())
        self.setFont(font)
