"""The plot of an error against the iteration, the same in the window and in a file."""

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from app.export.frame import FONT_SIZE, Entry
from app.export.outcomes import Outcome
from app.scene.colours import LIGHT, Theme
from core.io import SaveError
from core.metrics import MetricSpec

PLOT_SUFFIXES = (".png", ".svg", ".pdf")
NOISY_LABEL = "noisy input"

_THIN, _HEAVY = 1.4, 2.8
# Times the largest sound error up to which a logarithmic plot follows a run that diverges.
_HEADROOM = 20.0


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


def error_curves(outcomes: Sequence[Outcome], metric: str) -> tuple[ErrorCurve, ...]:
    """Return the lines of a metric."""
    return tuple(
        ErrorCurve(o.method, o.title, o.colour, o.errors[metric], o.iteration, o.diverged)
        for o in outcomes
    )


def error_frame(
    curves: Sequence[ErrorCurve],
    noisy_value: float | None,
    metric: MetricSpec,
    theme: Theme = LIGHT,
    *,
    log: bool = False,
    selected: str | None = None,
) -> Frame:
    """Return the frame that fits some curves; parameters as for :func:`draw_errors`."""
    low, high = _error_range(curves, noisy_value, log=log)
    return Frame(
        label=f"{metric.title} ({metric.unit})",
        last=max([len(curve.values) - 1 for curve in curves], default=0) or 1,
        low=low,
        high=high,
        log=low > 0,
        entries=_entries(curves, noisy_value, theme, selected),
        theme=theme,
    )


def draw_curves(
    axes: Axes,
    frame: Frame,
    curves: Sequence[ErrorCurve],
    noisy_value: float | None,
    selected: str | None = None,
) -> list[Artist]:
    """Draw the curves into their frame and return what was drawn, the last on top."""
    for value in () if noisy_value is None else (noisy_value,):
        dashes = {"lw": 1.2, "ls": (0, (4, 3)), "alpha": 0.8, "gid": "noisy"}
        axes.axhline(value, color=frame.theme.ink, **dashes)
    for curve in curves:
        _draw_curve(axes, curve, frame, heavy=curve.method == selected)
    _draw_divergence(axes, curves, frame)
    legend = {entry.gid for entry in frame.entries}


def method_of(artist: Artist) -> str | None:
    """Return the method that an artist of the plot belongs to, or None."""
    method, _, part = str(artist.get_gid() or "").partition(".")
    return method if part else None


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
        As for :func:`draw_errors`.
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
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "burnish", "pdf.fonttype": 42}):
        figure.savefig(file, dpi=dpi, metadata=metadata)


def _last_iteration(curves: Sequence[ErrorCurve]) -> int:
    return max([len(curve.values) - 1 for curve in curves], default=0) or 1


def _error_range(
    curves: Sequence[ErrorCurve], noisy: tuple[float, ...], *, log: bool
) -> tuple[float, float]:
    """Smallest and largest error to show; the smallest is 0 on a linear scale.

    A diverging run would press all others to the ground: where there are others, it leaves the
    plot at the top.
    """
    sound = [curve for curve in curves if curve.diverged is None]
    highest = max(_positive(sound, noisy), default=0.0)
    values = [value for value in _positive(curves, noisy) if value <= _HEADROOM * highest]
    if log and values:
        return min(values) / 1.2, max(values) * 1.2
    return 0.0, 1.06 * highest or 1.0


def _positive(curves: Sequence[ErrorCurve], noisy: tuple[float, ...]) -> list[float]:
    values = [*noisy, *(value for curve in curves for value in curve.values)]
    return [value for value in values if 0 < value < math.inf]


def _draw_curve(axes: Axes, curve: ErrorCurve, theme: Theme, *, heavy: bool) -> None:
    order = 4.0 if heavy else 3.0
    iterations = range(len(curve.values))
    axes.plot(
        iterations,
        curve.values,
        color=curve.colour,
        lw=_HEAVY if heavy else _THIN,
        zorder=order,
        gid=f"{curve.method}.line",
    )
    if curve.iteration not in iterations:
        return
    axes.plot(
        curve.iteration,
        min(curve.values[curve.iteration], axes.get_ylim()[1]),
        "o",
        color=curve.colour,
        ms=9 if heavy else 6.5,
        mec=theme.panel,
        mew=1.0,
        zorder=order + 2,
        clip_on=False,
        gid=f"{curve.method}.marker",
    )


def _draw_divergence(axes: Axes, curves: Sequence[ErrorCurve], theme: Theme, high: float) -> None:
    """Mark where runs diverged, each label on a line of its own so that none covers another."""
    diverged = [curve for curve in curves if curve.diverged is not None and curve.values]
    for slot, curve in enumerate(diverged):
        x, y = len(curve.values) - 1, min(curve.values[-1], high)
        style: dict[str, Any] = {"color": curve.colour, "zorder": 8, "clip_on": False}
        axes.plot(x, y, "x", ms=8, mew=2.4, gid=f"{curve.method}.cross", **style)
        to_right = x < sum(axes.get_xlim()) / 2
        axes.annotate(
            f"diverged at {curve.diverged}",
            (x, y),
            (9 if to_right else -9, 3 - 12 * slot if y == high else 0),
            textcoords="offset points",
            ha="left" if to_right else "right",
            va="top" if y == high else "center",
            fontsize=FONT_SIZE,
            bbox={"facecolor": theme.panel, "edgecolor": "none", "alpha": 0.85, "pad": 1.0},
            gid=f"{curve.method}.diverged",
            **style,
        )


def _entries(
    curves: Sequence[ErrorCurve], theme: Theme, selected: str | None, *, noisy: bool
) -> list[Entry]:
    entries = []
    for curve in curves:
        heavy = curve.method == selected
        width = _HEAVY if heavy else _THIN
        gid = f"{curve.method}.legend"
        entries.append(Entry(gid, curve.title, curve.colour, width, bold=heavy))
    if noisy:
        entries.append(Entry("noisy", NOISY_LABEL, theme.ink, 1.2, dashed=True))
    return entries
