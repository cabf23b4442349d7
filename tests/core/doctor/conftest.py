"""Small meshes, each with one defect made by hand."""

import numpy as np
import pytest

from core.mesh import TriangleMesh, primitives


def with_faces(mesh, faces):
    return TriangleMesh(mesh.vertices, faces)


def needle():
    """A grid in which one edge is cut by two vertices at one place."""
    vertices = [[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
    return TriangleMesh(vertices, [[0, 1, 3], [1, 2, 3], [2, 4, 3]])


def cap():
    """Two triangles with a third, flat one between: its corner lies on their common edge."""
    vertices = [[0, 0, 0], [2, 0, 0], [1, 0, 0], [1, 1, 0], [1, -1, 0]]
    return TriangleMesh(vertices, [[0, 2, 3], [2, 1, 3], [0, 1, 2], [1, 0, 4]])


def twice():
    """A tetrahedron with its first face a second time, in other numbers and turned."""
    mesh = primitives.tetrahedron()
    return with_faces(mesh, [*mesh.faces.tolist(), mesh.faces[0, [2, 1, 0]].tolist()])


def torn():
    """A torus cut open along one ring, both sides of the cut with vertices of their own."""
    mesh = primitives.torus(12, 6)
    faces = mesh.faces.copy()
    # The ring of the first six vertices gets copies for the faces that come back to it.
    back = (faces >= 66).any(axis=1)
    faces[back] = np.where(faces[back] < 6, faces[back] + 72, faces[back])
    return TriangleMesh(np.concatenate([mesh.vertices, mesh.vertices[:6]]), faces)


def isolated():
    mesh = primitives.tetrahedron()
    return TriangleMesh([*mesh.vertices.tolist(), [9, 9, 9], [8, 8, 8]], mesh.faces)


def book():
    """Three triangles at one edge."""
    vertices = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 1, 0], [-1, -1, 0]]
    return TriangleMesh(vertices, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])


def bow_tie():
    """Two tetrahedra that touch in one vertex."""
    one = primitives.tetrahedron()
    other = np.where(one.faces == 0, 0, one.faces + 3)
    vertices = np.concatenate([one.vertices, 2 * one.vertices[0] - one.vertices[1:]])
    return TriangleMesh(vertices, np.concatenate([one.faces, other[:, ::-1]]))


def turned():
    """A sphere with three faces wound the wrong way round."""
    mesh = primitives.sphere(1)
    faces = mesh.faces.copy()
    faces[[3, 10, 40]] = faces[[3, 10, 40]][:, ::-1]
    return with_faces(mesh, faces)


def inside_out():
    mesh = primitives.sphere(1)
    return with_faces(mesh, mesh.faces[:, ::-1])


def moebius():
    """A strip of eight squares, joined with half a turn."""
    n = 8
    angle = np.pi * np.arange(n) / n
    edge = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    centre = 3 * np.stack([np.cos(2 * angle), np.sin(2 * angle)], axis=1)
    side = edge[:, :1] * centre / 3
    low = np.column_stack([centre - side, -edge[:, 1]])
    high = np.column_stack([centre + side, edge[:, 1]])
    faces = []
    for i in range(n):
        a, b = i, n + i
        c, d = (i + 1, n + i + 1) if i < n - 1 else (n, 0)
        faces += [[a, c, b], [b, c, d]]
    return TriangleMesh(np.concatenate([low, high]), faces)


def speck():
    """A sphere of 1,280 faces and a single triangle beside it."""
    mesh = primitives.sphere(3)
    m = len(mesh.vertices)
    vertices = np.concatenate([mesh.vertices, [[5, 0, 0], [6, 0, 0], [5, 1, 0]]])
    return TriangleMesh(vertices, np.concatenate([mesh.faces, [[m, m + 1, m + 2]]]))


def holed():
    """A sphere without the faces around one vertex."""
    mesh = primitives.sphere(2)
    return TriangleMesh(mesh.vertices[1:], mesh.faces[(mesh.faces != 0).all(axis=1)] - 1)


CASES = {
    make.__name__: make
    for make in (
        needle, cap, twice, torn, isolated, book, bow_tie, turned, inside_out, moebius, speck,
        holed,
    )
}  # fmt: skip


@pytest.fixture
def defective():
    """Return the mesh of a case by its name."""
    return lambda name: CASES[name]()
