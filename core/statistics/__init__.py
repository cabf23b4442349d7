"""Statistics of a mesh, thesis chapter 3: degrees, clustering, geodesic distances, spectra."""

from core.statistics.connectivity import Connectivity, connectivity
from core.statistics.distributions import (
    AxisLabels,
    ByDegree,
    Histogram,
    assortativity,
    clustering,
    degree_distribution,
)
from core.statistics.errors import StatisticsError
from core.statistics.geodesic import (
    GeodesicDistances,
    GeodesicParams,
    distances_from_vertex,
    geodesic_steps,
    vertex_distance_steps,
)
from core.statistics.progress import Progress, finished
from core.statistics.spectrum import Spectrum, SpectrumParams, spectrum_steps
from core.statistics.statistics import MeshStatistics, mesh_statistics, statistics_steps
from core.statistics.summary import Summary, summarise

__all__ = [
    "AxisLabels",
    "ByDegree",
    "Connectivity",
    "GeodesicDistances",
    "GeodesicParams",
    "Histogram",
    "MeshStatistics",
    "Progress",
    "Spectrum",
    "SpectrumParams",
    "StatisticsError",
    "Summary",
    "assortativity",
    "clustering",
    "connectivity",
    "degree_distribution",
    "distances_from_vertex",
    "finished",
    "geodesic_steps",
    "mesh_statistics",
    "spectrum_steps",
    "statistics_steps",
    "summarise",
    "vertex_distance_steps",
]
