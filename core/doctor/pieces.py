"""Connected components, and the small ones among them."""

import numpy as np

from core.doctor.spec import (
    FindingSpec,
    Found,
    Numbers,
    Repaired,
    RepairSpec,
    counted,
    rebuilt,
    unchanged,
)
from core.mesh import TriangleMesh
from core.parameters import Params, param
from core.stepwise import at_once


class SmallComponentParams(Params):
    """Which components are small."""

    share: float = param(
        0.01,
        low=0.0001,
        high=1,
        step=0.01,
        help="Components with less than this share of all faces go; more removes more. The "
        "largest always stays.",
    )


def component_sizes(mesh: TriangleMesh) -> Numbers:
    """Number of faces of each connected component; 0 for an isolated vertex."""
    owner = mesh.topology.vertex_components[mesh.faces[:, 0]]
    return np.bincount(owner, minlength=mesh.topology.component_count)


def _small(sizes: Numbers, share: float) -> Numbers:
    small = (sizes > 0) & (sizes < share * sizes.sum())
    small[sizes.argmax()] = False
    return np.flatnonzero(small)


@at_once
def _look(mesh: TriangleMesh) -> Found | None:
    sizes = component_sizes(mesh)
    pieces = sizes[sizes > 0]
    if len(pieces) < 2:
        return None
    params = SmallComponentParams()
    small = _small(sizes, params.share)
    text = f"{len(pieces):,} components of {pieces.min():,} to {pieces.max():,} faces; "
    have = "have" if len(small) > 1 else "has"
    text += f"{len(small) or 'none'} {have} less than {100 * params.share:g} % of the faces."
    rest = sizes > 0
    rest[sizes.argmax()] = False
    places = np.flatnonzero(rest[mesh.topology.vertex_components])
    return Found(len(pieces), text, places)


@at_once
def remove_small_components(mesh: TriangleMesh, params: SmallComponentParams) -> Repaired:
    """Remove the components that have less than a share of all faces; the largest stays."""
    small = _small(component_sizes(mesh), params.share)
    if not len(small):
        return unchanged(mesh)
    gone = np.isin(mesh.topology.vertex_components[mesh.faces[:, 0]], small)
    removed = f"{counted(len(small), 'component')} with {counted(int(gone.sum()), 'face')}"
    return rebuilt(mesh, mesh.faces[~gone], f"Removed {removed}.")


COMPONENTS = FindingSpec(
    id="components",
    title="Several components",
    meaning="Each is smoothed for itself. Specks of a scan spoil the view and the statistics.",
    look=_look,
    level="note",
)

REPAIR = RepairSpec(
    id="small_components",
    title="Remove small components",
    summary="Removes connected components with few faces.",
    apply=remove_small_components,
    removes=(),
    eases=(COMPONENTS,),
    params=SmallComponentParams,
    keeps_shape=False,
)
