"""What the model panel tells about a mesh."""

import pytest

from app.ui.mesh_facts import mesh_facts
from core.mesh import TriangleMesh, primitives

TETRAHEDRON = primitives.tetrahedron()


def test_tetrahedron():
    facts = mesh_facts(TETRAHEDRON)
    assert (facts.vertices, facts.edges, facts.faces, facts.components) == (4, 6, 4, 1)
    assert (facts.genus, facts.genus_reason, facts.boundary_edges) == (0, "", 0)
    assert facts.mean_edge_length == pytest.approx(8**0.5)


def test_torus_has_genus_one():
    assert mesh_facts(primitives.torus()).genus == 1


def moebius_band():
    """Five triangles in a ring with one twist."""
    vertices = [[i, i * i, i**3] for i in range(5)]
    return TriangleMesh(vertices, [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])


def two_tetrahedra(shared):
    """Two tetrahedra that share so many vertices."""
    vertices = [*TETRAHEDRON.vertices, *(-3 - TETRAHEDRON.vertices)][: 8 - shared]
    other = [i if i < shared else i + 4 - shared for i in range(4)]
    faces = [[other[corner] for corner in face] for face in TETRAHEDRON.faces]
    return TriangleMesh(vertices, [*TETRAHEDRON.faces.tolist(), *faces])


@pytest.mark.parametrize(
    ("mesh", "reason"),
    [
        (primitives.grid(2, 2), "8 edges belong to one face only"),
        (moebius_band(), "5 edges belong to one face only"),
        (two_tetrahedra(1), "1 vertices join pieces of surface"),
        (two_tetrahedra(2), "1 edges belong to more than two faces"),
        (TriangleMesh([*TETRAHEDRON.vertices, [9, 9, 9]], TETRAHEDRON.faces), "belong to no face"),
    ],
)
def test_reason_for_having_no_genus(mesh, reason):
    facts = mesh_facts(mesh)
    assert facts.genus is None
    assert reason in facts.genus_reason
