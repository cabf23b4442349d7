"""Light and dark: the system's choice or the user's."""

from typing import Literal

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from app.scene.colours import DARK, LIGHT, Theme
from app.ui.style_sheet import style_sheet

Mode = Literal["system", "light", "dark"]

_SCHEMES = {
    "system": Qt.ColorScheme.Unknown,
    "light": Qt.ColorScheme.Light,
    "dark": Qt.ColorScheme.Dark,
}

_Role = QPalette.ColorRole
# Window, base, alternate base, button, text, dim text, highlight, dividing line.
_ROLES = {
    False: ("#f2f4f6", "#ffffff", "#f5f7f9", "#f7f8fa", "#20262d", "#65707c", "#0b6bcb", "#c9d0d8"),
    True: ("#262b31", "#1e2227", "#2a3037", "#323941", "#e4e8ec", "#8b96a2", "#2f7fd1", "#454e58"),
}


def set_mode(mode: Mode) -> None:
    """Choose light, dark, or what the system says; what stays the same is not set again."""
    QGuiApplication.styleHints().setColorScheme(_SCHEMES[mode])
    # Not every platform follows the request, so the palette is set as well.
    dark = mode == "dark" or (mode == "system" and system_is_dark())
    _, base, *_, dim, highlight, line = _ROLES[dark]
    sheet = style_sheet(dark=dark, ground=base, outline=dim, accent=highlight, line=line)
    _dress(_palette(dark=dark), sheet)


def system_is_dark() -> bool:
    """Whether the desktop asks for dark windows."""
    return QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark


def current_theme() -> Theme:
    """Theme of the panes and plots that goes with the widgets' palette."""
    return DARK if QApplication.palette().color(_Role.Window).lightness() < 128 else LIGHT


def _dress(palette: QPalette, sheet: str) -> None:
    """Give all widgets a palette and a sheet; each of them that is new polishes every widget."""
    application = QApplication.instance()
    if not application.styleSheet():  # a sheet hides the name of the style below it
        QApplication.setStyle("Fusion")
    if QApplication.palette() != palette:
        QApplication.setPalette(palette)
    if application.styleSheet() != sheet:
        application.setStyleSheet(sheet)


def _palette(*, dark: bool) -> QPalette:
    window, base, alternate, button, text, dim, highlight, line = map(QColor, _ROLES[dark])
    palette = QPalette(button, window)
    colours = {
        _Role.Base: base,
        _Role.AlternateBase: alternate,
        _Role.ToolTipBase: base,
        _Role.Highlight: highlight,
        _Role.Accent: highlight,
        _Role.Link: highlight,
        _Role.Mid: line,
        _Role.PlaceholderText: dim,
        _Role.HighlightedText: QColor("#ffffff"),
        **dict.fromkeys((_Role.WindowText, _Role.Text, _Role.ButtonText, _Role.ToolTipText), text),
    }
    for role, colour in colours.items():
        palette.setColor(role, colour)
    for role in (_Role.WindowText, _Role.Text, _Role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, dim)
    return palette
