"""Other triangulations of the same shape: finer by subdivision, coarser by decimation."""

import numpy as np
from fast_simplification import simplify

from core.mesh.errors import MeshError
from core.mesh.triangle_mesh import TriangleMesh


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
    if not 0 < share <= 1:
        raise MeshError(f"share={share:g} is not allowed; use a number above 0 and up to 1.")
    target = max(round(share * len(mesh.faces)), 1)
    if target >= len(mesh.faces):
        return mesh
    # The compiled code writes to neither array, but takes only writeable ones.
    points, faces = simplify(mesh.vertices.copy(), mesh.faces.copy(), target_count=target)
    whole = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    used, numbers = np.unique(faces[whole], return_inverse=True)
    return TriangleMesh(points[used], numbers.reshape(-1, 3))
