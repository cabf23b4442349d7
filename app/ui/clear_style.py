"""Qt's Fusion style with outlines and icons that can be seen on light and dark ground."""

import qtawesome
from PySide6.QtCore import QRectF
from PySide6.QtGui import QGuiApplication, QIcon, QPainter, QPalette, QPen
from PySide6.QtWidgets import QProxyStyle, QStyle, QStyleHintReturn, QStyleOption, QWidget

_Element = QStyle.PrimitiveElement
_SQUARES = (_Element.PE_IndicatorCheckBox, _Element.PE_IndicatorItemViewItemCheck)
_ROUNDING = 2.0
_ICONS = {
    QStyle.StandardPixmap.SP_TitleBarNormalButton: "mdi6.dock-window",
    QStyle.StandardPixmap.SP_TitleBarCloseButton: "mdi6.close",
}


class ClearStyle(QProxyStyle):
    """Fusion outlines what can be checked with a shade of the ground, fainter than 3 : 1.

    That is what WCAG 2.1, criterion 1.4.11, asks of the parts of a control. Here the outline has
    the colour of pale text.
    """

    def __init__(self) -> None:
        super().__init__("Fusion")

    def styleHint(
        self,
        hint: QStyle.StyleHint,
        option: QStyleOption | None = None,
        widget: QWidget | None = None,
        data: QStyleHintReturn | None = None,
    ) -> int:
        # Qt's own icons on buttons of dialogs are dark, also on dark ground.
        if hint == QStyle.StyleHint.SH_DialogButtonBox_ButtonsHaveIcons:
            return 0
        return super().styleHint(hint, option, widget, data)

    def standardIcon(
        self,
        icon: QStyle.StandardPixmap,
        option: QStyleOption | None = None,
        widget: QWidget | None = None,
    ) -> QIcon:
        # Qt's own on the titles of panels are dark, also on dark ground.
        if icon in _ICONS:
            ink = QGuiApplication.palette().color(QPalette.ColorRole.WindowText)
            return qtawesome.icon(_ICONS[icon], color=ink.name())
        return super().standardIcon(icon, option, widget)

    def drawPrimitive(
        self,
        element: QStyle.PrimitiveElement,
        option: QStyleOption,
        painter: QPainter,
        widget: QWidget | None = None,
    ) -> None:
        super().drawPrimitive(element, option, painter, widget)
        is_round = element == _Element.PE_IndicatorRadioButton
        if not (is_round or element in _SQUARES):
            return
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(option.palette.color(QPalette.ColorRole.PlaceholderText), 1))
        box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5)
        if is_round:
            painter.drawEllipse(box)
        else:
            painter.drawRoundedRect(box, _ROUNDING, _ROUNDING)
        painter.restore()
