"""Small holes, and patches for them.

A patch uses the vertices of its loop alone: of all ways to cut the loop into triangles it takes
the one of the least area, with short edges among equals, by dynamic programming over
the stretches of the loop [1]_.

.. [1] G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron*, Computer Aided
   Geometric Design 12(2), 1995.
"""

import numpy as np

from core.doctor.boundary import loop_count
from core.doctor.filling import filling_steps
from core.doctor.spec import (
    FindingSpec,
    Found,
    Repaired,
    RepairSpec,
    counted,
    ends_of,
    rebuilt,
    unchanged,
)
from core.mesh import TriangleMesh
from core.parameters import Params, param
from core.stepwise import Stepwise


class FillParams(Params):
    """Which holes are small."""

    most_edges: int = param(
        30, low=3, high=200, step=1, help="Holes with at most this many edges are filled; more "
        "fills larger ones.",
    )  # fmt: skip


def _look(mesh: TriangleMesh) -> Stepwise[Found | None]:
    edges = mesh.topology.boundary_edges
    if not edges.any():
        return None
    loops, most = loop_count(mesh), FillParams().most_edges
    small = (yield from filling_steps(mesh, most)).holes
    text = f"{counted(loops, 'boundary loop')} with {counted(int(edges.sum()), 'edge')}; "
    text += f"{counted(small, 'small hole') if small else 'no small hole'} to fill."
    return Found(loops, text, ends_of(mesh, edges))


def fill_holes(mesh: TriangleMesh, params: FillParams) -> Stepwise[Repaired]:
    """Fill the small holes with triangles between the vertices of their boundary.

    A loop is left open if it has more edges than the parameter says, runs along faces that are
    not wound consistently, would need an edge that is there already, or if its patch would be
    larger than a quarter of its component.
    """
    faces, patches, holes = yield from filling_steps(mesh, params.most_edges)
    if not holes:
        return unchanged(mesh)
    change = f"Filled {counted(holes, 'hole')} with {counted(len(patches), 'face')}."
    return rebuilt(mesh, np.concatenate([faces, patches]), change)


BOUNDARY = FindingSpec(
    id="boundary",
    title="Open boundary",
    meaning="Vertices of a boundary have neighbours on one side only: smoothing draws them "
    "inwards, and the model has no genus.",
    look=_look,
    level="note",
)

REPAIR = RepairSpec(
    id="fill_holes",
    title="Fill small holes",
    summary="Closes boundary loops of few edges with flat triangles between their vertices.",
    apply=fill_holes,
    removes=(),
    eases=(BOUNDARY,),
    params=FillParams,
    keeps_shape=False,
)
