"""What the window writes to files: meshes, plots, tables and screenshots."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QImage, QPainter

from app.export.pictures import Picture, PictureError, grid_picture, save_picture, scaled
from app.ui.dialogs import ask_where_to_save, tell
from app.ui.screenshot_dialog import Request, ScreenshotDialog
from core.io import SaveError, save_mesh
from core.mesh import TriangleMesh

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_MESH_FILTERS = "PLY (*.ply);;OBJ (*.obj);;OFF (*.off);;STL (*.stl)"
_PLOT_FILTERS = "SVG (*.svg);;PDF (*.pdf);;PNG (*.png)"
_TABLE_FILTERS = "CSV (*.csv);;Markdown (*.md);;LaTeX (*.tex)"


def ask_for_mesh(window: "MainWindow") -> None:
    """Ask where to save the mesh of the selected pane."""
    pane = window.denoise.selected or "noisy"
    _ask(window, "Save the mesh of the selected pane", f"{_stem(window)}_{pane}.ply", _MESH_FILTERS,
         lambda path: save_mesh(shown_mesh(window, pane), path))  # fmt: skip


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
    pane = _pictured_pane(window)
    viewport = window.denoise.viewport
    grid = viewport.pixel_size()
    _, _, width, height = viewport.grid.viewports.get(
        pane, next(iter(viewport.grid.viewports.values()))
    ).pixels(*grid)
    sizes = {
        "grid": grid,
        "pane": (round(width), round(height)),
        "window": (window.width(), window.height()),
    }
    title = next(p.title for p in window.denoise.panes()[0] if p.id == pane)
    dialog = ScreenshotDialog(window, title, sizes)
    dialog.wanted.connect(lambda request: _ask_for_picture(window, request, sizes))
    dialog.open()


def shown_mesh(window: "MainWindow", pane: str) -> TriangleMesh:
    """Return the mesh of a pane at the iteration it shows."""
    session = window.session
    comparison = session.meshes.comparison
    if pane in {"original", "noisy"}:
        return getattr(comparison, pane)
    return comparison.noisy.with_vertices(session.run(pane).vertices(session.shown_iteration(pane)))


def picture(window: "MainWindow", request: Request, size: tuple[int, int]) -> Picture:
    """Draw what a request asks for; nothing of the desktop gets into it."""
    panes, look = window.denoise.panes()
    grid = window.denoise.viewport.grid
    pixels = (size[0] * request.scale, size[1] * request.scale)
    look, poses = scaled(look, request.scale), grid.poses()
    if request.subject == "pane":
        pane = _pictured_pane(window)
        poses = [poses[grid.ids.index(pane)]]
        panes = [p for p in panes if p.id == pane]
    elif grid.enlarged:
        poses = [poses[grid.ids.index(grid.enlarged)]]
        panes = [p for p in panes if p.id == grid.enlarged]
    return grid_picture(panes, look, poses, pixels, transparent=request.transparent)


def window_image(window: "MainWindow", scale: int) -> QImage:
    """Picture the whole window at a multiple of its size, the panes drawn anew at that size."""
    image = QImage(window.size() * scale, QImage.Format.Format_ARGB32)
    image.setDevicePixelRatio(scale)
    image.fill(Qt.GlobalColor.transparent)
    window.render(image)
    viewport = window.denoise.viewport
    size = (viewport.width(), viewport.height())
    drawn = picture(window, Request("grid", scale, transparent=False), size)
    place = QRect(viewport.mapTo(window, QPoint(0, 0)), viewport.size())
    painter = QPainter(image)
    painter.drawImage(place, _image(drawn))
    painter.end()
    return image


def _ask_for_picture(window: "MainWindow", request: Request, sizes: dict) -> None:
    def save(path: Path) -> None:
        if request.subject != "window":
            save_picture(picture(window, request, sizes[request.subject]), path)
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


def _pictured_pane(window: "MainWindow") -> str:
    grid = window.denoise.viewport.grid
    return grid.enlarged or window.denoise.selected or "noisy"


def _stem(window: "MainWindow") -> str:
    return Path(window.session.meshes.name).stem


def _image(drawn: Picture) -> QImage:
    rgb = np.ascontiguousarray(drawn)
    height, width, _ = rgb.shape
    return QImage(rgb.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()
