"""Which vertices a bar or a point of a curve counts."""

from dataclasses import dataclass

import numpy as np

from app.export.statistics_series import Series
from core.arrays import BoolArray, FloatArray
from core.statistics import Histogram

_REACH = 0.06
_NO_VERTEX = "Click the model to pick a vertex: then a bar lights up those that far from it."


@dataclass(frozen=True)
class Spot:
    """A place in a plot.

    Attributes
    ----------
    plot : str
        Id of the plot.
    x, y : float
        Where, on the scales of the axes.
    beside : bool
        Whether it is in the histogram beside the main axes.
    """

    plot: str
    x: float
    y: float
    beside: bool = False


@dataclass(frozen=True, eq=False)
class Selection:
    """What a spot counts in one model.

    Attributes
    ----------
    vertices : (m,) bool ndarray or None
        The vertices it counts; None where it counts none.
    span : (float, float) or None
        The range of the axis that is meant, along x, or along y in the histogram beside.
    words : str
        What it is, for a person.
    """

    vertices: BoolArray | None = None
    span: tuple[float, float] | None = None
    words: str = ""


def select(spot: Spot, series: Series, distances: FloatArray | None) -> Selection:
    """Find what a spot counts.

    Parameters
    ----------
    spot : Spot
        Where the pointer is.
    series : Series
        The model.
    distances : (m,) float64 ndarray or None
        Distance of every vertex from the picked one in units of ℓ̄.
    """
    if spot.plot == "spectrum":
        return _eigenvalue(spot, series)
    if spot.plot == "geodesic":
        return _distance(spot, series, distances)
    if spot.beside:
        return _value(spot, series)
    return _degree(spot, series)


def _eigenvalue(spot: Spot, series: Series) -> Selection:
    spectrum = series.spectrum
    if spectrum is None or spot.beside or not 0 <= spot.x <= 1:
        return Selection()
    value = float(np.interp(spot.x, spectrum.ranks, spectrum.eigenvalues))
    return Selection(
        words=f"{100 * spot.x:.1f} % of the eigenvalues are above {value:.4g} "
        "(an eigenvalue belongs to all vertices together)"
    )


def _degree(spot: Spot, series: Series) -> Selection:
    k = round(spot.x)
    mask = series.connectivity.degrees == k
    if k not in series.degree:
        return Selection(mask, (k - 0.5, k + 0.5), f"no vertex has degree {k}")
    words = (
        f"degree {k}: {int(mask.sum()):,} vertices ({100 * series.degree[k]:.2g} %), "
        f"K_nn = {series.assortativity[k]:.3g}, C = {series.clustering[k]:.3g}"
    )
    return Selection(mask, (k - 0.5, k + 0.5), words)


def _value(spot: Spot, series: Series) -> Selection:
    result = series.assortativity if spot.plot == "assortativity" else series.clustering
    values = series.vertex_values(spot.plot)
    symbol = "K_nn" if spot.plot == "assortativity" else "C"
    span = _bin(result.histogram, spot.y)
    if span is None or values is None:
        return Selection()
    mask = _within(values, span)
    words = f"{symbol} from {span[0]:.3g} to {span[1]:.3g}: {int(mask.sum()):,} vertices"
    return Selection(mask, span, words)


def _distance(spot: Spot, series: Series, distances: FloatArray | None) -> Selection:
    geodesic, unit = series.geodesic, series.distance_unit
    span = _bin(geodesic.histogram if geodesic else None, spot.x * unit)
    if geodesic is None or span is None:
        return Selection()
    shown = (span[0] / unit, span[1] / unit)
    if distances is None:
        return Selection(None, shown, _NO_VERTEX)
    mask = _within(distances, span)
    words = f"{span[0]:.3g} to {span[1]:.3g} ℓ̄ from the picked vertex: {int(mask.sum()):,} vertices"
    return Selection(mask, shown, words)


def _bin(histogram: Histogram | None, value: float) -> tuple[float, float] | None:
    """Bin with something in it that is at a value or next to it: bins may be thin as a hair."""
    if histogram is None or not histogram.counts.any():
        return None
    low, high = histogram.edges[:-1], histogram.edges[1:]
    away = np.maximum(np.maximum(low - value, value - high), 0)
    away[histogram.counts == 0] = np.inf
    place = int(np.argmin(away))
    if away[place] > _REACH * (high[-1] - low[0]):
        return None
    return float(low[place]), float(high[place])


def _within(values: FloatArray, span: tuple[float, float]) -> BoolArray:
    # The last bin includes its upper end; for the others the rounding of the ends does not matter.
    mask: BoolArray = (values >= span[0]) & ((values < span[1]) | (values == values.max(initial=0)))
    mask &= values <= span[1]
    return mask
