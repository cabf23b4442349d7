"""Bilateral mesh denoising, thesis §2.3.4."""

from collections.abc import Iterator

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange, unsigned
from core.mesh import TriangleMesh
from core.parameters import Params, param
from core.smoothing.exponential import falling_exponential
from core.smoothing.normal_update import set_areas_and_normals
from core.smoothing.spec import MethodSpec


# Unit normals whose mean is no longer than this cancel; what is left of them is rounding.
_CANCELLED = 1e-9


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


@kernel
def _vertex_normal(normals: FloatArray, ring: IntArray) -> tuple[float, float, float]:
    x = y = z = 0.0
    for t in ring:
        x += normals[t, 0]
        y += normals[t, 1]
        z += normals[t, 2]
    length = np.sqrt(x * x + y * y + z * z)
    if length <= _CANCELLED * len(ring):
        return 0.0, 0.0, 0.0
    return x / length, y / length, z / length


@parallel_kernel
def _move_along_normals(
    vertices: FloatArray,
    face_normals: FloatArray,
    face_starts: IntArray,
    face_items: IntArray,
    starts: IntArray,
    items: IntArray,
    sigma_c: float,
    sigma_s: float,
) -> FloatArray:
    moved = np.empty_like(vertices)
    closeness, similarity = -0.5 / sigma_c**2, -0.5 / sigma_s**2
    for i in prange(len(vertices)):
        nx, ny, nz = _vertex_normal(face_normals, face_items[face_starts[i] : face_starts[i + 1]])
        total = offset = 0.0
        for j in items[starts[i] : starts[i + 1]]:
            dx, dy, dz = (
                vertices[j, 0] - vertices[i, 0],
                vertices[j, 1] - vertices[i, 1],
                vertices[j, 2] - vertices[i, 2],
            )
            height = nx * dx + ny * dy + nz * dz
            weight = falling_exponential(
                closeness * (dx * dx + dy * dy + dz * dz) + similarity * height * height
            )
            total += weight
            offset += weight * height
        height = offset / total if total > 0 else 0.0
        moved[i, 0] = vertices[i, 0] + height * nx
        moved[i, 1] = vertices[i, 1] + height * ny
        moved[i, 2] = vertices[i, 2] + height * nz
    return moved


@parallel_kernel
def _heights(
    vertices: FloatArray,
    face_normals: FloatArray,
    face_starts: IntArray,
    face_items: IntArray,
    starts: IntArray,
    items: IntArray,
) -> FloatArray:
    """Height ⟨nᵢ, vⱼ − vᵢ⟩ of every ring entry over the tangent plane, in the ring's order."""
    heights = np.zeros(len(items))
    for i in prange(len(vertices)):
        nx, ny, nz = _vertex_normal(face_normals, face_items[face_starts[i] : face_starts[i + 1]])
        for slot in range(starts[i], starts[i + 1]):
            j = items[slot]
            heights[slot] = (
                nx * (vertices[j, 0] - vertices[i, 0])
                + ny * (vertices[j, 1] - vertices[i, 1])
                + nz * (vertices[j, 2] - vertices[i, 2])
            )
    return heights


def automatic_widths(mesh: TriangleMesh, params: BilateralParams) -> tuple[float, float]:
    """Widths (σc, σs) in model units: those given, else ℓ̄ and the deviation of the heights."""
    unit = mesh.mean_edge_length or 1.0
    (faces,) = unsigned(mesh.faces)
    rings = unsigned(*mesh.topology.vertex_faces, *mesh.topology.vertex_ring)
    sigma_c = unit * (1.0 if params.sigma_c is None else params.sigma_c)
    if params.sigma_s is not None:
        return sigma_c, unit * params.sigma_s
    areas, normals = np.empty(len(faces)), np.empty((len(faces), 3))
    set_areas_and_normals(mesh.vertices, faces, areas, normals)
    heights = _heights(mesh.vertices, normals, *rings)
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
    sigma_c, sigma_s = automatic_widths(mesh, params)
    areas, normals = np.empty(len(faces)), np.empty((len(faces), 3))
    vertices = mesh.vertices
    while True:
        set_areas_and_normals(vertices, faces, areas, normals)
        vertices = _move_along_normals(vertices, normals, *rings, sigma_c, sigma_s)
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
