"""Small meshes with known properties, for tests, examples and documentation."""

import numpy as np
from numpy.typing import NDArray

from core.mesh.remesh import midpoint_subdivision
from core.mesh.triangle_mesh import TriangleMesh


def tetrahedron() -> TriangleMesh:
    """Regular tetrahedron with edges of length √8, wound outwards: genus 0, all degrees 3."""
    vertices = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
    return TriangleMesh(vertices, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])


def icosahedron() -> TriangleMesh:
    """Regular icosahedron on the unit sphere, wound outwards: genus 0, all degrees 5."""
    golden = (1 + 5**0.5) / 2
    ring = [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)]
    vertices = [(x, y, 0.0) for x, y in ring]
    vertices += [(0.0, x, y) for x, y in ring] + [(y, 0.0, x) for x, y in ring]
    faces = [
        *[(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11)],
        *[(1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8)],
        *[(3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9)],
        *[(4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)],
    ]
    return TriangleMesh(np.array(vertices) / np.hypot(1, golden), faces)


def sphere(subdivisions: int = 2) -> TriangleMesh:
    """Unit sphere: an icosahedron whose faces are split in four `subdivisions` times."""
    mesh = icosahedron()
    for _ in range(subdivisions):
        split = midpoint_subdivision(mesh)
        mesh = split.with_vertices(
            split.vertices / np.linalg.norm(split.vertices, axis=1, keepdims=True)
        )
    return mesh


def torus(
    around: int = 24, across: int = 12, radius: float = 1.0, tube: float = 0.4
) -> TriangleMesh:
    """Torus about the z axis, wound outwards: genus 1, all degrees 6."""
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    phi, theta = 2 * np.pi * u.ravel() / around, 2 * np.pi * v.ravel() / across
    distance = radius + tube * np.cos(theta)
    vertices = np.stack(
        [distance * np.cos(phi), distance * np.sin(phi), tube * np.sin(theta)], axis=1
    )

    def number(i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.int64]:
        return (i % around * across + j % across).ravel()

    a, b = number(u, v), number(u + 1, v)
    c, d = number(u + 1, v + 1), number(u, v + 1)
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return TriangleMesh(vertices, faces)


def grid(columns: int = 4, rows: int = 4) -> TriangleMesh:
    """Flat grid of unit squares in the plane z = 0, each cut along its diagonal: one boundary."""
    y, x = np.mgrid[0 : rows + 1, 0 : columns + 1]
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    right, up = corner + 1, corner + columns + 1
    faces = np.concatenate(
        [np.stack([corner, right, up + 1], axis=1), np.stack([corner, up + 1, up], axis=1)]
    )
    return TriangleMesh(vertices, faces)
