"""The preferences: pages of settings that are kept between starts."""

from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QPushButton,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.ui.preferences_general import GeneralPage
from app.ui.shortcut_sheet import ShortcutPage


class PreferencesDialog(QDialog):
    """Shows pages, each with its `title`.

    Parameters
    ----------
    parent : QWidget
        The window.
    pages : list of QWidget
        The pages in their order.
    shown : str
        Title of the page to begin with; the first if there is none of that title.
    """

    def __init__(self, parent: QWidget, pages: list[QWidget], shown: str = "") -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Preferences")
        self.resize(600, 640)
        self.tabs = QTabWidget(documentMode=True)
        for page in pages:
            self.tabs.addTab(page, page.title)
            if page.title == shown:
                self.tabs.setCurrentWidget(page)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(self.tabs, 1)
        layout.addWidget(buttons)
        for button in self.findChildren(QPushButton):
            # Enter in a box belongs to the box, not to a button that resets things.
            button.setAutoDefault(False)


def open_preferences(window: Any, page: str = "") -> PreferencesDialog:
    """Open the preferences of a window at a page."""
    pages = [GeneralPage(window), ShortcutPage(window.view_commands.shortcuts)]
    dialog = PreferencesDialog(window, pages, page)
    dialog.open()
    return dialog
