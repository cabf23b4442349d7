"""Plots of the statistics in a figure: lines and text, inside their cells, on every ground."""

import re
from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from app.export.montage import montage_figure
from app.export.montage_files import montage_pixels, save_montage
from app.export.montage_plan import Cell, Montage, montage_layout
from app.export.pictures import PictureError
from app.export.statistics_montage import StatisticsSource
from app.export.statistics_plots import PLOTS
from app.export.statistics_series import SERIES_COLOURS, Series
from app.scene.camera import CameraPose
from app.scene.colours import DARK, LIGHT
from app.scene.statistics_panes import PaneMaker, ShownModel, colour_look
from core import mesh_statistics
from core.mesh import primitives
from core.statistics import SpectrumParams, connectivity

BALL = primitives.sphere(2)
CELLS = tuple(Cell(id_, spec.title) for id_, spec in PLOTS.items())
MONTAGE = Montage(CELLS, columns=3, width=16, dpi=80)


@pytest.fixture(scope="module")
def source():
    ball = Series.of_statistics("ball", mesh_statistics(BALL, spectrum=SpectrumParams()))
    other = Series.of_vertices("grid", SERIES_COLOURS[1], connectivity(primitives.grid()))
    models = [ShownModel("ball", ball.colour, BALL)]
    pose = CameraPose((2.0, -2.0, 2.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    look = colour_look(models, "", LIGHT, 1.0)
    return StatisticsSource(tuple(PaneMaker().panes(models)), look, (ball, other), pose)


def text_of(pdf):
    """All strings of a PDF that is not compressed; some writers take two bytes a letter."""
    strings = re.findall(rb"\(((?:\\.|[^\\)])*)\)", pdf, re.DOTALL)
    return b"".join(strings).replace(b"\0", b"").decode("latin-1")


def cells_of(figure):
    """Each cell with all its axes."""
    for cell in figure.subfigs:
        (axes,) = cell.axes
        yield cell, (axes, *axes.child_axes)


def test_plots_stay_lines_and_text_in_a_pdf(source, tmp_path):
    with mpl.rc_context({"pdf.compression": 0}):
        for name, cells in (("plots", CELLS), ("all", (Cell("0", "ball"), *CELLS))):
            montage = replace(MONTAGE, cells=cells)
            save_montage(montage_figure(montage, source), tmp_path / f"{name}.pdf")
    plots, everything = ((tmp_path / f"{name}.pdf").read_bytes() for name in ("plots", "all"))
    assert b"/Subtype /Image" not in plots
    for words in ("normalised rank", "degree k", "geodesic distance", "(a) Spectrum"):
        assert words in text_of(plots).replace("\\", "")
    assert everything.count(b"/Subtype /Image") == 1  # the model


@pytest.mark.parametrize(("columns", "dpi"), [(1, 60), (3, 80), (5, 150)])
def test_everything_of_a_plot_is_inside_its_cell(source, columns, dpi):
    montage = replace(MONTAGE, columns=columns, width=3.4 * columns, dpi=dpi)
    figure = montage_figure(montage, source)
    renderer = FigureCanvasAgg(figure).get_renderer()
    layout = montage_layout(montage, with_bar=False)
    for place, (cell, axes) in enumerate(cells_of(figure)):
        left, bottom, wide, high = (c / 2.54 * dpi for c in layout.cell(montage, place))
        assert cell.bbox.bounds == pytest.approx((left, bottom, wide, high), abs=0.6)
        box = axes[0].get_tightbbox(renderer)
        slack = 0.05 * dpi  # less than the gap between cells
        assert left - slack <= box.x0 < box.x1 <= left + wide + slack
        assert bottom - slack <= box.y0 < box.y1 <= bottom + high + slack
        assert axes[0].bbox.width > 0.2 * wide


def test_a_plot_as_large_as_its_cell_fills_it(source):
    montage = replace(MONTAGE, columns=1, width=12)
    figure = montage_figure(montage, source)
    for cell, (axes, *_) in cells_of(figure):
        assert axes.bbox.height > 0.7 * cell.bbox.height


def test_plots_have_the_ground_of_the_figure(source):
    dark = replace(source, look=replace(source.look, theme=DARK))
    white, clear, black = (
        montage_pixels(montage_figure(replace(MONTAGE, ground=ground), each))
        for ground, each in (("white", source), ("transparent", source), ("theme", dark))
    )
    left, bottom, wide, high = montage_layout(MONTAGE, with_bar=False).cell(MONTAGE, 0)
    across, down = (left + 0.5 * wide, bottom + 0.4 * high)
    row, column = round(white.shape[0] - down / 2.54 * 80), round(across / 2.54 * 80)
    inside = np.s_[row - 6 : row + 6, column - 6 : column + 6]
    assert (white[inside].reshape(-1, 4).max(axis=0) == 255).all()
    assert clear[inside][..., 3].min() == 0
    assert black[inside][..., :3].min() == min(int(DARK.ground[i : i + 2], 16) for i in (1, 3, 5))
    assert (clear[..., 3] == 255).any()


def test_plots_that_are_too_small_to_read_are_one_sentence(source):
    with pytest.raises(PictureError, match=r"^The figure is too small for its plots: .*\.$"):
        montage_figure(replace(MONTAGE, width=8), source)
