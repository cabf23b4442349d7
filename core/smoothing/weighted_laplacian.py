"""Weighted Laplacian flow, thesis eq. (6): cotangent weights, recomputed every iteration."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_parallel_kernel, parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.mesh.triangles import corner_product, triangle_vector
from core.parameters import Params, param
from core.smoothing.spec import MethodSpec


class WeightedLaplacianParams(Params):
    """Parameters of the weighted Laplacian flow."""

    clamp_negative: bool = param(
        True,
        help="Count negative weights (edges between obtuse angles) as zero; off as printed.",
    )
    step: float = param(
        1.0,
        low=0.0,
        high=1.0,
        step=0.05,
        help="Share of the way to the weighted mean of the ring; 1 as printed, smaller is gentler.",
    )


@parallel_kernel
def set_cotangents(vertices: FloatArray, faces: IntArray, cotangents: FloatArray) -> None:
    """Note the cotangent of the angle at each corner, (n, 3); 0 for a triangle without area.

    cot ∠(a, b) = ⟨a, b⟩/‖a × b‖, where the length of the cross product, twice the area of the
    triangle, is the same at all three corners.
    """
    for t in prange(len(faces)):
        i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
        x, y, z = triangle_vector(vertices, i, j, k)
        double_area = np.sqrt(x * x + y * y + z * z)
        factor = 1 / double_area if double_area > 0 else 0.0
        cotangents[t, 0] = factor * corner_product(vertices, i, j, k)
        cotangents[t, 1] = factor * corner_product(vertices, j, k, i)
        cotangents[t, 2] = factor * corner_product(vertices, k, i, j)


@parallel_kernel
def set_edge_weights(
    cotangents: FloatArray,
    starts: IntArray,
    corners: IntArray,
    clamp_negative: bool,
    weights: FloatArray,
) -> None:
    """Note the weight cot α + cot β of each edge, (e,), from the corners opposite it."""
    for e in prange(len(weights)):
        total = 0.0
        for k in range(starts[e], starts[e + 1]):
            total += cotangents[corners[k]]
        weights[e] = max(total, 0.0) if clamp_negative else total


@fused_parallel_kernel
def _move_to_weighted_mean(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    ring_edges: IntArray,
    weights: FloatArray,
    step: float,
) -> FloatArray:
    moved = np.empty_like(vertices)
    for i in prange(len(vertices)):
        x, y, z = xyz(vertices, i)
        dx = dy = dz = total = 0.0
        for k in range(starts[i], starts[i + 1]):
            (a, b, c), weight = xyz(vertices, items[k]), weights[ring_edges[k]]
            dx += weight * (a - x)
            dy += weight * (b - y)
            dz += weight * (c - z)
            total += weight
        share = step / total if total != 0 else 0.0
        moved[i, 0], moved[i, 1], moved[i, 2] = x + share * dx, y + share * dy, z + share * dz
    return moved


def steps(mesh: TriangleMesh, params: WeightedLaplacianParams) -> Iterator[FloatArray]:
    """Yield the positions after each iteration of the weighted Laplacian flow.

    vᵢ ← vᵢ + step · Σⱼ wᵢⱼ (vⱼ − vᵢ) / Σⱼ wᵢⱼ with wᵢⱼ = cot αᵢⱼ + cot βᵢⱼ, the angles opposite
    the edge, recomputed from the current positions in every iteration.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh.
    params : WeightedLaplacianParams
        `clamp_negative`: count negative weights as zero, which keeps the vertex inside its ring.
        `step`: 1 as printed; smaller is gentler.

    Yields
    ------
    (m, 3) float64 ndarray
        Positions; a vertex whose weights sum to zero stays where it is.

    Notes
    -----
    As printed (no clamping) the weights of a ring can cancel, and the quotient grows without
    bound; clamping is the departure from the thesis. A boundary edge has one angle. It commutes
    with moving, turning and scaling.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, eq. (6).
    Desbrun, Meyer, Schröder, Barr, *Implicit fairing of irregular meshes using diffusion and
    curvature flow*, SIGGRAPH 1999.
    """
    topology = mesh.topology
    (faces,) = unsigned(mesh.faces)
    edge_corners = unsigned(*topology.edge_corners)
    ring = unsigned(*topology.vertex_ring, topology.ring_edges)
    cotangents, weights = np.empty((len(faces), 3)), np.empty(len(mesh.edges))
    vertices = mesh.vertices
    while True:
        set_cotangents(vertices, faces, cotangents)
        set_edge_weights(cotangents.ravel(), *edge_corners, params.clamp_negative, weights)
        vertices = _move_to_weighted_mean(vertices, *ring, weights, params.step)
        yield vertices


SPEC = MethodSpec(
    id="weighted_laplacian",
    title="Weighted Laplacian",
    params=WeightedLaplacianParams,
    steps=steps,
    summary="Laplacian flow with cotangent weights, which keeps the sizes of the triangles.",
    formula="vᵢ ← vᵢ + step · Σⱼ wᵢⱼ (vⱼ − vᵢ) / Σⱼ wᵢⱼ,  wᵢⱼ = cot αᵢⱼ + cot βᵢⱼ",
    reference="Thesis eq. (6); Desbrun et al., SIGGRAPH 1999",
    departure="Negative weights count as zero, because as printed a ring's weights can cancel.",
)
