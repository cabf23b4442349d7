"""What the Statistics tab writes to files and to the clipboard."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtGui import QGuiApplication

from app.export.statistics_bundle import model_pieces, write_bundle
from app.export.statistics_plots import PLOTS, save_statistics_plot
from app.export.statistics_series import Series
from app.export.statistics_tables import plot_tables
from app.session.jobs import progress_job
from app.ui.dialogs import ask_for_folder, ask_whether
from app.ui.exporting import Drawer, ask_to_export, at_once, export
from app.ui.statistics_matrix import SAVE_FILTERS
from app.ui.statistics_work import Model
from core.statistics import MeshStatistics, statistics_steps
from core.whole_files import write_atomically

if TYPE_CHECKING:
    from app.ui.statistics_tab import StatisticsTab

_PLOT_FILTERS = "SVG (*.svg);;PDF (*.pdf);;PNG (*.png)"


def cell_writer(tab: "StatisticsTab", cell: str) -> Callable[[Path], None]:
    """Return what saves a plot of now, dark on white as papers want it, or the matrix."""
    if cell == "matrix":
        return tab.matrix.writer()
    return partial(save_statistics_plot, plot=PLOTS[cell], series=tab.work.series())


def copy_numbers(tab: "StatisticsTab", plot: str) -> None:
    """Copy the numbers of a plot, with tabs between them as spreadsheets want it."""
    tables = plot_tables(plot, tab.work.series())
    QGuiApplication.clipboard().setText("\n".join(table.text("\t") for table in tables))
    tab.session.notified.emit(f"Copied the numbers of: {PLOTS[plot].title}.")


def save_tables(path: Path, series: Sequence[Series]) -> None:
    """Save the numbers of all plots, each table under its own name, into one CSV file."""
    tables = [table for plot in PLOTS for table in plot_tables(plot, series)]
    text = "\n".join(f"# {table.name}\n{table.text()}" for table in tables)
    write_atomically(path, text.encode())


def ask_for_tables(tab: "StatisticsTab") -> None:
    """Ask where to save the numbers of all plots."""
    name = f"{tab.work.models[0].name}_statistics.csv"
    write = partial(save_tables, series=tab.work.series())
    _ask(tab, "Save the tables", name, "CSV (*.csv)", write)


def ask_for_bundle(tab: "StatisticsTab") -> None:
    """Ask for the folder of all plots, tables and numbers of the first model."""

    def use(folder: Path) -> None:
        write = partial(bundle, tab, tab.work.models[0], folder)
        if _holds_files(folder):
            text = f"The folder {folder.name} is not empty. Save the statistics there?"
            more = "Files of the same names are replaced: figure.png, degree.csv and such."
            ask_whether(tab, text, more, "Save There", write)
        else:
            write()

    name = f"{tab.work.models[0].name}_statistics"
    ask_for_folder(tab, "Save the statistics into a folder", name, use)


def bundle(tab: "StatisticsTab", model: Model, folder: Path) -> None:
    """Compute and write everything beside the window, as `burnish stats -o` does."""

    def write(statistics: MeshStatistics) -> None:
        def begin(folder: Path, drawer: Drawer) -> Iterator[float]:
            return write_bundle(model.name, statistics, folder, drawer(model_pieces(model.mesh)))

        export(tab.session, folder, begin, f"Saved the statistics into {folder.name}.")

    steps = statistics_steps(model.mesh, tab.work.geodesic)
    title = f"Statistics of {model.name}"
    tab.session.jobs.start(progress_job(steps, write, tab.session.report, title=title))


def ask_for_cell(tab: "StatisticsTab", cell: str) -> None:
    """Ask where to save a plot or the matrix."""
    if not tab.work.models:
        return
    matrix = cell == "matrix"
    if matrix:
        tab.matrix.show_mesh(tab.work.models[0].mesh, tab.theme)
    name = f"{tab.work.models[0].name}_{cell}.{'png' if matrix else 'svg'}"
    filters = SAVE_FILTERS if matrix else _PLOT_FILTERS
    _ask(tab, "Save the plot", name, filters, cell_writer(tab, cell))


def _holds_files(folder: Path) -> bool:
    """Whether there is something in a folder that could be lost."""
    with suppress(OSError):  # writing there says why it cannot
        return any(folder.iterdir())
    return False


def _ask(
    tab: "StatisticsTab", title: str, name: str, filters: str, write: Callable[[Path], None]
) -> None:
    ask_to_export(tab, tab.session, title, name, filters, at_once(write))
