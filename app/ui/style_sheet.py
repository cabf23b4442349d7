"""What Qt's Fusion style leaves too faint to see, and a little more room.

A style sheet and not a style of our own: Qt would call that one in Python for every line it draws.
"""

from importlib.resources import files
from pathlib import Path
from string import Template

_SHEET = Template("""
QToolTip { padding: 4px; }
QDockWidget {
    font-weight: 600;
    titlebar-close-icon: url("$icons/close_$theme.svg");
    titlebar-normal-icon: url("$icons/float_$theme.svg");
}
QDockWidget::title { padding: 5px 8px; }
QToolBar { spacing: 2px; padding: 3px 6px; border: none; }
QToolButton { padding: 3px 6px; }
QStatusBar::item { border: none; }
QMenu::separator { height: 1px; margin: 4px 6px; background: $line; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QCheckBox, QRadioButton { padding: 2px 0; }
QCheckBox::indicator, QRadioButton::indicator, QAbstractItemView::indicator {
    width: 12px; height: 12px;
    border: 1px solid $outline; border-radius: 2px; background: $ground;
}
QRadioButton::indicator { border-radius: 7px; }
QCheckBox::indicator:checked, QRadioButton::indicator:checked,
QAbstractItemView::indicator:checked { border-color: $accent; background: $accent; }
QCheckBox::indicator:checked, QAbstractItemView::indicator:checked {
    image: url("$icons/tick.svg");
}
QRadioButton::indicator:checked { image: url("$icons/dot.svg"); }
QCheckBox::indicator:checked:disabled, QRadioButton::indicator:checked:disabled,
QAbstractItemView::indicator:checked:disabled { border-color: $outline; background: $outline; }
QCheckBox::indicator:hover, QRadioButton::indicator:hover { border-color: $accent; }
QCheckBox:focus { outline: 1px dotted $accent; }
""")


def style_sheet(*, dark: bool, ground: str, outline: str, accent: str, line: str) -> str:
    """Return the sheet for a theme.

    Parameters
    ----------
    dark : bool
        Whether icons are to be light.
    ground, outline, accent : str
        Colours of what can be checked: its ground, its outline, and when it is checked.
    line : str
        Colour of the lines that divide a menu.
    """
    icons = Path(str(files("resources") / "icons")).as_posix()
    theme = "dark" if dark else "light"
    return _SHEET.substitute(
        icons=icons, theme=theme, ground=ground, outline=outline, accent=accent, line=line
    )
