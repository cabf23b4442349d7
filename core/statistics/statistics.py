"""All statistics of a mesh at once, thesis chapter 3."""

from collections.abc import Iterator
from dataclasses import dataclass

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
    spectrum, normalized_spectrum : Spectrum
        Eigenvalues of L = D − A and of the normalised Laplacian.
    geodesic : GeodesicDistances
        Distribution of the geodesic distances.
    """

    summary: Summary
    connectivity: Connectivity
    degree: ByDegree
    assortativity: ByDegree
    clustering: ByDegree
    spectrum: Spectrum
    normalized_spectrum: Spectrum
    geodesic: GeodesicDistances

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
        If the mesh has no vertices, or one of the methods does not work on it.
    """
    if not len(mesh.vertices):
        raise StatisticsError("A mesh without vertices has no statistics.")
    wanted = spectrum or SpectrumParams()
    spectra: list[Spectrum] = []
    for part, matrix in enumerate(("laplacian", "normalized_laplacian")):
        steps = spectrum_steps(mesh, wanted.model_copy(update={"matrix": matrix}))
        spectra.append((yield from part_of(steps, part / 3, (part + 1) / 3)))
    distances = yield from part_of(geodesic_steps(mesh, geodesic), 2 / 3, 1.0)
    vertices = connectivity(mesh)
    yield Progress(
        MeshStatistics(
            summary=summarise(mesh),
            connectivity=vertices,
            degree=degree_distribution(vertices),
            assortativity=assortativity(vertices),
            clustering=clustering(vertices),
            spectrum=spectra[0],
            normalized_spectrum=spectra[1],
            geodesic=distances,
        ),
        1.0,
    )


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
        If the mesh has no vertices, or one of the methods does not work on it.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> statistics = mesh_statistics(primitives.icosahedron())
    >>> statistics.average_degree, dict(statistics.degree), round(statistics.clustering[5], 12)
    (5.0, {5: 1.0}, 0.5)
    """
    return finished(statistics_steps(mesh, geodesic, spectrum))
