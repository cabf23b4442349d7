"""Smoothing methods: six denoisers, each in its own file, listed here in display order."""

from core.mesh import TriangleMesh
from core.parameters import ParameterError, Params, build_params
from core.smoothing import bilateral, diffusion, laplacian, mean, median, weighted_laplacian
from core.smoothing.divergence import DivergenceError, DivergenceGuard
from core.smoothing.spec import MethodSpec

METHODS: dict[str, MethodSpec] = {
    spec.id: spec
    for spec in (
        weighted_laplacian.SPEC,
        mean.SPEC,
        median.SPEC,
        bilateral.SPEC,
        diffusion.SPEC,
        laplacian.SPEC,
    )
}
"""All smoothing methods by id, in the order in which they are shown."""

__all__ = [
    "METHODS",
    "DivergenceError",
    "DivergenceGuard",
    "MethodSpec",
    "Params",
    "method_spec",
    "smooth",
]


def method_spec(method: str) -> MethodSpec:
    """Look up a method by its id.

    Raises
    ------
    ParameterError
        If there is no such method; names all that there are.
    """
    if method not in METHODS:
        raise ParameterError(f"{method} is not a method; allowed: {', '.join(METHODS)}.")
    return METHODS[method]


def smooth(mesh: TriangleMesh, method: str, iterations: int, **params: object) -> TriangleMesh:
    """Denoise a mesh with one method.

    Parameters
    ----------
    mesh : TriangleMesh
        The noisy mesh.
    method : str
        Id of a method in :data:`METHODS`.
    iterations : int
        Number of iterations, at least 0.
    **params
        Parameters of the method; those not given take their declared defaults.

    Returns
    -------
    TriangleMesh
        The smoothed mesh, with the topology of `mesh`.

    Raises
    ------
    ParameterError
        If the method, a parameter or the number of iterations is not allowed.
    DivergenceError
        If the run leaves what :class:`DivergenceGuard` allows.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> ball = primitives.sphere(2)
    >>> smooth(ball, "laplacian", 3).vertices.max() < ball.vertices.max()
    True
    """
    if iterations < 0:
        raise ParameterError(f"iterations={iterations} is not allowed; use 0 or more.")
    spec = method_spec(method)
    along = mesh.along_surface()
    guard = DivergenceGuard(along)
    steps = spec.steps(along, build_params(spec.params, params, method))
    positions = (step for step in steps if step is not None)
    vertices = along.vertices
    for iteration in range(1, iterations + 1):
        vertices = next(positions)
        if not guard.allows(vertices):
            raise DivergenceError(iteration)
    return mesh.with_vertices(mesh.topology.ordering.vertices.outward(vertices))
