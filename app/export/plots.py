"""The plot of an error against the iteration, the same in the window and in a file."""

import os
from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from app.export.chart import ErrorChart, ErrorCurve, draw_curves
from app.export.frame import draw_frame
from app.export.outcomes import Outcome
from app.scene.colours import LIGHT, Theme
from core.io import SaveError
from core.metrics import MetricSpec
from core.whole_files import whole_file

PLOT_SUFFIXES = (".png", ".svg", ".pdf")


def error_curves(outcomes: Sequence[Outcome], metric: str) -> tuple[ErrorCurve, ...]:
    """Return the lines of a metric."""
    return tuple(
        ErrorCurve(o.method, o.title, o.colour, o.errors[metric], o.iteration, o.diverged)
        for o in outcomes
    )


def draw_errors(
    axes: Axes,
    curves: Sequence[ErrorCurve],
    noisy_value: float | None,
    metric: MetricSpec,
    theme: Theme = LIGHT,
    *,
    log: bool = False,
    selected: str | None = None,
) -> None:
    """Draw errors against the iteration, in place of what the axes show.

    The legend stands right of the axes, which make room for it whatever the size of the figure.

    Parameters
    ----------
    axes : matplotlib Axes
        The only ones of their figure, which they fill.
    curves, noisy_value, metric, theme, log, selected
        As :class:`ErrorChart` describes them.
    """
    chart = ErrorChart(curves, noisy_value, metric, theme, log, selected)
    draw_frame(axes, chart.frame)
    draw_curves(axes, chart)


def save_error_plot(
    path: str | os.PathLike[str],
    curves: Sequence[ErrorCurve],
    noisy_value: float | None,
    metric: MetricSpec,
    theme: Theme = LIGHT,
    *,
    log: bool = False,
    selected: str | None = None,
    size: tuple[float, float] = (8.0, 4.0),
    dpi: float = 200.0,
) -> None:
    """Write the plot to a PNG, SVG or PDF file; the text of SVG and PDF stays text.

    Parameters
    ----------
    path : str or path-like
        File whose suffix is one of `PLOT_SUFFIXES`.
    curves, noisy_value, metric, theme, log, selected
        As :class:`ErrorChart` describes them.
    size : (float, float)
        Width and height in inches.
    dpi : float
        Pixels an inch of a PNG file.

    Raises
    ------
    SaveError
        If the suffix is another.
    """
    file = Path(path)
    suffix = file.suffix.lower()
    if suffix not in PLOT_SUFFIXES:
        allowed = " ".join(PLOT_SUFFIXES)
        raise SaveError(f"{file.name}: plots are not written in this format; use {allowed}.")
    figure = Figure(figsize=size)
    axes = figure.add_subplot()
    draw_errors(axes, curves, noisy_value, metric, theme, log=log, selected=selected)
    # No date and no random ids: the same study gives the same file.
    metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}.get(suffix)
    with (
        mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "burnish", "pdf.fonttype": 42}),
        whole_file(file) as stream,
    ):
        figure.savefig(stream, format=suffix[1:], dpi=dpi, metadata=metadata)
