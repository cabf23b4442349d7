"""What the window writes to files: meshes, plots, tables and screenshots."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QImage, QPainter

from app.export.pictures import Picture, PictureError, save_picture
from app.ui.desk import PictureSubject
from app.ui.dialogs import ask_where_to_save, tell
from app.ui.screenshot_dialog import Request, ScreenshotDialog
from core.io import SaveError, save_mesh

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_MESH_FILTERS = "PLY (*.ply);;OBJ (*.obj);;OFF (*.off);;STL (*.stl)"
_PLOT_FILTERS = "SVG (*.svg);;PDF (*.pdf);;PNG (*.png)"
_TABLE_FILTERS = "CSV (*.csv);;Markdown (*.md);;LaTeX (*.tex)"


def ask_for_mesh(window: "MainWindow") -> None:
    """Ask where to save the mesh of what is selected."""
    mesh, name = window.desk.mesh()
    _ask(window, "Save the mesh of the selected view", f"{_stem(window)}_{name}.ply",
         _MESH_FILTERS, lambda path: save_mesh(mesh, path))  # fmt: skip


def ask_for_plot(window: "MainWindow") -> None:
    """Ask where to save the error plot."""
    _ask(window, "Save the error plot", f"{_stem(window)}_errors.svg", _PLOT_FILTERS,
         window.denoise.plot.save)  # fmt: skip


def ask_for_table(window: "MainWindow") -> None:
    """Ask where to save the table."""
    _ask(window, "Save the table", f"{_stem(window)}_errors.csv", _TABLE_FILTERS,
         window.denoise.table.save)  # fmt: skip


def ask_for_screenshot(window: "MainWindow") -> None:
    """Ask what to picture, then where to save it."""
    size = (window.width(), window.height())
    subjects = window.desk.subjects() | {"window": PictureSubject("The whole window", size)}
    dialog = ScreenshotDialog(window, subjects)
    dialog.wanted.connect(lambda wanted: _ask_for_picture(window, wanted, subjects))
    dialog.open()


def window_image(window: "MainWindow", scale: int) -> QImage:
    """Picture the whole window at a multiple of its size, the views drawn anew at that size."""
    image = QImage(window.size() * scale, QImage.Format.Format_ARGB32)
    image.setDevicePixelRatio(scale)
    image.fill(Qt.GlobalColor.transparent)
    window.render(image)
    area = window.desk.stage.interactor
    if window.session.meshes is None or not area.isVisible():
        return image
    drawn = window.desk.picture(
        Request("grid", scale, transparent=False), (area.width(), area.height())
    )
    place = QRect(area.mapTo(window, QPoint(0, 0)), area.size())
    painter = QPainter(image)
    painter.drawImage(place, _image(drawn))
    painter.end()
    return image


def _ask_for_picture(
    window: "MainWindow", request: Request, subjects: Mapping[str, PictureSubject]
) -> None:
    def save(path: Path) -> None:
        if request.subject != "window":
            size = subjects[request.subject].size
            save_picture(window.desk.picture(request, size), path)
        elif not window_image(window, request.scale).save(str(path)):
            raise PictureError(f"{path} cannot be written.")

    name = f"{_stem(window)}_{request.subject}.png"
    _ask(window, "Save the picture", name, "PNG (*.png)", save)


def _ask(
    window: "MainWindow", title: str, name: str, filters: str, save: Callable[[Path], None]
) -> None:
    def checked(path: Path) -> None:
        try:
            save(path)
        except (SaveError, PictureError, OSError) as error:
            tell(window, str(error))
        else:
            window.session.notified.emit(f"Saved {path.name}.")

    ask_where_to_save(window, title, name, filters, checked)


def _stem(window: "MainWindow") -> str:
    return Path(window.session.meshes.name).stem


def _image(drawn: Picture) -> QImage:
    rgb = np.ascontiguousarray(drawn)
    height, width, _ = rgb.shape
    return QImage(rgb.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()
