"""All statistics of a mesh at once, thesis chapter 3."""

from collections.abc import Generator, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from core.mesh import TriangleMesh
from core.statistics.connectivity import Connectivity, connectivity
from core.statistics.distributions import (
    ByDegree,
    assortativity,
    clustering,
    degree_distribution,
)
from core.statistics.errors import StatisticsError
from core.statistics.geodesic import GeodesicDistances, GeodesicParams, geodesic_steps
from core.statistics.progress import Progress, finished, part_of
from core.statistics.spectrum import Spectrum, SpectrumParams, spectrum_steps
from core.statistics.summary import Summary, summarise


@dataclass(frozen=True, eq=False)
class MeshStatistics:
    """What chapter 3 of the thesis says of a mesh.

    Attributes
    ----------
    summary : Summary
        Counts and measures.
    connectivity : Connectivity
        Degree, average neighbour degree and clustering of every vertex.
    degree, assortativity, clustering : ByDegree
        p_k, K_nn(k) and C(k), read like dictionaries from degree to value.
    spectrum, normalized_spectrum : Spectrum or None
        Eigenvalues of L = D − A and of the normalised Laplacian; None where refused.
    geodesic : GeodesicDistances or None
        Distribution of the geodesic distances; None where refused.
    refusals : mapping of str to str
        Why a part is None: a sentence, by the name of the part.
    """

    summary: Summary
    connectivity: Connectivity
    degree: ByDegree
    assortativity: ByDegree
    clustering: ByDegree
    spectrum: Spectrum | None
    normalized_spectrum: Spectrum | None
    geodesic: GeodesicDistances | None
    refusals: Mapping[str, str]

    @property
    def vertices(self) -> int:
        """Number m of vertices."""
        return self.summary.vertices

    @property
    def edges(self) -> int:
        """Number of edges."""
        return self.summary.edges

    @property
    def average_degree(self) -> float:
        """Average vertex degree d̄ = 2|ℰ|/m, thesis ch. 3 eq. (1)."""
        return self.summary.average_degree


def statistics_steps(
    mesh: TriangleMesh,
    geodesic: GeodesicParams | None = None,
    spectrum: SpectrumParams | None = None,
) -> Iterator[Progress[MeshStatistics]]:
    """Compute all statistics of a mesh, step by step, so that whoever iterates may stop.

    A spectrum or distances that a method refuses on this mesh leave the rest as it is.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh with a vertex.
    geodesic : GeodesicParams, optional
        How geodesic distances are measured.
    spectrum : SpectrumParams, optional
        Accuracy of the spectra; both matrices are taken whatever it names.

    Yields
    ------
    Progress of MeshStatistics
        Without a value until the end.

    Raises
    ------
    StatisticsError
        If the mesh has no vertices.
    """
    if not len(mesh.vertices):
        raise StatisticsError("A mesh without vertices has no statistics.")
    wanted = spectrum or SpectrumParams()
    plain = wanted.model_copy(update={"matrix": "laplacian"})
    normalized = wanted.model_copy(update={"matrix": "normalized_laplacian"})
    parts: dict[str, Iterator[Progress[Any]]] = {
        "spectrum": spectrum_steps(mesh, plain),
        "normalized_spectrum": spectrum_steps(mesh, normalized),
        "geodesic": geodesic_steps(mesh, geodesic),
    }
    found, refused = yield from _found(parts)
    vertices = connectivity(mesh)
    yield Progress(
        MeshStatistics(
            summary=summarise(mesh),
            connectivity=vertices,
            degree=degree_distribution(vertices),
            assortativity=assortativity(vertices),
            clustering=clustering(vertices),
            **found,
            refusals=MappingProxyType(refused),
        ),
        1.0,
    )


def _found(
    parts: Mapping[str, Iterator[Progress[Any]]],
) -> Generator[Progress[Any], None, tuple[dict[str, Any], dict[str, str]]]:
    """Carry out one part after another; return the results, and why there are none of some."""
    found: dict[str, Any] = {}
    refused: dict[str, str] = {}
    for place, (name, steps) in enumerate(parts.items()):
        try:
            found[name] = yield from part_of(steps, place / len(parts), (place + 1) / len(parts))
        except StatisticsError as error:
            found[name], refused[name] = None, str(error)
    return found, refused


def mesh_statistics(
    mesh: TriangleMesh,
    geodesic: GeodesicParams | None = None,
    spectrum: SpectrumParams | None = None,
) -> MeshStatistics:
    """Compute all statistics of a mesh, thesis chapter 3; :func:`statistics_steps` at once.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh with a vertex: closed or not, manifold or not, connected or not.
    geodesic : GeodesicParams, optional
        How geodesic distances are measured; the thesis' way if not given.
    spectrum : SpectrumParams, optional
        Accuracy of the spectra.

    Returns
    -------
    MeshStatistics
        Frozen numbers with the labels of their plots.

    Raises
    ------
    StatisticsError
        If the mesh has no vertices.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> statistics = mesh_statistics(primitives.icosahedron())
    >>> statistics.average_degree, dict(statistics.degree), round(statistics.clustering[5], 12)
    (5.0, {5: 1.0}, 0.5)
    """
    return finished(statistics_steps(mesh, geodesic, spectrum))
