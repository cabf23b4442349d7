"""A whole comparison as files in a folder: pictures, plot, tables, meshes, numbers, study."""

import json
from pathlib import Path

from app.export.drawing_check import check_drawing
from app.export.montage import montage_figure
from app.export.montage_files import save_montage
from app.export.montage_panes import Source
from app.export.montage_plan import Cell, Montage
from app.export.outcomes import study_outcomes
from app.export.pictures import grid_picture, save_picture
from app.export.plots import error_curves, save_error_plot
from app.export.reports import comparison_json
from app.export.tables import as_csv, as_markdown, study_rows
from app.scene.comparison import study_look, study_panes
from core.comparison import StudyResult
from core.io import SaveError, save_mesh
from core.study_files import write_study_file
from core.whole_files import write_atomically

_PICTURE_SIZE = (1920, 1080)
_TEXT_SCALE = 1.5
_MONTAGES = (".png", ".pdf")


def write_comparison(result: StudyResult, folder: Path) -> None:
    """Write everything about a finished study into a folder, which is made if needed.

    Raises
    ------
    SaveError
        If the folder or a file in it cannot be written.
    PictureError
        If there is no OpenGL for the pictures; all else is written then.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _write_numbers(result, folder)
        _write_meshes(result, folder)
        _write_pictures(result, folder)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise SaveError(f"{folder} cannot be written: {reason}.") from error


def _write_numbers(result: StudyResult, folder: Path) -> None:
    rows = study_rows(result)
    texts = {
        "table.csv": as_csv(rows),
        "table.md": as_markdown(rows),
        "result.json": json.dumps(comparison_json(result), indent=1),
    }
    for name, text in texts.items():
        write_atomically(folder / name, text.encode())
    write_study_file(result.study, folder / "study.burnish")


def _write_meshes(result: StudyResult, folder: Path) -> None:
    save_mesh(result.comparison.noisy, folder / "noisy.ply")
    for method in result.methods:
        save_mesh(method.mesh, folder / f"{method.choice.method}.ply")


def _write_pictures(result: StudyResult, folder: Path) -> None:
    metric = result.study.metrics[result.study.metric]
    noisy = result.comparison.noisy_errors[metric.id]
    curves = error_curves(study_outcomes(result), metric.id)
    for suffix in ("svg", "png"):
        save_error_plot(folder / f"errors.{suffix}", curves, noisy, metric, log=True)
    check_drawing()
    panes = study_panes(result)
    look = study_look(result, panes, _TEXT_SCALE)
    save_picture(grid_picture(panes, look, None, _PICTURE_SIZE), folder / "panes.png")
    montage = Montage(tuple(Cell(pane.id, pane.title) for pane in panes))
    figure = montage_figure(montage, Source(tuple(panes), look))
    for suffix in _MONTAGES:
        save_montage(figure, folder / f"montage{suffix}")
