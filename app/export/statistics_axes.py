"""Axes of the statistics plots: a main field, and beside it a histogram on the same scale."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from app.export.frame import FONT_SIZE
from app.export.montage_plan import INCH
from app.export.statistics_series import Series
from app.export.wrapping import width_of, wrapped
from app.scene.colours import Theme
from core.statistics import AxisLabels, Histogram

NOT_YET = "Not computed yet"
"""What stands in place of a plot until its numbers are there."""

_MARGINAL = 0.24
_WIDE_DEGREES = 60
_MARGINAL_LEFT = 1.03
# Centimetres that numbers and labels take to one side.
_AROUND = 1.4
_WORDS_SHARE = 0.5
# Centimetres of a line in the legend, with the gaps around it.
_SAMPLE = 1.0


def main_axes(figure: FigureBase, labels: AxisLabels, theme: Theme, *, share: float = 1.0) -> Axes:
    """Clear a figure with a constrained layout, or a part of one, and return axes that fill it.

    They have a `share` of the width that is left beside their numbers and label.
    """
    figure.clear()
    figure.set_facecolor(theme.panel)
    axes = figure.add_subplot()
    dress(axes, theme)
    style: dict[str, Any] = {"fontsize": FONT_SIZE, "color": theme.ink}
    room = figure.get_window_extent()
    axes.set_xlabel(_fitted(labels.x, room.width, figure, share), **style)
    axes.set_ylabel(_fitted(labels.y, room.height, figure), **style)
    return axes


def marginal_axes(figure: FigureBase, labels: AxisLabels, theme: Theme) -> tuple[Axes, Axes]:
    """Clear a figure and return axes with a narrow field to their right for a histogram."""
    axes = main_axes(figure, labels, theme, share=1 / (_MARGINAL_LEFT + _MARGINAL))
    beside = axes.inset_axes((_MARGINAL_LEFT, 0, _MARGINAL, 1), sharey=axes)
    dress(beside, theme)
    beside.tick_params(labelleft=False, labelbottom=False, bottom=False, left=False)
    # Its label stands above: below, the numbers and the label of the main field reach over here.
    beside.xaxis.set_label_position("top")
    beside.set_xlabel("share", loc="right", fontsize=FONT_SIZE, color=theme.ink)
    return axes, beside


def _fitted(label: str, pixels: float, figure: FigureBase, share: float = 1.0) -> str:
    """Part a label into lines that fit beside axes in a figure of a length; set its index."""
    room = share * (pixels / figure.get_figure(root=True).dpi * INCH - _AROUND)
    return "\n".join(wrapped(label, max(room, 1.0), FONT_SIZE)).replace("K_nn", "$K_{nn}$")


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


def add_legend(figure: FigureBase, series: Sequence[Series], theme: Theme) -> None:
    """Name the models where there are two: above the axes, where they cover no curve."""
    if len(series) < 2:
        return
    room = _centimetres(figure)
    names = ["\n".join(wrapped(one.name, room - _SAMPLE, FONT_SIZE)) for one in series]
    beside = sum(width_of(one.name, FONT_SIZE) + _SAMPLE for one in series) < room
    figure.legend(
        [Line2D([], [], color=one.colour, lw=5, alpha=0.8) for one in series], names,
        loc="outside upper left", ncols=len(series) if beside else 1, borderaxespad=0,
        handlelength=1.2, columnspacing=1.2, fontsize=FONT_SIZE, labelcolor=theme.ink,
        frameon=False,
    )  # fmt: skip


def say_pending(figure: FigureBase, theme: Theme) -> None:
    """Clear a figure and say that there is no plot yet."""
    figure.clear()
    figure.set_facecolor(theme.panel)
    figure.text(0.5, 0.5, NOT_YET, ha="center", va="center", fontsize=FONT_SIZE, color=theme.ink)


def say_refusals(axes: Axes, plot: str, series: Sequence[Series], theme: Theme) -> None:
    """Say within the axes why models have no curve there."""
    sentences = [f"{one.name}: {one.refusals[plot]}" for one in series if plot in one.refusals]
    room = _WORDS_SHARE * _centimetres(axes.figure)
    lines = wrapped("\n".join(sentences), room, FONT_SIZE)
    axes.text(
        0.5, 0.5, "\n".join(lines), transform=axes.transAxes, ha="center", va="center",
        fontsize=FONT_SIZE, color=theme.ink,
    )  # fmt: skip


def _centimetres(figure: FigureBase) -> float:
    """Width of a figure or of a part of one."""
    return figure.get_window_extent().width / figure.get_figure(root=True).dpi * INCH


def spread_over_ranks(ranks: np.ndarray, values: np.ndarray, bins: int) -> Histogram:
    """Histogram of values that are given against their normalised rank."""
    even = np.interp((np.arange(4000) + 0.5) / 4000, ranks, values)
    counts, edges = np.histogram(even, bins)
    return Histogram(edges.astype(np.float64), counts.astype(np.int64))
