"""What a plot and the models light up for each other while the pointer is over the plot."""

from collections.abc import Mapping

import numpy as np

from app.export.statistics_selection import Selection, Spot, select
from app.ui.statistics_plot import StatisticsPlot
from app.ui.statistics_view import StatisticsView
from app.ui.statistics_work import StatisticsWork
from core.arrays import BoolArray


class StatisticsLights:
    """Lights up the vertices that a place of a plot stands for, else the picked vertex.

    Parameters
    ----------
    work : StatisticsWork
        What is known of the models.
    view : StatisticsView
        The models.
    plots : mapping of str to StatisticsPlot
        The plots by id.
    """

    def __init__(
        self, work: StatisticsWork, view: StatisticsView, plots: Mapping[str, StatisticsPlot]
    ) -> None:
        self._work, self._view, self._plots = work, view, plots
        self._pointed: Spot | None = None

    def point(self, spot: Spot | None) -> None:
        """Take the place of a plot that the pointer is over, None over none."""
        if spot is None and self._pointed is not None:
            self._plots[self._pointed.plot].mark(Selection(), beside=False)
        self._pointed = spot
        self.show()

    def show(self) -> None:
        """Light up what the pointer is over, else the picked vertex."""
        spot, work = self._pointed, self._work
        if spot is None:
            self._view.light([self._picked_mask(place) for place in range(len(work.models))])
            return
        found = [select(spot, one, work.distances(i)) for i, one in enumerate(work.series())]
        words = " | ".join(selection.words for selection in found if selection.words)
        span = next((selection.span for selection in found if selection.span), None)
        self._plots[spot.plot].mark(Selection(None, span, words), beside=spot.beside)
        self._view.light([selection.vertices for selection in found])

    def _picked_mask(self, place: int) -> BoolArray | None:
        picked = self._work.picked
        if picked is None or picked[0] != place:
            return None
        mask = np.zeros(len(self._work.models[place].mesh.vertices), np.bool_)
        mask[picked[1]] = True
        return mask
