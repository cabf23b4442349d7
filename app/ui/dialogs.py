"""Small dialogs that never stop the window: files to open and save, and bad news."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from core.io import SUPPORTED_READ

_FOLDER = "last_folder"


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
    """Ask for a file to write and hand it on; a missing suffix is that of the chosen filter."""
    dialog = QFileDialog(parent, title, _last_folder(), filters)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.selectFile(name)
    dialog.setDefaultSuffix(Path(name).suffix.removeprefix("."))
    dialog.filterSelected.connect(
        lambda chosen: dialog.setDefaultSuffix(chosen.split("*.")[-1].strip(") "))
    )
    return _open(dialog, use)


def ask_for_folder(parent: QWidget, title: str, use: Callable[[Path], None]) -> QFileDialog:
    """Ask for a folder to write into and hand it on."""
    dialog = QFileDialog(parent, title, _last_folder())
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly)
    return _open(dialog, use)


def tell(parent: QWidget, message: str) -> QMessageBox:
    """Show one sentence about something that could not be done."""
    box = QMessageBox(QMessageBox.Icon.Warning, "Burnish", message, parent=parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.open()
    return box


def question(parent: QWidget, text: str, more: str) -> QMessageBox:
    """Make a question that does not stop the window; it still needs its buttons."""
    box = QMessageBox(QMessageBox.Icon.Question, "Burnish", text, parent=parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setInformativeText(more)
    return box


def _open(dialog: QFileDialog, use: Callable[[Path], None]) -> QFileDialog:
    def chosen(name: str) -> None:
        QSettings().setValue(_FOLDER, str(Path(name).parent))
        use(Path(name))

    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(chosen)
    dialog.open()
    return dialog


def _last_folder() -> str:
    return str(QSettings().value(_FOLDER, str(Path.home())))
