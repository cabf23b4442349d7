"""The recent files, as a menu with small pictures."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSettings
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QMenu, QWidget

from app.ui.action_book import escaped
from app.ui.thumbnails import thumbnail

_KEPT = "recent_files"
_MOST = 10
# Icons that are pictures. Fusion draws an entry's icon in its own size, unless the sheet draws the
# whole entry.
_SHEET = """
QMenu { icon-size: 56px; }
QMenu::item { padding: 4px 20px 4px 8px; }
QMenu::item:selected { background: palette(highlight); color: palette(highlighted-text); }
QMenu::item:disabled { color: palette(placeholder-text); background: transparent; }
"""


class RecentFiles:
    """Models and studies that were opened or saved last, newest first, kept between starts.

    Parameters
    ----------
    open_ : callable
        Opens a file by its path.
    parent : QWidget
        Window of the menu.
    """

    def __init__(self, open_: Callable[[str], None], parent: QWidget) -> None:
        self._open = open_
        self.menu = QMenu("Open &Recent", parent)
        self.menu.setStyleSheet(_SHEET)
        self.menu.setToolTipsVisible(True)
        # Filled when it opens: then the pictures are those that there are.
        self.menu.aboutToShow.connect(self.fill)
        self._enable()

    @property
    def names(self) -> list[str]:
        """Paths of the files."""
        kept = QSettings().value(_KEPT) or []
        return [kept] if isinstance(kept, str) else list(kept)

    def add(self, name: str) -> None:
        """Put a file in the first place."""
        path = str(Path(name).absolute())
        self._keep([path, *(other for other in self.names if other != path)][:_MOST])

    def clear(self) -> None:
        """Forget all files."""
        self._keep([])

    def fill(self) -> None:
        """Make the entries of the menu."""
        self.menu.clear()
        for name in self.names:
            action = self.menu.addAction(escaped(Path(name).name))
            action.setToolTip(name)
            action.setEnabled(Path(name).exists())
            picture = thumbnail(name)
            if picture.exists():
                action.setIcon(QIcon(str(picture)))
            action.triggered.connect(lambda *_, name=name: self._open(name))
        self.menu.addSeparator()
        self.menu.addAction("&Clear the List").triggered.connect(self.clear)

    def _keep(self, names: list[str]) -> None:
        QSettings().setValue(_KEPT, names)
        self._enable()

    def _enable(self) -> None:
        self.menu.menuAction().setEnabled(bool(self.names))
