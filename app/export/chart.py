"""The curves of the error plot, and the frame that fits them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes

from app.export.frame import FONT_SIZE, Entry, Frame
from app.scene.colours import LIGHT, Theme
from core.metrics import MetricSpec

NOISY_LABEL = "noisy input"

_THIN, _HEAVY = 1.4, 2.8
_DASHES = (0, (4, 3))
# Times the largest sound error up to which a logarithmic plot follows a run that diverges.
_HEADROOM = 20.0
# Ends of a logarithmic scale stand on steps of a decade, so that the frame, whose drawing takes
# longest, is seldom another while a run goes on.
_STEPS = 8


@dataclass(frozen=True)
class ErrorCurve:
    """One method's line in the plot.

    Attributes
    ----------
    method : str
        Id of the method.
    title : str
        Its label.
    colour : str
        Colour of the line.
    values : tuple of float
        Error after 0 (the noisy input), 1, 2 … iterations.
    iteration : int
        Where the marker stands.
    diverged : int or None
        The iteration at which the run diverged.
    """

    method: str
    title: str
    colour: str
    values: tuple[float, ...]
    iteration: int
    diverged: int | None = None


@dataclass(frozen=True)
class ErrorChart:
    """All that the plot shows.

    Attributes
    ----------
    curves : sequence of ErrorCurve
        The lines, in the order of the legend.
    noisy_value : float or None
        Error of the noisy input, a dashed line; None leaves it out.
    metric : MetricSpec
        What the values are.
    theme : Theme
        Colours of ground and ink.
    log : bool
        Logarithmic errors, as far as there are positive ones.
    selected : str or None
        Method to draw with a heavy line.
    reach : int
        Iteration up to which the curves will come, if that is further than they are.
    """

    curves: Sequence[ErrorCurve]
    noisy_value: float | None
    metric: MetricSpec
    theme: Theme = LIGHT
    log: bool = False
    selected: str | None = None
    reach: int = 1

    @property
    def frame(self) -> Frame:
        """Everything around the curves."""
        low, high = self._range()
        return Frame(
            label=f"{self.metric.title} ({self.metric.unit})",
            last=max(self.reach, 1, *(len(curve.values) - 1 for curve in self.curves)),
            low=low,
            high=high,
            log=low > 0,
            entries=self._entries(),
            theme=self.theme,
        )

    def _range(self) -> tuple[float, float]:
        """Smallest and largest error to show; the smallest is 0 on a linear scale.

        A diverging run would press all others to the ground: where there are others, it leaves
        the plot at the top.
        """
        sound = [curve for curve in self.curves if curve.diverged is None]
        highest = max(self._positive(sound), default=0.0)
        values = [v for v in self._positive(self.curves) if v <= _HEADROOM * highest]
        if self.log and values:
            low = math.floor(_STEPS * math.log10(min(values) / 1.1))
            high = math.ceil(_STEPS * math.log10(max(values) * 1.1))
            return 10 ** (low / _STEPS), 10 ** (high / _STEPS)
        return 0.0, 1.06 * highest or 1.0

    def _positive(self, curves: Sequence[ErrorCurve]) -> list[float]:
        values = [self.noisy_value or 0.0, *(v for curve in curves for v in curve.values)]
        return [value for value in values if 0 < value < math.inf]

    def _entries(self) -> tuple[Entry, ...]:
        entries = []
        for curve in self.curves:
            heavy = curve.method == self.selected
            gid, width = f"{curve.method}.legend", _HEAVY if heavy else _THIN
            entries.append(Entry(gid, curve.title, curve.colour, width, bold=heavy))
        if self.noisy_value is not None:
            entries.append(Entry("noisy", NOISY_LABEL, self.theme.ink, 1.2, dashed=True))
        return tuple(entries)


def draw_curves(axes: Axes, chart: ErrorChart) -> list[Artist]:
    """Draw the curves into axes that have the chart's frame.

    Returns
    -------
    list of matplotlib Artist
        What was drawn, from back to front; :func:`method_of` tells what belongs to whom.
    """
    drawn: list[Artist] = []
    if chart.noisy_value is not None:
        # Over the lines: a method just below the noisy input must not hide it.
        style: dict[str, Any] = {"lw": 1.2, "ls": _DASHES, "alpha": 0.8, "zorder": 4.5}
        drawn.append(axes.axhline(chart.noisy_value, color=chart.theme.ink, **style))
    for curve in chart.curves:
        drawn += _draw_curve(axes, curve, chart)
    diverged = [curve for curve in chart.curves if curve.diverged is not None and curve.values]
    for slot, curve in enumerate(diverged):
        drawn += _draw_divergence(axes, curve, chart, slot)
    return sorted(drawn, key=Artist.get_zorder)


def method_of(artist: Artist) -> str | None:
    """Return the method that an artist of the plot belongs to, or None."""
    method, _, part = str(artist.get_gid() or "").partition(".")
    return method if part else None


def _draw_curve(axes: Axes, curve: ErrorCurve, chart: ErrorChart) -> list[Artist]:
    heavy = curve.method == chart.selected
    order = 4.0 if heavy else 3.0
    iterations = range(len(curve.values))
    drawn: list[Artist] = [
        *axes.plot(
            iterations,
            curve.values,
            color=curve.colour,
            lw=_HEAVY if heavy else _THIN,
            zorder=order,
            gid=f"{curve.method}.line",
        )
    ]
    crossed = curve.diverged is not None and curve.iteration == len(curve.values) - 1
    if curve.iteration in iterations and not crossed:
        drawn += axes.plot(
            curve.iteration,
            min(curve.values[curve.iteration], axes.get_ylim()[1]),
            "o",
            color=curve.colour,
            ms=9 if heavy else 6.5,
            mec=chart.theme.panel,
            mew=1.0,
            zorder=order + 2,
            clip_on=False,
            gid=f"{curve.method}.marker",
        )
    return drawn


def _draw_divergence(axes: Axes, curve: ErrorCurve, chart: ErrorChart, slot: int) -> list[Artist]:
    """Mark where a run diverged; at the top, each slot has a line of its own for its label."""
    top = axes.get_ylim()[1]
    x, y = len(curve.values) - 1, min(curve.values[-1], top)
    style: dict[str, Any] = {"color": curve.colour, "zorder": 8, "clip_on": False}
    cross = axes.plot(x, y, "x", ms=8, mew=2.4, gid=f"{curve.method}.cross", **style)
    to_right = x < sum(axes.get_xlim()) / 2
    label = axes.annotate(
        f"diverged at {curve.diverged}",
        (x, y),
        (9 if to_right else -9, 3 - 12 * slot if y == top else 0),
        textcoords="offset points",
        ha="left" if to_right else "right",
        va="top" if y == top else "center",
        fontsize=FONT_SIZE,
        bbox={"facecolor": chart.theme.panel, "edgecolor": "none", "alpha": 0.85, "pad": 1.0},
        gid=f"{curve.method}.diverged",
        **style,
    )
    return [*cross, label]
