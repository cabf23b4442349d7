"""Help that is made from the declarations: methods, metrics, errata, versions."""

import platform
from collections.abc import Callable
from importlib import metadata
from importlib.resources import files

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QMessageBox,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
)

from app.export.reference import entry_title, reference_page
from app.ui.controls import IconButton

_PACKAGES = ("burnish", "numpy", "scipy", "numba", "trimesh", "pyvista", "vtk", "pyvistaqt",
             "PySide6-Essentials")  # fmt: skip


class HelpButton(IconButton):
    """A small question mark that opens the reference at an entry.

    Parameters
    ----------
    entry : callable
        Returns the id of a method, metric, field or statistic.
    tip : str
        What the entry is about.
    """

    def __init__(self, entry: Callable[[], str], tip: str) -> None:
        super().__init__("mdi6.help-circle-outline", tip)
        self.clicked.connect(lambda: show_reference(self.window(), entry()))


def show_reference(parent: QWidget, entry: str = "") -> QDialog:
    """Show the reference page, scrolled to an entry if one is named."""
    dialog = _show_page(parent, "Reference", reference_page())
    if entry:
        _scroll_to(dialog.findChild(QTextBrowser), entry_title(entry))
    return dialog


def show_errata(parent: QWidget) -> QDialog:
    """Show where the printed thesis fails."""
    page = files("resources").joinpath("docs/errata.md").read_text(encoding="utf-8")
    return _show_page(parent, "Where the printed thesis fails", page)


def show_about(parent: QWidget) -> QMessageBox:
    """Show the versions, with a button that copies them."""
    box = QMessageBox(parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setWindowTitle("About Burnish")
    box.setText("Burnish compares mesh denoisers and draws the skeleton of a shape.")
    text = versions()
    box.setInformativeText(text)
    copy = box.addButton("Copy versions", QMessageBox.ButtonRole.ActionRole)
    copy.clicked.connect(lambda: QApplication.clipboard().setText(text))
    box.addButton(QMessageBox.StandardButton.Close)
    box.open()
    return box


def versions() -> str:
    """Return the versions of all that matters, one a line, the system last."""
    lines = [f"{package} {_version(package)}" for package in _PACKAGES]
    return "\n".join([*lines, f"Python {platform.python_version()}", platform.platform()])


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "(not installed)"


def _scroll_to(page: QTextBrowser, title: str) -> None:
    """Bring a heading to the top of the page."""
    block = page.document().begin()
    while block.isValid():
        if block.blockFormat().headingLevel() and block.text().startswith(title):
            top = page.document().documentLayout().blockBoundingRect(block).top()
            page.verticalScrollBar().setValue(round(top))
            return
        block = block.next()


def _show_page(parent: QWidget, title: str, markdown: str) -> QDialog:
    dialog = QDialog(parent)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.setWindowTitle(title)
    dialog.resize(720, 620)
    page = QTextBrowser(openExternalLinks=True)
    page.setMarkdown(markdown)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(dialog.reject)
    layout = QVBoxLayout(dialog)
    layout.addWidget(page)
    layout.addWidget(buttons)
    dialog.open()
    return dialog
