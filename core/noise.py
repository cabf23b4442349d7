"""Gaussian noise on the vertices of a mesh, thesis eq. (3) and §2.5."""

import numpy as np

from core.mesh import TriangleMesh
from core.parameters import Params, build_params, param


class NoiseParams(Params):
    """Amount and seed of the noise."""

    sigma: float = param(
        0.02,
        low=0.0,
        high=1.0,
        step=0.01,
        unit="ℓ̄",
        help="Standard deviation of the noise on each coordinate; larger is rougher.",
    )
    seed: int = param(
        0,
        low=0,
        high=2**31 - 1,
        step=1,
        help="Start of the random numbers; the same seed gives the same noise.",
    )


def add_noise(mesh: TriangleMesh, sigma: float = 0.02, seed: int = 0) -> TriangleMesh:
    """Return the mesh with Gaussian noise on every coordinate of every vertex.

    v = u + η with η ~ N(0, (sigma·ℓ̄)²) independently on x, y and z, thesis eq. (3).

    Parameters
    ----------
    mesh : TriangleMesh
        The original.
    sigma : float
        Standard deviation in units of the mean edge length ℓ̄, 0 to 1; larger is rougher.
    seed : int
        Seed of the random numbers, at least 0.

    Returns
    -------
    TriangleMesh
        Shares the topology of `mesh`; the same seed gives the same mesh.

    Raises
    ------
    ParameterError
        If `sigma` or `seed` is outside its range.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, eq. (3) and §2.5.
    """
    params = build_params(NoiseParams, {"sigma": sigma, "seed": seed}, "noise")
    generator = np.random.default_rng(params.seed)
    noise = generator.standard_normal(mesh.vertices.shape)
    return mesh.with_vertices(mesh.vertices + params.sigma * mesh.mean_edge_length * noise)
