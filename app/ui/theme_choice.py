"""The theme that a person has chosen, kept between starts, or the one of the system."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QSettings
from PySide6.QtGui import QGuiApplication

from app.ui.action_book import ActionBook
from app.ui.actions import THEMES
from app.ui.theme import set_mode

_KEPT = "theme_mode"


class ThemeChoice(QObject):
    """Sets the theme, and follows the system while nothing else is chosen.

    Parameters
    ----------
    parent : QObject
        Owner.
    apply_theme : callable
        Draws everything in the theme that was set.
    """

    def __init__(self, parent: QObject, apply_theme: Callable[[], None]) -> None:
        super().__init__(parent)
        self._apply = apply_theme
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._follow_system)

    @property
    def mode(self) -> str:
        """What was chosen."""
        kept = str(QSettings().value(_KEPT, "system"))
        return kept if kept in THEMES else "system"

    def handlers(self) -> dict[str, Callable[..., None]]:
        """What each command does, by id."""
        return {f"theme_{mode}": lambda mode=mode: self.choose(mode) for mode in THEMES}

    def choose(self, mode: str) -> None:
        """Choose a theme."""
        QSettings().setValue(_KEPT, mode)
        self.refresh()

    def refresh(self) -> None:
        """Take on what is kept."""
        set_mode(self.mode)
        self._apply()

    def show(self, book: ActionBook) -> None:
        """Check what is chosen."""
        book.check(f"theme_{self.mode}", True)

    def _follow_system(self, _: object) -> None:
        if self.mode == "system":
            self.refresh()
