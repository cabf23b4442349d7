"""The five plots of thesis figures 3.2–3.7, for one model or two, on screen and in files."""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, FigureBase

from app.export.frame import FONT_SIZE
from app.export.plots import PLOT_SUFFIXES
from app.export.statistics_axes import (
    add_legend,
    degree_scale,
    draw_beside,
    main_axes,
    marginal_axes,
    say_refusals,
    spread_over_ranks,
)
from app.export.statistics_series import Series
from app.scene.colours import LIGHT, Theme
from core.io import SaveError
from core.statistics import AxisLabels, ByDegree, GeodesicDistances, Histogram, Spectrum
from core.whole_files import whole_file

_BINS = 40
_SMOOTH = np.array([1, 4, 6, 4, 1]) / 16


@dataclass(frozen=True)
class PlotSpec:
    """One of the plots.

    Attributes
    ----------
    id : str
        Name in code and of its files.
    title : str
        Name as a person reads it.
    draw : callable
        Draws series into a figure or a part of one, and returns the main axes.
    """

    id: str
    title: str
    draw: Callable[[FigureBase, Sequence[Series], Theme], Axes]


def save_statistics_plot(
    path: str | os.PathLike[str],
    plot: PlotSpec,
    series: Sequence[Series],
    size: tuple[float, float] = (5.0, 3.6),
) -> None:
    """Write a plot to a PNG, SVG or PDF file, dark on white; size in inches.

    Raises
    ------
    SaveError
        If the suffix is another.
    """
    figure = Figure(figsize=size, layout="constrained")
    plot.draw(figure, series, LIGHT)
    save_figure(path, figure)


def save_figure(path: str | os.PathLike[str], figure: Figure) -> None:
    """Write a figure to a PNG, SVG or PDF file; the text of SVG and PDF stays text.

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
    # No date and no random ids: the same numbers give the same file.
    metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}.get(suffix)
    with (
        mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "burnish", "pdf.fonttype": 42}),
        whole_file(file) as stream,
    ):
        figure.savefig(stream, format=suffix[1:], dpi=200, metadata=metadata)


def _draw_spectrum(figure: FigureBase, series: Sequence[Series], theme: Theme) -> Axes:
    labels = next((one.spectrum.labels for one in series if one.spectrum), None)
    axes, beside = marginal_axes(figure, labels or AxisLabels("normalised rank", ""), theme)
    axes.set_xlim(0, 1)
    for one in series:
        if one.spectrum:
            _draw_eigenvalues(axes, beside, one.spectrum, one)
    axes.set_ylim(bottom=0)
    say_refusals(axes, "spectrum", series, theme)
    add_legend(figure, series, theme)
    return axes


def _draw_eigenvalues(axes: Axes, beside: Axes, spectrum: Spectrum, one: Series) -> None:
    ranks, colour = spectrum.ranks, one.colour
    axes.plot(ranks, spectrum.eigenvalues, **one.line)
    if not spectrum.exact:
        axes.fill_between(ranks, spectrum.low, spectrum.high, color=colour, alpha=0.3, lw=0)
    draw_beside(beside, spread_over_ranks(ranks, spectrum.eigenvalues, _BINS), colour)


def _draw_degree(figure: FigureBase, series: Sequence[Series], theme: Theme) -> Axes:
    axes = main_axes(figure, _labels(series, "degree"), theme)
    width = 0.84 / max(len(series), 1)
    for place, one in enumerate(series):
        shift = (place - (len(series) - 1) / 2) * width
        axes.bar(one.degree.degrees + shift, one.degree.quantity, width, color=one.colour)
    degree_scale(axes, series)
    add_legend(figure, series, theme)
    return axes


def _draw_assortativity(figure: FigureBase, series: Sequence[Series], theme: Theme) -> Axes:
    axes, beside = marginal_axes(figure, _labels(series, "assortativity"), theme)
    for one in series:
        _draw_by_degree(axes, beside, one.assortativity, one)
        degrees = one.connectivity.degrees
        unrelated = (degrees.astype(float) ** 2).mean() / max(degrees.mean(), 1e-300)
        axes.axhline(unrelated, color=one.colour, lw=1, ls=(0, (4, 3)), alpha=0.7)
    _make_height(axes, 0.5)
    degree_scale(axes, series)
    add_legend(figure, series, theme)
    return axes


def _draw_clustering(figure: FigureBase, series: Sequence[Series], theme: Theme) -> Axes:
    axes, beside = marginal_axes(figure, _labels(series, "clustering"), theme)
    last = max((int(one.degree.degrees.max(initial=3)) for one in series), default=3)
    k = np.linspace(3, max(last, 3), 200)
    axes.plot(k, 2 / (k - 1), color=theme.ink, lw=1, ls=(0, (4, 3)), alpha=0.7)
    for one in series:
        _draw_by_degree(axes, beside, one.clustering, one)
    axes.set_ylim(0, 1.05)
    degree_scale(axes, series)
    add_legend(figure, series, theme)
    return axes


def _draw_by_degree(axes: Axes, beside: Axes, result: ByDegree, one: Series) -> None:
    axes.plot(result.degrees, result.quantity, marker="o", ms=4.5, **one.line)
    if result.histogram:
        draw_beside(beside, result.histogram, one.colour)


def _draw_geodesic(figure: FigureBase, series: Sequence[Series], theme: Theme) -> Axes:
    unit = "longest" if any(one.relative for one in series) else "ℓ̄"
    labels = AxisLabels(f"geodesic distance ({unit})", f"share of pairs per {unit}")
    axes = main_axes(figure, labels, theme)
    for one in series:
        if one.geodesic:
            _draw_distances(axes, one.geodesic, one)
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.ticklabel_format(axis="y", scilimits=(-3, 4), useMathText=True)
    axes.yaxis.get_offset_text().set(color=theme.ink, fontsize=FONT_SIZE)
    say_refusals(axes, "geodesic", series, theme)
    add_legend(figure, series, theme)
    return axes


def _draw_distances(axes: Axes, distances: GeodesicDistances, one: Series) -> None:
    histogram = Histogram(distances.histogram.edges / one.distance_unit, distances.histogram.counts)
    density = histogram.shares / np.maximum(np.diff(histogram.edges), 1e-300)
    axes.stairs(density, histogram.edges, fill=True, color=one.colour, alpha=0.4)
    smooth = np.convolve(np.pad(density, 2), _SMOOTH)[4:-4]
    axes.plot(histogram.centres, smooth, **one.line)


def _make_height(axes: Axes, least: float) -> None:
    """Keep the rounding errors of a level curve from filling the plot."""
    low, high = axes.get_ylim()
    if high - low < least:
        middle = (low + high) / 2
        axes.set_ylim(middle - least / 2, middle + least / 2)


def _labels(series: Sequence[Series], part: str) -> AxisLabels:
    labels: AxisLabels = getattr(series[0], part).labels if series else AxisLabels("degree k", "")
    return labels


PLOTS = {
    spec.id: spec
    for spec in (
        PlotSpec("spectrum", "Spectrum", _draw_spectrum),
        PlotSpec("degree", "Vertex degree", _draw_degree),
        PlotSpec("assortativity", "Assortativity", _draw_assortativity),
        PlotSpec("clustering", "Clustering", _draw_clustering),
        PlotSpec("geodesic", "Geodesic distance", _draw_geodesic),
    )
}
"""The plots (b) to (f) of the thesis' figures, in their order."""
