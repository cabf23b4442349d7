"""Plain Laplacian flow, thesis eq. (4): every vertex moves to the mean of its ring."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.parameters import Params, param
from core.smoothing.spec import MethodSpec


class LaplacianParams(Params):
    """Parameters of the Laplacian flow."""

    step: float = param(
        1.0,
        low=0.0,
        high=1.0,
        step=0.05,
        help="Share of the way to the mean of the ring; 1 as printed, smaller is gentler.",
    )


@fused_parallel_kernel
def _move_to_ring_mean(
    vertices: FloatArray, starts: IntArray, items: IntArray, step: float
) -> FloatArray:
    moved = np.empty_like(vertices)
    for i in prange(len(vertices)):
        x, y, z = xyz(vertices, i)
        dx = dy = dz = 0.0
        for k in range(starts[i], starts[i + 1]):
            a, b, c = xyz(vertices, items[k])
            dx, dy, dz = dx + (a - x), dy + (b - y), dz + (c - z)
        share = step / max(starts[i + 1] - starts[i], 1)
        moved[i, 0], moved[i, 1], moved[i, 2] = x + share * dx, y + share * dy, z + share * dz
    return moved


def steps(mesh: TriangleMesh, params: LaplacianParams) -> Iterator[FloatArray]:
    """Yield the positions after each iteration of the Laplacian flow.

    vᵢ ← vᵢ + step · Σⱼ (vⱼ − vᵢ)/dᵢ over the ring vᵢ*.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh.
    params : LaplacianParams
        `step`: 1 as printed; smaller is gentler.

    Yields
    ------
    (m, 3) float64 ndarray
        Positions; a vertex without neighbours stays where it is.

    Notes
    -----
    Shrinks the model and evens out the edge lengths. Edges of faces without area still make
    neighbours. It commutes with moving, turning and scaling.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, eq. (4).
    Taubin, *A signal processing approach to fair surface design*, SIGGRAPH 1995.
    """
    starts, items = unsigned(*mesh.topology.vertex_ring)
    vertices = mesh.vertices
    while True:
        vertices = _move_to_ring_mean(vertices, starts, items, params.step)
        yield vertices


SPEC = MethodSpec(
    id="laplacian",
    title="Laplacian flow",
    params=LaplacianParams,
    steps=steps,
    summary="Moves every vertex to the mean of its neighbours; the baseline, which shrinks.",
    formula="vᵢ ← vᵢ + step · Σⱼ (vⱼ − vᵢ) / dᵢ",
    reference="Thesis eq. (4); Taubin, SIGGRAPH 1995",
)
