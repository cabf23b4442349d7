"""Light and dark: the system's choice or the user's."""

from typing import Literal

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from app.scene.colours import DARK, LIGHT, Theme

Mode = Literal["system", "light", "dark"]

_SCHEMES = {
    "system": Qt.ColorScheme.Unknown,
    "light": Qt.ColorScheme.Light,
    "dark": Qt.ColorScheme.Dark,
}

_SHEET = """
QToolTip { padding: 4px; }
QDockWidget { titlebar-close-icon: none; font-weight: 600; }
QDockWidget::title { padding: 5px 8px; }
QToolBar { spacing: 2px; padding: 3px 6px; border: none; }
QToolButton { padding: 3px 6px; }
QStatusBar::item { border: none; }
"""


def set_mode(mode: Mode) -> None:
    """Choose light, dark, or what the system says."""
    QApplication.setStyle("Fusion")
    QGuiApplication.styleHints().setColorScheme(_SCHEMES[mode])
    QApplication.instance().setStyleSheet(_SHEET)


def current_theme() -> Theme:
    """Theme of the panes and plots that goes with the widgets' palette."""
    ground = QApplication.palette().color(QPalette.ColorRole.Window)
    return DARK if ground.lightness() < 128 else LIGHT
