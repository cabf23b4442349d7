"""From errors to colours: the ends of the shared colour bar and the histogram beside it."""

from collections.abc import Sequence

import numpy as np

from app.scene.panes import Pane, shared_range
from core.arrays import FloatArray
from core.view import ViewSettings

_BINS = 48


def colour_range(view: ViewSettings, panes: Sequence[Pane]) -> tuple[float, float]:
    """Values at the ends of the colour bar, as the view wants them."""
    if view.colour_range == "manual":
        return _apart(view.colour_low, view.colour_high)
    if view.colour_range == "full":
        known = [pane.values for pane in panes if pane.values is not None]
        lows, highs = [float(v.min()) for v in known], [float(v.max()) for v in known]
        return _apart(min(lows, default=0.0), max(highs, default=1.0))
    return shared_range(list(panes))


def colour_map(view: ViewSettings) -> str:
    """Name of the colour map with its direction."""
    return view.colour_map + ("_r" if view.colour_reversed else "")


def shares_between(
    panes: Sequence[Pane], selected: str | None, ends: tuple[float, float]
) -> FloatArray:
    """Histogram of the selected pane's values, or of all panes' where it has none.

    Parameters
    ----------
    panes : sequence of Pane
        Panes with their values.
    selected : str or None
        Id of the selected pane.
    ends : (float, float)
        Ends of the histogram; values beyond them are left out.

    Returns
    -------
    (48,) float64 ndarray
        Heights of the bins from the lower end up, the highest being 1; zeros without values.
    """
    own = [p.values for p in panes if p.id == selected and p.values is not None]
    known = own or [p.values for p in panes if p.values is not None]
    values = np.concatenate(known) if known else np.zeros(0)
    counts, _ = np.histogram(values, _BINS, ends)
    shares: FloatArray = counts / max(int(counts.max()), 1)
    return shares


def _apart(low: float, high: float) -> tuple[float, float]:
    """Keep the ends of a scale in order and apart from each other."""
    return (low, high) if high > low else (low, low + max(abs(low), 1.0) * 1e-6)
