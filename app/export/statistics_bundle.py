"""The statistics of a model as files in a folder: figure, plots, tables, numbers, matrices."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from app.export.drawing_check import check_drawing
from app.export.frame import FONT_SIZE
from app.export.pictures import Picture, composed, grid_pieces
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
    model, with_matrices = _checked(model_pieces(mesh)), mesh if matrices else None
    for _ in write_bundle(name, statistics, folder, model, with_matrices):
        pass


def write_bundle(
    name: str,
    statistics: MeshStatistics,
    folder: Path,
    model: Iterator[Picture | None],
    with_matrices: TriangleMesh | None = None,
) -> Iterator[float]:
    """Write everything into a folder, file by file; yield the share that is done.

    Parameters
    ----------
    name : str
        The model.
    statistics : MeshStatistics
        Its statistics.
    folder : Path
        Where to write; it is made if needed.
    model : iterator
        Pieces of the picture of the model, not asked for before all but the figure is written.
    with_matrices : TriangleMesh, optional
        The mesh, where its matrices are to be written.

    Raises
    ------
    SaveError
        If the folder or a file in it cannot be written.
    """
    files = 4 + len(PLOTS) + (len(MATRICES) if with_matrices else 0)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        steps = _files(name, statistics, folder, model, with_matrices)
        for done, _ in enumerate(steps, 1):
            yield done / files
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise SaveError(f"{folder} cannot be written: {reason}.") from error


def statistics_figure(name: str, picture: Picture, series: Series) -> Figure:
    """Draw the model and the five plots as in thesis figures 3.2–3.7."""
    figure = Figure(figsize=(13.0, 7.4), facecolor=LIGHT.panel)
    grid: Any = figure.subfigures(2, 3)
    cells: list[SubFigure] = grid.ravel().tolist()
    _draw_model(cells[0], name, picture)
    for letter, cell, spec in zip("bcdef", cells[1:], PLOTS.values(), strict=True):
        spec.draw(cell, [series], LIGHT)
        _label(cell, f"({letter}) {spec.title}")
    # Once, not anew for each file.
    ConstrainedLayoutEngine().execute(figure)
    return figure


def model_pieces(mesh: TriangleMesh) -> Iterator[Picture | None]:
    """Draw a mesh with its edges where there are few enough to tell apart, step by step."""
    points = (mesh.vertices - mesh.vertices.mean(axis=0)).astype("float32")
    look = Look(mesh.topology, text_scale=1.0)
    pane = Pane("original", "", "", ORIGINAL_COLOUR, points)
    return grid_pieces([pane], look, None, _PICTURE_SIZE)


def _write_numbers(name: str, statistics: MeshStatistics, folder: Path) -> None:
    text = json.dumps(statistics_json(name, statistics), indent=1)
    write_atomically(folder / "statistics.json", text.encode())
    series = [Series.of_statistics(name, statistics)]
    for plot in PLOTS:
        for table in plot_tables(plot, series):
            write_atomically(folder / f"{table.name}.csv", table.text().encode())


def _files(
    name: str,
    statistics: MeshStatistics,
    folder: Path,
    model: Iterator[Picture | None],
    with_matrices: TriangleMesh | None,
) -> Iterator[None]:
    """Write one after another."""
    _write_numbers(name, statistics, folder)
    yield
    if with_matrices is not None:
        for matrix, build in MATRICES.items():
            for suffix in MATRIX_SUFFIXES:
                save_matrix(build(with_matrices), folder / f"{matrix}{suffix}")
            yield
    series = Series.of_statistics(name, statistics)
    for spec in PLOTS.values():
        save_statistics_plot(folder / f"{spec.id}.svg", spec, [series])
        yield
    figure = statistics_figure(name, composed(model), series)
    yield
    for suffix in ("png", "pdf"):
        save_figure(folder / f"figure.{suffix}", figure)
        yield


def _checked(pieces: Iterator[Picture | None]) -> Iterator[Picture | None]:
    """Draw only where that is possible."""
    check_drawing()
    yield from pieces


def _draw_model(cell: SubFigure, name: str, picture: Picture) -> None:
    axes = cell.add_subplot()
    axes.imshow(picture)
    axes.set_axis_off()
    _label(cell, f"(a) {name}")


def _label(cell: SubFigure, text: str) -> None:
    cell.suptitle(text, fontsize=FONT_SIZE + 2, color=LIGHT.ink)
