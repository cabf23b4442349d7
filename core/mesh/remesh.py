"""Other triangulations of the same shape: finer by subdivision, coarser by decimation."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from core.apart import run_apart
from core.arrays import FloatArray
from core.mesh.errors import MeshError
from core.mesh.quadrics import Collapsed, collapse_steps
from core.mesh.triangle_mesh import TriangleMesh
from core.stepwise import Stepwise, carried_out

# Measured: a collapse goes through the faces of its vertex, so k faces there cost k².
_SECONDS_A_FACE, _SECONDS_A_PAIR = 2.5e-6, 7e-10
# Starting a process takes about as long.
_LONG = 0.25


def midpoint_subdivision(mesh: TriangleMesh) -> TriangleMesh:
    """Split each face in four at the midpoints of its edges; the old vertices come first."""
    midpoints = mesh.vertices[mesh.edges].mean(axis=1)
    a, b, c = mesh.faces.T
    ab, bc, ca = (mesh.topology.face_edges + len(mesh.vertices)).T
    corners = [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    faces = np.concatenate([np.stack(corner, axis=1) for corner in corners])
    return TriangleMesh(np.concatenate([mesh.vertices, midpoints]), faces)


def barycentric_subdivision(mesh: TriangleMesh) -> TriangleMesh:
    """Split each face in six at its centroid and the midpoints of its edges, thesis figure 1.9.

    The old vertices come first, then the midpoints, then the centroids. Every new midpoint has
    degree 4, every centroid degree 6, and the degree of an old vertex doubles if it is inside.
    """
    midpoints = mesh.vertices[mesh.edges].mean(axis=1)
    centroids = mesh.vertices[mesh.faces].mean(axis=1)
    a, b, c = mesh.faces.T
    ab, bc, ca = (mesh.topology.face_edges + len(mesh.vertices)).T
    centre = np.arange(len(mesh.faces)) + len(mesh.vertices) + len(midpoints)
    around = [(a, ab), (ab, b), (b, bc), (bc, c), (c, ca), (ca, a)]
    faces = np.concatenate([np.stack([*pair, centre], axis=1) for pair in around])
    return TriangleMesh(np.concatenate([mesh.vertices, midpoints, centroids]), faces)


def decimated(mesh: TriangleMesh, share: float = 0.5) -> TriangleMesh:
    """Collapse edges, the least noticeable first, until a share of the faces is left.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh; its vertices are renumbered.
    share : float
        Share of the faces to keep, above 0 and at most 1; smaller is coarser.

    Returns
    -------
    TriangleMesh
        With about ``share`` of the faces: collapses that would fold the surface are left out.

    Raises
    ------
    MeshError
        If `share` is not allowed.

    References
    ----------
    Garland and Heckbert, *Surface simplification using quadric error metrics*, 1997.
    """
    return carried_out(decimation_steps(mesh, share))


def decimation_steps(mesh: TriangleMesh, share: float = 0.5) -> Stepwise[TriangleMesh]:
    """Return what :func:`decimated` does; whoever iterates may stop after any step.

    What takes long is done in another process, which then ends.
    """
    if not 0 < share <= 1:
        raise MeshError(f"share={share:g} is not allowed; use a number above 0 and up to 1.")
    target = max(round(share * len(mesh.faces)), 1)
    if target >= len(mesh.faces):
        return mesh
    collapsed = None
    for found in _collapsed(mesh, target):
        collapsed = found or collapsed
        yield
    assert collapsed is not None
    return _without_gaps(*collapsed)


def _collapsed(mesh: TriangleMesh, target: int) -> Iterator[Collapsed | None]:
    work = mesh.vertices, mesh.faces, target
    is_long = _seconds(mesh) > _LONG
    return run_apart(collapse_steps, *work) if is_long else collapse_steps(*work)


def _seconds(mesh: TriangleMesh) -> float:
    """Estimate how long decimation takes."""
    pairs = np.sum(mesh.topology.vertex_faces.lengths.astype(np.float64) ** 2)
    return _SECONDS_A_FACE * len(mesh.faces) + _SECONDS_A_PAIR * float(pairs)


def _without_gaps(vertices: FloatArray, faces: NDArray[np.signedinteger]) -> TriangleMesh:
    """Leave out collapsed faces, and vertices that no face names."""
    whole = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    used, numbers = np.unique(faces[whole], return_inverse=True)
    return TriangleMesh(vertices[used], numbers.reshape(-1, 3))
