"""Axes of the statistics plots: a main field, and beside it a histogram on the same scale."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase
from matplotlib.ticker import FuncFormatter, MaxNLocator

from app.export.frame import FONT_SIZE
from app.export.montage_plan import INCH
from app.export.statistics_series import Series
from app.export.wrapping import wrapped
from app.scene.colours import Theme
from core.statistics import AxisLabels, Histogram

_MARGINAL = 0.24
_WIDE_DEGREES = 60
_AXES_SHARE = 0.75
_WORDS_SHARE = 0.5
_BELOW_NUMBERS = 18.0


def main_axes(figure: FigureBase, labels: AxisLabels, theme: Theme) -> Axes:
    """Clear a figure with a constrained layout, or a part of one, and return axes that fill it."""
    figure.clear()
    figure.set_facecolor(theme.panel)
    axes = figure.add_subplot()
    dress(axes, theme)
    style: dict[str, Any] = {"fontsize": FONT_SIZE, "color": theme.ink}
    axes.set_xlabel(labels.x, **style)
    axes.set_ylabel(_beside_the_scale(labels.y, figure), **style)
    return axes


def marginal_axes(figure: FigureBase, labels: AxisLabels, theme: Theme) -> tuple[Axes, Axes]:
    """Clear a figure and return axes with a narrow field to their right for a histogram."""
    axes = main_axes(figure, labels, theme)
    beside = axes.inset_axes((1.03, 0, _MARGINAL, 1), sharey=axes)
    dress(beside, theme)
    beside.tick_params(labelleft=False, labelbottom=False, bottom=False, left=False)
    # Its label stands below the numbers of the main field: the last of them reaches over here.
    beside.set_xlabel("share", fontsize=FONT_SIZE, color=theme.ink, labelpad=_BELOW_NUMBERS)
    return axes, beside


def _beside_the_scale(label: str, figure: FigureBase) -> str:
    """Part a label into lines that fit beside axes of the figure's height, and set its index."""
    room = _AXES_SHARE * figure.get_window_extent().height / figure.get_figure(root=True).dpi * INCH
    return "\n".join(wrapped(label, room, FONT_SIZE)).replace("K_nn", "$K_{nn}$")


def dress(axes: Axes, theme: Theme) -> None:
    """Give axes the colours of a theme."""
    axes.set_facecolor(theme.panel)
    axes.grid(axis="y", color=theme.faint, lw=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(
        colors=theme.ink, labelcolor=theme.ink, labelsize=FONT_SIZE, length=3, color=theme.faint
    )
    for side, spine in axes.spines.items():
        spine.set_visible(side in {"left", "bottom"})
        spine.set_color(theme.faint)


def degree_scale(axes: Axes, series: Sequence[Series]) -> None:
    """Put whole degrees on the x axis; very wide ranges on a logarithmic scale."""
    last = max((int(one.degree.degrees.max(initial=0)) for one in series), default=0)
    if last > _WIDE_DEGREES:
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    else:
        axes.xaxis.set_major_locator(MaxNLocator(14, integer=True, steps=[1, 2, 5, 10]))


def draw_beside(axes: Axes, histogram: Histogram, colour: str) -> None:
    """Draw a histogram along the y axis."""
    axes.stairs(
        histogram.shares,
        histogram.edges,
        orientation="horizontal",
        fill=True,
        color=colour,
        alpha=0.45,
    )
    axes.set_xlim(left=0)


def add_legend(axes: Axes, series: Sequence[Series], theme: Theme) -> None:
    """Name the models where there are two."""
    if len(series) < 2:
        return
    handles = [axes.plot([], [], color=one.colour, lw=5, alpha=0.8)[0] for one in series]
    legend = axes.legend(
        handles,
        [one.name for one in series],
        loc="upper right",
        fontsize=FONT_SIZE,
        labelcolor=theme.ink,
        facecolor=theme.panel,
        edgecolor="none",
        framealpha=0.85,
    )
    legend.set_zorder(9)


def say_refusals(axes: Axes, plot: str, series: Sequence[Series], theme: Theme) -> None:
    """Say within the axes why models have no curve there."""
    sentences = [f"{one.name}: {one.refusals[plot]}" for one in series if plot in one.refusals]
    figure = axes.figure
    dots = figure.get_figure(root=True).dpi
    room = _WORDS_SHARE * figure.get_window_extent().width / dots * INCH
    lines = wrapped("\n".join(sentences), room, FONT_SIZE)
    axes.text(
        0.5, 0.5, "\n".join(lines), transform=axes.transAxes, ha="center", va="center",
        fontsize=FONT_SIZE, color=theme.ink,
    )  # fmt: skip


def spread_over_ranks(ranks: np.ndarray, values: np.ndarray, bins: int) -> Histogram:
    """Histogram of values that are given against their normalised rank."""
    even = np.interp((np.arange(4000) + 0.5) / 4000, ranks, values)
    counts, edges = np.histogram(even, bins)
    return Histogram(edges.astype(np.float64), counts.astype(np.int64))
