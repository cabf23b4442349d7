"""What the Statistics tab writes to files and to the clipboard."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtGui import QGuiApplication

from app.export.statistics_plots import PLOTS, save_statistics_plot
from app.export.statistics_tables import plot_tables
from app.ui.dialogs import ask_where_to_save, tell
from app.ui.statistics_matrix import SAVE_FILTERS

if TYPE_CHECKING:
    from app.ui.statistics_tab import StatisticsTab

_PLOT_FILTERS = "SVG (*.svg);;PDF (*.pdf);;PNG (*.png)"


def save_cell(tab: "StatisticsTab", cell: str, path: Path) -> None:
    """Save a plot, dark on white as papers want it, or the matrix."""
    if cell == "matrix":
        tab.matrix.save_to(path)
    else:
        save_statistics_plot(path, PLOTS[cell], tab.work.series())


def copy_numbers(tab: "StatisticsTab", plot: str) -> None:
    """Copy the numbers of a plot, with tabs between them as spreadsheets want it."""
    tables = plot_tables(plot, tab.work.series())
    QGuiApplication.clipboard().setText("\n".join(table.text("\t") for table in tables))
    tab.session.notified.emit(f"Copied the numbers of: {PLOTS[plot].title}.")


def ask_for_cell(tab: "StatisticsTab", cell: str) -> None:
    """Ask where to save a plot or the matrix."""
    if not tab.work.models:
        return

    def save(path: Path) -> None:
        try:
            save_cell(tab, cell, path)
        except (ValueError, OSError) as error:
            tell(tab, str(error))
        else:
            tab.session.notified.emit(f"Saved {path.name}.")

    matrix = cell == "matrix"
    name = f"{tab.work.models[0].name}_{cell}.{'png' if matrix else 'svg'}"
    filters = SAVE_FILTERS if matrix else _PLOT_FILTERS
    ask_where_to_save(tab, "Save the plot", name, filters, save)
