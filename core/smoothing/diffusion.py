"""Vertex-based anisotropic diffusion, the thesis' proposed method, eq. (7)–(11)."""

from collections.abc import Iterator
from typing import Literal

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import fused_parallel_kernel, prange, unsigned
from core.lanes import xyz
from core.mesh import TriangleMesh
from core.mesh.gradient import (
    CAUCHY_CONSTANT,
    inverse_roots,
    printed_cauchy_weights,
    set_cauchy_weights,
)
from core.parameters import Params, param
from core.smoothing.spec import MethodSpec


class DiffusionParams(Params):
    """Parameters of the vertex-based diffusion."""

    gradient_scale: float = param(
        50.0,
        low=0.01,
        high=10_000.0,
        step=1.0,
        logarithmic=True,
        help="Mean edge length κ that gradients are measured in; larger smooths less. "
        "50 suits noise of 0.02 ℓ̄, 14–20 suits 0.1 ℓ̄, 10–14 suits 0.2 ℓ̄.",
    )
    c: float = param(
        CAUCHY_CONSTANT,
        low=1e-3,
        high=1e3,
        step=0.1,
        help="Cauchy constant: gradients above it count as features; larger smooths more.",
    )
    form: Literal["invariant", "printed"] = param(
        "invariant",
        help="invariant: does not depend on where the origin is; printed: eq. (9)–(11) as they "
        "stand, which can diverge.",
    )
    raw_units: bool = param(
        False,
        help="Only for the printed form: the file's own units and origin, without gradient scale.",
    )


@fused_parallel_kernel
def _diffuse(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    roots: FloatArray,
    weights: FloatArray,
) -> FloatArray:
    """One step of the invariant form; `roots` are the 1/√dᵢ."""
    moved = np.empty_like(vertices)
    for i in prange(len(vertices)):
        (x, y, z), g, root = xyz(vertices, i), weights[i], roots[i]
        dx = dy = dz = 0.0
        for k in range(starts[i], starts[i + 1]):
            j = items[k]
            (a, b, c), weight = xyz(vertices, j), roots[j] * (g + weights[j])
            dx += weight * (a - x)
            dy += weight * (b - y)
            dz += weight * (c - z)
        moved[i, 0], moved[i, 1], moved[i, 2] = x + root * dx, y + root * dy, z + root * dz
    return moved


@fused_parallel_kernel
def _diffuse_as_printed(
    vertices: FloatArray,
    starts: IntArray,
    items: IntArray,
    roots: FloatArray,
    weights: FloatArray,
) -> FloatArray:
    """One step of eq. (9) as it stands; `roots` are the 1/√dᵢ."""
    moved = np.empty_like(vertices)
    for i in prange(len(vertices)):
        (x, y, z), g, root = xyz(vertices, i), weights[i], roots[i]
        dx = dy = dz = 0.0
        for k in range(starts[i], starts[i + 1]):
            j = items[k]
            (a, b, c), weight, other = xyz(vertices, j), g + weights[j], roots[j]
            dx += weight * (other * a - root * x)
            dy += weight * (other * b - root * y)
            dz += weight * (other * c - root * z)
        moved[i, 0], moved[i, 1], moved[i, 2] = x + root * dx, y + root * dy, z + root * dz
    return moved


def _frame(mesh: TriangleMesh, params: DiffusionParams) -> tuple[FloatArray, float]:
    """Origin (3,) and factor of the coordinates of the printed form."""
    if params.raw_units:
        return np.zeros(3), 1.0
    unit = mesh.mean_edge_length or 1.0
    return mesh.vertices.mean(axis=0), params.gradient_scale / unit


def steps(mesh: TriangleMesh, params: DiffusionParams) -> Iterator[FloatArray]:
    """Yield the positions after each iteration of the vertex-based diffusion.

    vᵢ ← vᵢ + Σⱼ (vⱼ − vᵢ)/√(dᵢdⱼ) · (g(|∇vᵢ|) + g(|∇vⱼ|)) with g(x) = 1/(1 + x²/c²) and
    |∇vᵢ|² = Σⱼ ‖vⱼ − vᵢ‖²/dᵢ, lengths scaled so that ℓ̄ of the noisy mesh is `gradient_scale`.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh.
    params : DiffusionParams
        `gradient_scale` κ: larger smooths less. `c`: larger smooths more; only c/κ matters to the
        invariant form. `form="printed"` takes eq. (9)–(11) as they stand: terms vⱼ/√dⱼ − vᵢ/√dᵢ,
        about the centroid and scaled by κ, or with `raw_units` in the file's units and origin.

    Yields
    ------
    (m, 3) float64 ndarray
        Positions; a vertex without neighbours stays where it is.

    Notes
    -----
    Departure from the thesis: as printed, one step is v − 2𝓛v where gradients are small, which
    amplifies every mode with an eigenvalue above 1, and where neighbouring degrees differ the
    term contains the position itself. Both forms agree where all degrees are equal. Edges of
    faces without area still make neighbours. The invariant form commutes with moving, turning and
    scaling; the printed form in raw units with turning about the origin only.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, §2.4, eq. (7)–(11).
    Zhang, Ben Hamza, *Vertex-based diffusion for 3-D mesh denoising*, IEEE TIP 2007.
    """
    if params.form == "printed":
        yield from _printed_steps(mesh, params)
    ring = unsigned(*mesh.topology.vertex_ring)
    roots = inverse_roots(mesh.degrees)
    scale = params.gradient_scale / (mesh.mean_edge_length or 1.0)
    weights = np.empty(len(mesh.vertices))
    vertices = mesh.vertices
    while True:
        set_cauchy_weights(vertices, *ring, scale, params.c, weights)
        vertices = _diffuse(vertices, *ring, roots, weights)
        yield vertices


def _printed_steps(mesh: TriangleMesh, params: DiffusionParams) -> Iterator[FloatArray]:
    ring = unsigned(*mesh.topology.vertex_ring)
    roots = inverse_roots(mesh.degrees)
    origin, scale = _frame(mesh, params)
    vertices = mesh.vertices - origin
    while True:
        weights = printed_cauchy_weights(vertices, *ring, roots, scale, params.c)
        vertices = _diffuse_as_printed(vertices, *ring, roots, weights)
        yield vertices + origin


SPEC = MethodSpec(
    id="diffusion",
    title="Vertex diffusion",
    params=DiffusionParams,
    steps=steps,
    summary="The thesis' method: diffusion that slows down where the surface has features.",
    formula="vᵢ ← vᵢ + Σⱼ (vⱼ − vᵢ)/√(dᵢdⱼ) · (g(|∇vᵢ|) + g(|∇vⱼ|)),  g(x) = 1/(1 + x²/c²)",
    reference="Thesis §2.4, eq. (7)–(11); Zhang, Ben Hamza, IEEE TIP 2007",
    departure="The default form is independent of origin and units; as printed it diverges on "
    "many models.",
)
