"""Bilateral mesh denoising, thesis §2.3.4."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import ONE, fused_kernel, fused_parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.parameters import Params, param
from core.smoothing.exponential import falling_exponential
from core.smoothing.normal_update import set_normals
from core.smoothing.spec import MethodSpec

# Unit normals whose mean is no longer than this cancel; what is left of them is rounding.
_CANCELLED = 1e-9
# Vertices whose rings are weighed at once: enough for vector instructions, few enough to stay near.
_BLOCK = 256


class BilateralParams(Params):
    """Parameters of bilateral denoising."""

    sigma_c: float | None = param(
        None,
        low=1e-6,
        high=100.0,
        step=0.1,
        unit="ℓ̄",
        help="Width of the closeness weight; larger counts distant neighbours more. Auto: 1 ℓ̄.",
    )
    sigma_s: float | None = param(
        None,
        low=1e-6,
        high=100.0,
        step=0.01,
        unit="ℓ̄",
        help="Width of the height weight; larger smooths over features. "
        "Auto: standard deviation of the heights.",
    )


@fused_kernel
def _set_vertex_normals(
    face_normals: FloatArray,
    starts: IntArray,
    items: IntArray,
    first: int,
    last: int,
    normals: FloatArray,
) -> None:
    """Note the unit mean of the face normals around the vertices from first to last."""
    for i in range(np.uint64(first), np.uint64(last)):
        x = y = z = 0.0
        for k in range(starts[i], starts[i + ONE]):
            a, b, c = xyz(face_normals, items[k])
            x, y, z = x + a, y + b, z + c
        length = np.sqrt(x * x + y * y + z * z)
        factor = 1 / length if length > _CANCELLED * (starts[i + ONE] - starts[i]) else 0.0
        normals[i, 0], normals[i, 1], normals[i, 2] = factor * x, factor * y, factor * z


@fused_kernel
def _measure_rings(
    vertices: FloatArray,
    normals: FloatArray,
    starts: IntArray,
    items: IntArray,
    first: int,
    last: int,
    heights: FloatArray,
    squares: FloatArray,
) -> np.uint64:
    """Note ⟨nᵢ, vⱼ − vᵢ⟩ and ‖vⱼ − vᵢ‖², ring after ring from first to last; returns how many."""
    slot = np.uint64(0)
    for i in range(np.uint64(first), np.uint64(last)):
        (x, y, z), (nx, ny, nz) = xyz(vertices, i), xyz(normals, i)
        for k in range(starts[i], starts[i + ONE]):
            a, b, c = xyz(vertices, items[k])
            dx, dy, dz = a - x, b - y, c - z
            heights[slot] = nx * dx + ny * dy + nz * dz
            squares[slot] = dx * dx + dy * dy + dz * dz
            slot += ONE
    return slot


@fused_kernel
def _set_weights(
    heights: FloatArray, squares: FloatArray, sigma_c: float, sigma_s: float, weights: FloatArray
) -> None:
    """Note w⁽ᶜ⁾ w⁽ˢ⁾ of each ring entry."""
    closeness, similarity = -0.5 / sigma_c**2, -0.5 / sigma_s**2
    for slot in range(len(heights)):
        height = heights[slot]
        weights[slot] = falling_exponential(
            closeness * squares[slot] + similarity * height * height
        )


@fused_parallel_kernel
def _move_along_normals(
    vertices: FloatArray,
    face_normals: FloatArray,
    face_starts: IntArray,
    face_items: IntArray,
    starts: IntArray,
    items: IntArray,
    longest: int,
    sigma_c: float,
    sigma_s: float,
    normals: FloatArray,
) -> FloatArray:
    """One step; no block of vertices has more than `longest` ring entries."""
    moved = np.empty_like(vertices)
    for block in prange((len(vertices) + _BLOCK - 1) // _BLOCK):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, len(vertices))
        heights, squares, weights = np.empty(longest), np.empty(longest), np.empty(longest)
        _set_vertex_normals(face_normals, face_starts, face_items, first, last, normals)
        count = _measure_rings(vertices, normals, starts, items, first, last, heights, squares)
        _set_weights(heights[:count], squares, sigma_c, sigma_s, weights)
        slot = np.uint64(0)
        for i in range(np.uint64(first), np.uint64(last)):
            total = offset = 0.0
            for _ in range(starts[i + ONE] - starts[i]):
                total += weights[slot]
                offset += weights[slot] * heights[slot]
                slot += ONE
            height = offset / total if total > 0 else 0.0
            (x, y, z), (nx, ny, nz) = xyz(vertices, i), xyz(normals, i)
            moved[i, 0], moved[i, 1], moved[i, 2] = (
                x + height * nx,
                y + height * ny,
                z + height * nz,
            )
    return moved


def _heights(mesh: TriangleMesh) -> FloatArray:
    """Height ⟨nᵢ, vⱼ − vᵢ⟩ of every ring entry over the tangent plane, in the ring's order."""
    n, m, ring = len(mesh.faces), len(mesh.vertices), mesh.topology.vertex_ring
    face_normals, normals = np.empty((n, 3)), np.empty((m, 3))
    heights, squares = np.empty(len(ring.items)), np.empty(len(ring.items))
    set_normals(mesh.vertices, *unsigned(mesh.faces), face_normals)
    _set_vertex_normals(face_normals, *unsigned(*mesh.topology.vertex_faces), 0, m, normals)
    _measure_rings(mesh.vertices, normals, *unsigned(*ring), 0, m, heights, squares)
    return heights


