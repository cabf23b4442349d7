"""Small dialogs that never stop the window: files to open and save, and bad news."""

import re
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QDialogButtonBox,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QToolButton,
    QWidget,
)

from app.ui.icons import font_icon
from core.io import SUPPORTED_READ

_FOLDER = "last_folder"
_ICONS = {
    "backButton": "arrow-left", "forwardButton": "arrow-right", "toParentButton": "arrow-up",
    "newFolderButton": "folder-plus-outline", "listModeButton": "view-grid-outline",
    "detailModeButton": "format-list-bulleted",
}  # fmt: skip
"""Icons of Qt's own file dialog, by the names that it gives to its buttons."""
_Button = QMessageBox.StandardButton


def model_filter() -> str:
    """Name filter of the files that can be opened."""
    patterns = " ".join(f"*{suffix}" for suffix in SUPPORTED_READ)
    return f"Models ({patterns});;All files (*)"


def ask_for_file(
    parent: QWidget, title: str, use: Callable[[Path], None], filters: str = ""
) -> QFileDialog:
    """Ask for a file to open, a model unless `filters` say otherwise, and hand it on."""
    dialog = QFileDialog(parent, title, _last_folder(), filters or model_filter())
    dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
    return _open(dialog, use)


def ask_where_to_save(
    parent: QWidget, title: str, name: str, filters: str, use: Callable[[Path], None]
) -> QFileDialog:
    """Ask for a file to write and hand it on.

    A suffix that none of the filters has gets that of the chosen filter behind it: `cow_0.02`
    becomes `cow_0.02.ply`.
    """
    dialog = QFileDialog(parent, title, _last_folder(), filters)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.selectFile(name)
    dialog.setDefaultSuffix(Path(name).suffix.removeprefix("."))
    dialog.filterSelected.connect(
        lambda chosen: dialog.setDefaultSuffix(_suffixes(chosen)[0].removeprefix("."))
    )
    return _open(dialog, lambda path: _complete(dialog, path, use))


class FolderDialog(QFileDialog):
    """Asks for a folder; one with a new name is made."""

    def __init__(self, parent: QWidget, title: str, name: str) -> None:
        super().__init__(parent, title, _last_folder())
        self.setFileMode(QFileDialog.FileMode.Directory)
        self.setOption(QFileDialog.Option.ShowDirsOnly)
        line, buttons = self.findChild(QLineEdit), self.findChild(QDialogButtonBox)
        if line and buttons:  # the system's own dialog has none, and a button for new folders
            # Qt takes the button away while a name is typed that is not there.
            choose = buttons.button(QDialogButtonBox.StandardButton.Open)
            line.textChanged.connect(lambda _: choose.setEnabled(True))
            self.selectFile(name)

    def accept(self) -> None:
        with suppress(OSError):  # Qt says that there is no such folder
            Path(self.selectedFiles()[0]).mkdir(parents=True, exist_ok=True)
        super().accept()


def ask_for_folder(
    parent: QWidget, title: str, name: str, use: Callable[[Path], None]
) -> QFileDialog:
    """Ask for a folder to write into, which may be a new one, and hand it on."""
    return _open(FolderDialog(parent, title, name), use)


def tell(parent: QWidget, message: str) -> QMessageBox:
    """Show one sentence about something that could not be done."""
    box = QMessageBox(QMessageBox.Icon.Warning, "Burnish", message, parent=parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    box.open()
    return box


def question(parent: QWidget, text: str, more: str) -> QMessageBox:
    """Make a question that does not stop the window; it still needs its buttons."""
    box = QMessageBox(QMessageBox.Icon.Question, "Burnish", text, parent=parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setInformativeText(more)
    return box


def ask_whether(
    parent: QWidget, text: str, more: str, verb: str, go: Callable[[], object]
) -> QMessageBox:
    """Ask before something is lost; go on where the button `verb` says so."""
    box = question(parent, text, more)
    box.addButton(verb, QMessageBox.ButtonRole.AcceptRole).clicked.connect(lambda *_: go())
    box.setDefaultButton(box.addButton(_Button.Cancel))
    box.open()
    return box


def remember_folder(name: str) -> None:
    """Let the next dialog begin in the folder of a file."""
    QSettings().setValue(_FOLDER, str(Path(name).absolute().parent))


def _suffixes(filters: str) -> list[str]:
    """Return the suffixes that name filters have, in their order."""
    return re.findall(r"\*(\.\w+)", filters)


def _complete(dialog: QFileDialog, path: Path, use: Callable[[Path], None]) -> None:
    """Hand on a file with a suffix of the filters; the dialog has not asked about that name."""
    if path.suffix.lower() in _suffixes(";;".join(dialog.nameFilters())):
        use(path)
        return
    whole = path.with_name(path.name + _suffixes(dialog.selectedNameFilter())[0])
    if whole.exists():
        ask_whether(
            dialog.parentWidget(), f"{whole.name} already exists.", "Replace it?", "Replace",
            lambda: use(whole),
        )  # fmt: skip
    else:
        use(whole)


def _open(dialog: QFileDialog, use: Callable[[Path], None]) -> QFileDialog:
    def chosen(name: str) -> None:
        remember_folder(name)
        use(Path(name))

    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(chosen)
    _colour_icons(dialog)
    dialog.open()
    return dialog


def _colour_icons(dialog: QFileDialog) -> None:
    """Give the buttons of Qt's dialog icons that can be seen on dark, too."""
    ink = dialog.palette().color(QPalette.ColorRole.WindowText)
    faint = dialog.palette().color(QPalette.ColorRole.PlaceholderText)
    for button in dialog.findChildren(QToolButton):
        if icon := _ICONS.get(button.objectName()):
            button.setIcon(font_icon(f"mdi6.{icon}", color=ink, color_disabled=faint))


def _last_folder() -> str:
    return str(QSettings().value(_FOLDER, str(Path.home())))
