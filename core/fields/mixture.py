"""Mixture of the Euclidean and the affine distance, thesis §5.3 and §5.5."""

import numpy as np

from core.arrays import FloatArray
from core.fields.affine import flatness_notes, squared_affine_norms
from core.fields.centred import surface_vertices
from core.fields.euclidean import squared_norms
from core.fields.spec import FieldSpec
from core.mesh import TriangleMesh
from core.parameters import Params, param


class MixtureParams(Params):
    """Parameters of the mixture distance."""

    weight: float | None = param(
        None,
        low=0,
        high=1,
        step=0.05,
        help="Share λ of the Euclidean distance: 0 is all affine, 1 all Euclidean. "
        "Auto: λ of each vertex, ‖p‖²/(‖p‖² + ‖p‖²_A).",
    )
    scale_invariant: bool = param(
        True,
        help="Scale ‖p‖² to the mean of ‖p‖²_A first, so that the unit of the model does not "
        "count; off is the printed form.",
    )


def evaluate(mesh: TriangleMesh, params: MixtureParams) -> FloatArray:
    """Mixture distance d(p) = λ‖p‖² + (1 − λ)‖p‖²_A with p = v − c, (m,).

    λ is a constant, or per vertex λ = ‖p‖² / (‖p‖² + ‖p‖²_A) as in §5.5.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh.
    params : MixtureParams
        `weight` is λ, None for λ per vertex; `scale_invariant` scales ‖p‖² so that its mean
        equals that of ‖p‖²_A.

    Notes
    -----
    Departure from the thesis: ‖p‖² has a unit and ‖p‖²_A has none, so the printed sum depends on
    the unit of the model although normalised. Scaled to the same mean (3; the rank for a flat
    model) the field is invariant to every similarity transform.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §5.3.1, §5.3.4 and §5.5.
    """
    euclidean, affine = squared_norms(mesh), squared_affine_norms(mesh)
    if params.scale_invariant:
        surface = surface_vertices(mesh)
        mean = euclidean[surface].mean() if len(euclidean) else 0.0
        euclidean = euclidean * (affine[surface].mean() / mean if mean > 0 else 0.0)
    total = euclidean + affine
    own = np.divide(euclidean, total, out=np.zeros_like(total), where=total > 0)
    weight = own if params.weight is None else params.weight
    mixture: FloatArray = weight * euclidean + (1 - weight) * affine
    return mixture


SPEC = FieldSpec(
    id="mixture",
    title="Mixture distance",
    params=MixtureParams,
    evaluate=evaluate,
    summary="Mixture of the Euclidean and the affine squared distance to the centroid.",
    formula="d(p) = λ‖p‖² + (1 − λ)‖p‖²_A, λ = ‖p‖² / (‖p‖² + ‖p‖²_A)",
    reference="Zhang, thesis §5.3 and §5.5",
    notes=flatness_notes,
    departure="‖p‖² is scaled to the mean of ‖p‖²_A: as printed the normalised mixture still "
    "depends on the unit of the model.",
)
