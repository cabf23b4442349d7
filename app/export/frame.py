"""Frame of a plot: ground, scales, and a legend beside the axes at any size of the figure."""

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


@dataclass(frozen=True)
class Frame:
    """All of a plot but its curves: equal frames look the same.

    Attributes
    ----------
    label : str
        What the values are.
    last : int
        Last iteration.
    low, high : float
        Smallest and largest value.
    log : bool
        Whether the values are on a logarithmic scale.
    entries : tuple of Entry
        The legend.
    theme : Theme
        Colours of ground and ink.
    """

    label: str
    last: int
    low: float
    high: float
    log: bool
    entries: tuple[Entry, ...]
    theme: Theme


def draw_frame(axes: Axes, frame: Frame) -> None:
    """Clear axes, frame them, and let them fill their figure.

    The ticks are kept: making them anew takes longer than drawing the plot.
    """
    for artist in [*axes.lines, *axes.texts]:
        artist.remove()
    _dress(axes, frame.theme)
    _label(axes, frame)
    _scale(axes, frame)
    _add_legend(axes, frame)


def _dress(axes: Axes, theme: Theme) -> None:
    axes.figure.set_facecolor(theme.panel)
    axes.set_facecolor(theme.panel)
    axes.set_axes_locator(_fill_figure)
    axes.grid(axis="y", color=theme.faint, lw=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(colors=theme.ink, labelsize=FONT_SIZE, length=3, color=theme.faint)
    for side, spine in axes.spines.items():
        spine.set_visible(side in {"left", "bottom"})
        spine.set_color(theme.faint)


def _label(axes: Axes, frame: Frame) -> None:
    """Label the axes, in places of our own: matplotlib would lay out all ticks to find some."""
    words: dict[str, Any] = {"fontsize": FONT_SIZE, "color": frame.theme.ink}
    axes.set_title(frame.label, loc="left", y=1.0, pad=6, **words)
    axes.set_xlabel("iteration", **words)
    below = blended_transform_factory(axes.transAxes, _inches_from(axes, 0, 0))
    axes.xaxis.set_label_coords(0.5, -0.23, below)


def _scale(axes: Axes, frame: Frame) -> None:
    axes.set_xlim(-0.012 * frame.last, 1.012 * frame.last)
    axes.xaxis.set_major_locator(MaxNLocator("auto", integer=True, steps=[1, 2, 5, 10]))
    if frame.log:
        axes.set_yscale("log", nonpositive="mask")
        axes.yaxis.set_major_locator(_log_locator(frame.high / frame.low))
        axes.yaxis.set_minor_locator(NullLocator())
    else:
        axes.set_yscale("linear")
        axes.yaxis.set_major_locator(MaxNLocator("auto", steps=[1, 2, 5, 10]))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_ylim(frame.low, frame.high)


def _log_locator(ratio: float) -> Locator:
    """Ticks that a person can name, some of them even within a single decade."""
    if ratio < 5:
        return MaxNLocator(4, steps=[1, 2, 5, 10])
    return LogLocator(subs=(1, 2, 5) if ratio < 200 else (1,), numticks=6)


def _add_legend(axes: Axes, frame: Frame) -> None:
    """List the entries right of the axes, in inches from their top right corner.

    Matplotlib's own legend takes longer to draw than all the rest of the plot.
    """
    corner = _inches_from(axes, 1, 1)
    for slot, entry in enumerate(frame.entries):
        y = 0.5 * _TOP - slot * _PITCH
        shared: dict[str, Any] = {"transform": corner, "clip_on": False, "gid": entry.gid}
        sample = Line2D([2 * _GAP, 2 * _GAP + _SAMPLE], [y, y], lw=entry.width, **shared)
        sample.set_color(entry.colour)
        sample.set_linestyle((0, (3, 2)) if entry.dashed else "-")
        axes.add_line(sample)
        label = _LegendLabel(3 * _GAP + _SAMPLE, y, entry.label, va="center_baseline", **shared)
        label.set(
            color=frame.theme.ink, fontsize=FONT_SIZE, fontweight="bold" if entry.bold else None
        )
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