def automatic_widths(mesh: TriangleMesh, params: BilateralParams) -> tuple[float, float]:
    """Widths (σc, σs) in model units: those given, else ℓ̄ and the deviation of the heights."""
    unit = mesh.mean_edge_length or 1.0
    sigma_c = unit * (1.0 if params.sigma_c is None else params.sigma_c)
    if params.sigma_s is not None:
        return sigma_c, unit * params.sigma_s
    heights = _heights(mesh)
    spread = float(heights.std()) if len(heights) else 0.0
    # A flat model has no heights; any positive width then leaves it as it is.
    return sigma_c, max(spread, 1e-9 * unit)


def steps(mesh: TriangleMesh, params: BilateralParams) -> Iterator[FloatArray]:
    """Yield the positions after each iteration of bilateral denoising.

    vᵢ ← vᵢ + nᵢ Σⱼ w⁽ᶜ⁾ᵢⱼ w⁽ˢ⁾ᵢⱼ hᵢⱼ / Σⱼ w⁽ᶜ⁾ᵢⱼ w⁽ˢ⁾ᵢⱼ with the height hᵢⱼ = ⟨nᵢ, vⱼ − vᵢ⟩,
    w⁽ᶜ⁾ = exp(−‖vᵢ − vⱼ‖²/2σc²) and w⁽ˢ⁾ = exp(−hᵢⱼ²/2σs²), nᵢ the unit mean of the face normals.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh, consistently wound; which side the normals point to does not matter.
    params : BilateralParams
        `sigma_c`, `sigma_s` in units of ℓ̄: larger counts more distant neighbours, and smooths
        over higher features. None takes ℓ̄, and the standard deviation of all heights of the
        noisy mesh; both stay the same over the iterations.

    Yields
    ------
    (m, 3) float64 ndarray
        Positions; a vertex without neighbours or without a normal stays where it is.

    Notes
    -----
    The thesis prints ⟨nᵢ, vᵢ − vⱼ⟩, which with outward normals moves a vertex away from its
    neighbours and diverges; the sign here is that of the source. A vertex has no normal where
    those of its faces cancel, ‖mean‖ ≤ 10⁻⁹. Mixed winding acts like a fold. It commutes with
    moving, turning and scaling.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.3.4.
    Fleishman, Drori, Cohen-Or, *Bilateral mesh denoising*, SIGGRAPH 2003.
    """
    (faces,) = unsigned(mesh.faces)
    rings = unsigned(*mesh.topology.vertex_faces, *mesh.topology.vertex_ring)
    starts = mesh.topology.vertex_ring.starts
    longest = int(np.diff(starts[::_BLOCK], append=starts[-1]).max())
    widths = automatic_widths(mesh, params)
    n, m = len(faces), len(mesh.vertices)
    face_normals, normals = np.empty((n, 3)), np.empty((m, 3))
    vertices = mesh.vertices
    while True:
        set_normals(vertices, faces, face_normals)
        vertices = _move_along_normals(vertices, face_normals, *rings, longest, *widths, normals)
        yield vertices


SPEC = MethodSpec(
    id="bilateral",
    title="Bilateral",
    params=BilateralParams,
    steps=steps,
    summary="Moves each vertex along its normal by a mean height that ignores high neighbours.",
    formula="vᵢ ← vᵢ + nᵢ Σⱼ wᶜᵢⱼ wˢᵢⱼ ⟨nᵢ, vⱼ − vᵢ⟩ / Σⱼ wᶜᵢⱼ wˢᵢⱼ",
    reference="Thesis §2.3.4; Fleishman, Drori, Cohen-Or, SIGGRAPH 2003",
    departure="The sign of the height is turned round: as printed the flow diverges.",
)
