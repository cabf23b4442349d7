"""Squared Euclidean distance to the centroid, thesis §4.4.3 and §5.3."""

import numpy as np

from core.arrays import FloatArray
from core.fields.centred import centred_vertices
from core.fields.spec import FieldSpec
from core.mesh import TriangleMesh
from core.parameters import Params


class EuclideanParams(Params):
    """The Euclidean distance has no parameters."""


def squared_norms(mesh: TriangleMesh) -> FloatArray:
    """Squared distance ‖v − c‖² of each vertex to the centroid, (m,), in squared model units."""
    centred = centred_vertices(mesh)
    norms: FloatArray = np.einsum("ix,ix->i", centred, centred)
    return norms


def evaluate(mesh: TriangleMesh, _params: EuclideanParams) -> FloatArray:
    """Squared distance d(v) = ‖v − c‖² to the centroid c of the vertices, (m,).

    Its level sets are the intersections with concentric spheres. It is invariant to rotation,
    translation and mirroring; normalised, to scaling too.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §4.4.3.
    """
    return squared_norms(mesh)


SPEC = FieldSpec(
    id="euclidean",
    title="Euclidean distance",
    params=EuclideanParams,
    evaluate=evaluate,
    summary="Squared distance to the centroid; its level sets lie on concentric spheres.",
    formula="d(v) = ‖v − c‖²",
    reference="Zhang, thesis §4.4.3",
)
