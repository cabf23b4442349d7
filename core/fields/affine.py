"""Affine invariant squared distance to the centroid, thesis §1.3."""

import numpy as np

from core.arrays import FloatArray
from core.fields.centred import centred_vertices, surface_vertices
from core.fields.spec import FieldSpec
from core.mesh import TriangleMesh
from core.parameters import Params

# Directions in which the model is thinner than a millionth of its size count as flat.
_FLAT = 1e-12


class AffineParams(Params):
    """The affine distance has no parameters."""


def _principal_axes(mesh: TriangleMesh) -> tuple[FloatArray, FloatArray]:
    """Variances of the surface's vertices along their principal axes, and those axes.

    Only axes along which the model extends are returned, so that dividing by the variances is
    the pseudo-inverse of VᵀV/m.
    """
    points = centred_vertices(mesh)[surface_vertices(mesh)]
    variances, axes = np.linalg.eigh(points.T @ points / max(len(points), 1))
    extended = variances > _FLAT * variances.max(initial=0)
    return variances[extended], axes[:, extended]


def squared_affine_norms(mesh: TriangleMesh) -> FloatArray:
    """Squared affine norm ‖v − c‖²_A of each vertex, (m,), without unit."""
    variances, axes = _principal_axes(mesh)
    norms: FloatArray = ((centred_vertices(mesh) @ axes) ** 2 / variances).sum(axis=1)
    return norms


def flatness_notes(mesh: TriangleMesh) -> tuple[str, ...]:
    """Say when VᵀV is singular."""
    rank = len(_principal_axes(mesh)[0])
    if rank == 3:
        return ()
    return (f"VᵀV is singular (rank {rank}: the model is flat); its pseudo-inverse is used.",)


def evaluate(mesh: TriangleMesh, _params: AffineParams) -> FloatArray:
    """Squared affine distance d(v) = (v − c)ᵀ A (v − c) with A = m (VᵀV)⁻¹, (m,).

    V holds the centred vertices row by row. The level sets are the intersections with
    concentric ellipsoids. The field is invariant to every affine transformation, and its mean
    over the vertices is 3.

    Notes
    -----
    A flat model has a singular VᵀV. The pseudo-inverse takes its place, the mean is then the
    rank, and the field's notes say so.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §1.3; Nielson and Foley, "A survey
    of applications of an affine invariant norm", 1989.
    """
    return squared_affine_norms(mesh)


SPEC = FieldSpec(
    id="affine",
    title="Affine distance",
    params=AffineParams,
    evaluate=evaluate,
    summary="Affine invariant squared distance to the centroid; levels on concentric ellipsoids.",
    formula="d(v) = (v − c)ᵀ A (v − c), A = m (VᵀV)⁻¹",
    reference="Nielson and Foley 1989; Zhang, thesis §1.3",
    notes=flatness_notes,
)
