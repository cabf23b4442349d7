"""The resolution that the thesis leaves open (§5.5.4), chosen from the Reeb graph."""

from dataclasses import dataclass

from core.arrays import IntArray
from core.fields import ScalarField
from core.mesh import TriangleMesh
from core.parameters import ParameterError
from core.skeleton.bands import NO_FACES, band_components
from core.skeleton.levels import Spacing, level_rule, vertex_bands
from core.skeleton.reeb import ReebGraph, reeb_graph
from core.stepwise import Stepwise, carried_out

LARGEST_RESOLUTION = 64
"""Largest resolution that is tried."""


@dataclass(frozen=True)
class AutomaticResolution:
    """A resolution, and what it was chosen to show.

    Attributes
    ----------
    resolution : int
        The smallest resolution that shows them, or 64 if none does.
    is_complete : bool
        Whether all of them are shown.
    loops, branches : int
        Loops of the Reeb graph that are longer than `share`, and its arcs to a minimum or a
        maximum that are.
    share : float
        Shortest length that counts, as a share of the field's range.
    """

    resolution: int
    is_complete: bool
    loops: int
    branches: int
    share: float


def automatic_resolution(
    mesh: TriangleMesh,
    field: ScalarField,
    share: float = 0.05,
    spacing: Spacing = "value",
    reeb: ReebGraph | None = None,
) -> AutomaticResolution:
    """Choose the smallest resolution whose exact graph shows what is long enough to matter.

    The Reeb graph is simplified by `share`, which leaves the loops and branches longer than it.
    Then R = 1, 2, … 64 is tried on that graph: its bands must have as many loops as it has
    itself, and a level must lie between the two ends of every such branch.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh of the field.
    field : ScalarField
        A normalised field.
    share : float
        Length from 0 to 1 in the field's range; larger ignores more and gives fewer bands.
    spacing : {"value", "distance", "area"}
        How the levels are spaced.
    reeb : ReebGraph, optional
        The Reeb graph of the field, if it is there already.

    Returns
    -------
    AutomaticResolution
        The resolution, and whether it shows everything.

    Raises
    ------
    ParameterError
        If the share is not between 0 and 1 or the spacing is not allowed.
    MeshError
        If the mesh has no faces or the field belongs to another mesh.

    Notes
    -----
    Guaranteed when `is_complete`: the skeletal graph with exact bands at this resolution has at
    least `loops` loops, among them each counted one, and the ends of all counted branches lie
    in nodes of their own. With levels equally spaced in the field it is
    complete for every share from 2/64 on: a loop longer than two bands holds a whole band, in
    which its two sides are apart, and a branch longer than one band crosses a level.

    Not guaranteed: that the graph has no other loops or ends, since shorter ones show where
    they happen to straddle a level; that they all stay at larger R, since levels move; that a
    smaller R shows less by luck; and that the lengths mean sizes, since they are differences of
    the field and not of positions.
    """
    return carried_out(automatic_resolution_steps(mesh, field, share, spacing, reeb))


def automatic_resolution_steps(
    mesh: TriangleMesh,
    field: ScalarField,
    share: float = 0.05,
    spacing: Spacing = "value",
    reeb: ReebGraph | None = None,
) -> Stepwise[AutomaticResolution]:
    """Return what :func:`automatic_resolution` does; whoever iterates may stop after any step."""
    if not 0 <= share <= 1:
        raise ParameterError(f"share={share} is not allowed; use 0 to 1.")
    graph = (reeb or reeb_graph(mesh, field)).simplified(share)
    yield
    branches = _long_branches(graph, share)
    rule = level_rule(mesh, field, spacing)

    def shows_all(resolution: int) -> bool:
        bands = vertex_bands(graph.values, rule(resolution))
        apart = bands[branches[:, 0]] < bands[branches[:, 1]]
        return bool(apart.all()) and _band_loops(graph, bands) == graph.loops

    resolution, is_complete = 1, shows_all(1)
    while not is_complete and resolution < LARGEST_RESOLUTION:
        yield
        resolution += 1
        is_complete = shows_all(resolution)
    return AutomaticResolution(
        resolution=resolution,
        is_complete=is_complete,
        loops=graph.loops,
        branches=len(branches),
        share=share,
    )


def _long_branches(graph: ReebGraph, share: float) -> IntArray:
    """Arcs to a minimum or a maximum that are longer than `share`, (b, 2)."""
    is_end = (graph.down_degrees + graph.up_degrees) == 1
    arcs: IntArray = graph.arcs[is_end[graph.arcs].any(axis=1) & (graph.lengths > share)]
    return arcs


def _band_loops(graph: ReebGraph, bands: IntArray) -> int:
    """Loops that are left when the Reeb graph itself is cut into bands."""
    found = band_components(bands, graph.arcs, NO_FACES, NO_FACES)
    return len(found.arcs) - len(found.bands) + graph.components
