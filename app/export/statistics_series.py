"""The statistics of one model as the plots and tables want them, whole or half computed."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.statistics import (
    ByDegree,
    Connectivity,
    GeodesicDistances,
    MeshStatistics,
    Spectrum,
    assortativity,
    clustering,
    degree_distribution,
)

SERIES_COLOURS = ("#1a80c4", "#d55e00")
"""Colours of the first model and of the one laid over it, safe for colour-blind eyes."""


@dataclass(frozen=True, eq=False)
class Series:
    """One model in the plots.

    Attributes
    ----------
    name : str
        Its label.
    colour : str
        Its colour.
    connectivity : Connectivity
        Degree, average neighbour degree and clustering of every vertex.
    degree, assortativity, clustering : ByDegree
        p_k, K_nn(k) and C(k).
    spectrum : Spectrum or None
        None while it is not there yet, or was refused.
    geodesic : GeodesicDistances or None
        None while it is not there yet, or was refused.
    relative : bool
        Whether distances are shown as shares of the longest instead of in ℓ̄.
    refusals : mapping of str to str
        Why ``spectrum`` or ``geodesic`` will not be there.
    """

    name: str
    colour: str
    connectivity: Connectivity
    degree: ByDegree
    assortativity: ByDegree
    clustering: ByDegree
    spectrum: Spectrum | None = None
    geodesic: GeodesicDistances | None = None
    relative: bool = False
    refusals: Mapping[str, str] = field(default_factory=dict)

    @property
    def line(self) -> dict[str, Any]:
        """Style of its curves: the second model's are dashed, lest they hide equal ones."""
        second = self.colour == SERIES_COLOURS[1]
        return {"color": self.colour, "lw": 1.6, "ls": (0, (5, 1.5)) if second else "-"}

    @property
    def distance_unit(self) -> float:
        """What distances are divided by for the plot, in units of ℓ̄."""
        return (self.geodesic.longest or 1.0) if self.relative and self.geodesic else 1.0

    def vertex_values(self, quantity: str) -> FloatArray | None:
        """Return degree, assortativity (K_nn) or clustering of every vertex, None for another."""
        values = {
            "degree": self.connectivity.degrees.astype(np.float64),
            "assortativity": self.connectivity.neighbour_degrees,
            "clustering": self.connectivity.clustering,
        }
        return values.get(quantity)

    @classmethod
    def of_vertices(cls, name: str, colour: str, vertices: Connectivity) -> "Series":
        """Make a series of what is there at once."""
        return cls(
            name,
            colour,
            vertices,
            degree_distribution(vertices),
            assortativity(vertices),
            clustering(vertices),
        )

    @classmethod
    def of_statistics(cls, name: str, statistics: MeshStatistics) -> "Series":
        """Make a series of everything, with the spectrum of L."""
        return cls(
            name,
            SERIES_COLOURS[0],
            statistics.connectivity,
            statistics.degree,
            statistics.assortativity,
            statistics.clustering,
            statistics.spectrum,
            statistics.geodesic,
            refusals=statistics.refusals,
        )
