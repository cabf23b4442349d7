"""The statistics of a model as files in a folder: figure, plots, tables, numbers, matrices."""

import json
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure, SubFigure

from app.export.drawing_check import check_drawing
from app.export.frame import FONT_SIZE
from app.export.pictures import Picture, grid_picture
from app.export.statistics_plots import PLOTS, save_figure, save_statistics_plot
from app.export.statistics_reports import statistics_json
from app.export.statistics_series import Series
from app.export.statistics_tables import plot_tables
from app.scene.colours import LIGHT, ORIGINAL_COLOUR
from app.scene.panes import Look, Pane
from core.io import SaveError
from core.mesh import TriangleMesh
from core.mesh.matrices import MATRICES, MATRIX_SUFFIXES, save_matrix
from core.statistics import MeshStatistics
from core.whole_files import write_atomically

_PICTURE_SIZE = (1000, 800)


def write_statistics(
    name: str,
    mesh: TriangleMesh,
    statistics: MeshStatistics,
    folder: Path,
    *,
    matrices: bool = False,
) -> None:
    """Write everything about a mesh's statistics into a folder, which is made if needed.

    Raises
    ------
    SaveError
        If the folder or a file in it cannot be written.
    PictureError
        If there is no OpenGL for the picture; all else is written then.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _write_numbers(name, statistics, folder)
        if matrices:
            _write_matrices(mesh, folder)
        _write_plots(name, mesh, statistics, folder)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise SaveError(f"{folder} cannot be written: {reason}.") from error


def statistics_figure(name: str, mesh: TriangleMesh, series: Series) -> Figure:
    """Draw the model and the five plots as in thesis figures 3.2–3.7."""
    figure = Figure(figsize=(13.0, 7.4), facecolor=LIGHT.panel, layout="constrained")
    grid: Any = figure.subfigures(2, 3)
    cells: list[SubFigure] = grid.ravel().tolist()
    _draw_model(cells[0], name, model_picture(mesh))
    for letter, cell, spec in zip("bcdef", cells[1:], PLOTS.values(), strict=True):
        spec.draw(cell, [series], LIGHT)
        _label(cell, f"({letter}) {spec.title}")
    return figure


def model_picture(mesh: TriangleMesh) -> Picture:
    """Draw a mesh with its edges where there are few enough to tell apart."""
    points = (mesh.vertices - mesh.vertices.mean(axis=0)).astype("float32")
    look = Look(faces=mesh.faces, text_scale=1.0)
    pane = Pane("original", "", "", ORIGINAL_COLOUR, points)
    return grid_picture([pane], look, None, _PICTURE_SIZE)


def _write_numbers(name: str, statistics: MeshStatistics, folder: Path) -> None:
    text = json.dumps(statistics_json(name, statistics), indent=1)
    write_atomically(folder / "statistics.json", text.encode())
    series = [Series.of_statistics(name, statistics)]
    for plot in PLOTS:
        for table in plot_tables(plot, series):
            write_atomically(folder / f"{table.name}.csv", table.text().encode())


def _write_plots(name: str, mesh: TriangleMesh, statistics: MeshStatistics, folder: Path) -> None:
    series = Series.of_statistics(name, statistics)
    for spec in PLOTS.values():
        save_statistics_plot(folder / f"{spec.id}.svg", spec, [series])
    check_drawing()
    figure = statistics_figure(name, mesh, series)
    for suffix in ("png", "pdf"):
        save_figure(folder / f"figure.{suffix}", figure)


def _write_matrices(mesh: TriangleMesh, folder: Path) -> None:
    for name, build in MATRICES.items():
        for suffix in MATRIX_SUFFIXES:
            save_matrix(build(mesh), folder / f"{name}{suffix}")


def _draw_model(cell: SubFigure, name: str, picture: Picture) -> None:
    axes = cell.add_subplot()
    axes.imshow(picture)
    axes.set_axis_off()
    _label(cell, f"(a) {name}")


def _label(cell: SubFigure, text: str) -> None:
    cell.suptitle(text, fontsize=FONT_SIZE + 2, color=LIGHT.ink)
