"""Frame of a plot: ground, scales, and a legend beside the axes at any size of the figure."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.ticker import FuncFormatter, Locator, LogLocator, MaxNLocator, NullLocator
from matplotlib.transforms import (
    Affine2DBase,
    Bbox,
    ScaledTranslation,
    Transform,
    blended_transform_factory,
)

from app.scene.colours import Theme

FONT_SIZE = 8.0

# Inches, as matplotlib measures figures.
_LEFT, _BOTTOM, _TOP = 0.56, 0.40, 0.26
_GAP = 0.08
_SAMPLE = 0.22
_PITCH = 12.5 / 72


@dataclass(frozen=True)
class Entry:
    """One line of the legend; its artists carry the gid."""

    gid: str
    label: str
    colour: str
    width: float
    dashed: bool = False
    bold: bool = False


def dress(axes: Axes, label: str, theme: Theme) -> None:
    """Clear, colour and label axes, and let them fill their figure.

    The ticks are kept: making them anew takes longer than drawing the plot.
    """
    for artist in [*axes.lines, *axes.texts]:
        artist.remove()
    axes.figure.set_facecolor(theme.panel)
    axes.set_facecolor(theme.panel)
    axes.set_axes_locator(_fill_figure)
    axes.grid(axis="y", color=theme.faint, lw=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(colors=theme.ink, labelsize=FONT_SIZE, length=3, color=theme.faint)
    axes.tick_params(which="minor", length=0)
    for side, spine in axes.spines.items():
        spine.set_visible(side in {"left", "bottom"})
        spine.set_color(theme.faint)
    # Labels with a place of their own: matplotlib would lay out all ticks to find one for them.
    words: dict[str, Any] = {"fontsize": FONT_SIZE, "color": theme.ink}
    axes.set_title(label, loc="left", y=1.0, pad=6, **words)
    axes.set_xlabel("iteration", **words)
    below = _inches_from(axes, 0, 0)
    axes.xaxis.set_label_coords(0.5, -0.23, blended_transform_factory(axes.transAxes, below))


def scale(axes: Axes, last: int, low: float, high: float, *, log: bool) -> None:
    """Show the iterations 0 to `last` and the errors `low` to `high`."""
    axes.set_xlim(-0.012 * last, 1.012 * last)
    axes.xaxis.set_major_locator(MaxNLocator("auto", integer=True, steps=[1, 2, 5, 10]))
    if log:
        axes.set_yscale("log", nonpositive="mask")
        axes.yaxis.set_major_locator(_log_locator(high / low))
        axes.yaxis.set_minor_locator(NullLocator())
    else:
        axes.set_yscale("linear")
        axes.yaxis.set_major_locator(MaxNLocator("auto", steps=[1, 2, 5, 10]))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_ylim(low, high)


def _log_locator(ratio: float) -> Locator:
    """Ticks that a person can name, some of them even within a single decade."""
    if ratio < 5:
        return MaxNLocator(4, steps=[1, 2, 5, 10])
    return LogLocator(subs=(1, 2, 5) if ratio < 200 else (1,), numticks=6)


def add_legend(axes: Axes, entries: Sequence[Entry], theme: Theme) -> None:
    """List the entries right of the axes, in inches from their top right corner.

    Matplotlib's own legend takes longer to draw than all the rest of the plot.
    """
    corner = _inches_from(axes, 1, 1)
    for slot, entry in enumerate(entries):
        y = 0.5 * _TOP - slot * _PITCH
        shared: dict[str, Any] = {"transform": corner, "clip_on": False, "gid": entry.gid}
        sample = Line2D([2 * _GAP, 2 * _GAP + _SAMPLE], [y, y], lw=entry.width, **shared)
        sample.set_color(entry.colour)
        sample.set_linestyle((0, (3, 2)) if entry.dashed else "-")
        axes.add_line(sample)
        label = _LegendLabel(3 * _GAP + _SAMPLE, y, entry.label, va="center_baseline", **shared)
        label.set(color=theme.ink, fontsize=FONT_SIZE, fontweight="bold" if entry.bold else None)
        axes.add_artist(label)


def _inches_from(axes: Axes, x: float, y: float) -> Transform:
    """Transform of inches to the right of and above a point given in shares of the axes."""
    place = ScaledTranslation(x, y, cast(Affine2DBase, axes.transAxes))
    return axes.figure.dpi_scale_trans + place


class _LegendLabel(Text):
    """Text of the legend, told apart from texts inside the axes."""


def _fill_figure(axes: Any, renderer: Any) -> Bbox:
    """Place the axes between their labels and the legend, in shares of the figure."""
    width, height = axes.figure.get_size_inches()
    labels = [artist for artist in axes.get_children() if isinstance(artist, _LegendLabel)]
    widths = [label.get_window_extent(renderer).width for label in labels]
    beside = 4 * _GAP + _SAMPLE + max(widths, default=0.0) / axes.figure.dpi
    right = max(width - beside, _LEFT + 0.5)
    return Bbox([[_LEFT / width, _BOTTOM / height], [right / width, max(1 - _TOP / height, 0.6)]])
