"""What the window writes to files: meshes, plots, tables and screenshots."""

from collections.abc import Iterable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QBuffer, QPoint, QRect, Qt
from PySide6.QtGui import QImage, QPainter

from app.export.pictures import Picture, PictureError, composed, save_picture
from app.ui.actions import COMPARED
from app.ui.desk import PictureSubject
from app.ui.exporting import Drawer, Export, ask_to_export, at_once, in_one_step
from app.ui.screenshot_dialog import Request, ScreenshotDialog
from core.io import save_mesh
from core.whole_files import write_atomically

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_MESH_FILTERS = "PLY (*.ply);;OBJ (*.obj);;OFF (*.off);;STL (*.stl)"
_PLOT_FILTERS = "SVG (*.svg);;PDF (*.pdf);;PNG (*.png)"
_TABLE_FILTERS = "CSV (*.csv);;Markdown (*.md);;LaTeX (*.tex);;Text (*.txt)"


def ask_for_mesh(window: "MainWindow") -> None:
    """Ask where to save the mesh of what is selected."""
    mesh, name = window.desk.mesh()
    title = f"Save the mesh: {COMPARED.get(name, name.capitalize())}"
    _ask(window, title, f"{_stem(window)}_{name}.ply", _MESH_FILTERS,
         at_once(partial(save_mesh, mesh)))  # fmt: skip


def ask_for_plot(window: "MainWindow") -> None:
    """Ask where to save the error plot."""
    _ask(window, "Save the error plot", f"{_stem(window)}_errors.svg", _PLOT_FILTERS,
         at_once(window.denoise.plot.writer()))  # fmt: skip


def ask_for_table(window: "MainWindow") -> None:
    """Ask where to save the table."""
    _ask(window, "Save the table", f"{_stem(window)}_errors.csv", _TABLE_FILTERS,
         at_once(window.denoise.table.writer()))  # fmt: skip


def ask_for_screenshot(window: "MainWindow") -> None:
    """Ask what to picture, then where to save it."""
    size = (window.width(), window.height())
    subjects = window.desk.subjects() | {"window": PictureSubject("The whole window", size)}
    dialog = ScreenshotDialog(window, subjects)
    dialog.wanted.connect(lambda wanted: _ask_for_picture(window, wanted, subjects))
    dialog.open()


class WindowPicture:
    """Picture of the whole window as it is now, at a multiple of its size.

    Parameters
    ----------
    window : MainWindow
        The window.
    scale : int
        The multiple.

    Attributes
    ----------
    pieces : iterator
        What its views show now, to be drawn anew at that size.
    """

    def __init__(self, window: "MainWindow", scale: int) -> None:
        self._image = QImage(window.size() * scale, QImage.Format.Format_ARGB32)
        self._image.setDevicePixelRatio(scale)
        self._image.fill(Qt.GlobalColor.transparent)
        window.render(self._image)
        area = window.desk.stage.interactor
        self._place = QRect(area.mapTo(window, QPoint(0, 0)), area.size())
        self.pieces: Iterator[Picture | None] = (nothing for nothing in ())
        if window.session.meshes is not None and area.isVisible():
            views = Request("grid", scale, transparent=False)
            self.pieces = window.desk.picture(views, (area.width(), area.height()))

    def image(self, pieces: Iterable[Picture | None]) -> QImage:
        """Put the views that were drawn into their place; on any thread."""
        for views in pieces:
            if views is not None:
                painter = QPainter(self._image)
                painter.drawImage(self._place, _image(views))
                painter.end()
        return self._image


def _ask_for_picture(
    window: "MainWindow", request: Request, subjects: Mapping[str, PictureSubject]
) -> None:
    def begin(path: Path, drawer: Drawer) -> Iterator[float]:
        if request.subject == "window":
            picture = WindowPicture(window, request.scale)
            return in_one_step(lambda: _save_image(picture.image(drawer(picture.pieces)), path))
        pieces = window.desk.picture(request, subjects[request.subject].size)
        return in_one_step(lambda: save_picture(composed(drawer(pieces)), path))

    name = f"{_stem(window)}_{request.subject}.png"
    _ask(window, "Save the picture", name, "PNG (*.png)", begin)


def _ask(window: "MainWindow", title: str, name: str, filters: str, begin: Export) -> None:
    ask_to_export(window, window.session, title, name, filters, begin)


def _stem(window: "MainWindow") -> str:
    return Path(window.session.meshes.name).stem


def _image(drawn: Picture) -> QImage:
    rgb = np.ascontiguousarray(drawn)
    height, width, _ = rgb.shape
    return QImage(rgb.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()


def _save_image(image: QImage, path: Path) -> None:
    buffer = QBuffer()
    if not image.save(buffer, path.suffix[1:].upper()):
        raise PictureError(f"{path} cannot be written.")
    write_atomically(path, buffer.data().data())
