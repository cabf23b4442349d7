import numpy as np
import pytest

from core.mesh import TriangleMesh, geometry, primitives
from resources.models import implicit, surface

BOX = np.full(3, -1.2), np.full(3, 1.2)
BALL = implicit.ellipsoid([0, 0, 0], [1, 1, 1])


def test_contour_of_a_ball_is_a_sphere_wound_outwards():
    mesh = TriangleMesh(*surface.contour(BALL, *BOX, 0.1))
    assert mesh.genus == 0
    assert geometry.volume(mesh) == pytest.approx(4 / 3 * np.pi, rel=0.01)


def test_even_mesh_of_a_ball():
    mesh = TriangleMesh(*surface.even_mesh(BALL, BOX, 400, cell=0.1))
    assert (len(mesh.vertices), len(mesh.faces), mesh.genus) == (400, 796, 0)
    np.testing.assert_allclose(np.linalg.norm(mesh.vertices, axis=1), 1, atol=1e-6)
    assert np.degrees(geometry.corner_angles(mesh)).min() > 20
    assert geometry.edge_lengths(mesh).std() < 0.25 * mesh.mean_edge_length


def test_even_mesh_is_repeatable():
    first, second = (surface.even_mesh(BALL, BOX, 100, cell=0.2) for _ in range(2))
    np.testing.assert_array_equal(first.vertices, second.vertices)
    np.testing.assert_array_equal(first.faces, second.faces)


def test_density_draws_vertices():
    def above(points):
        return np.where(points[:, 2] > 0, 16.0, 1.0)

    mesh = surface.even_mesh(BALL, BOX, 400, cell=0.1, density=above)
    # Sixteen times the weight gives edges half as long: four vertices for one.
    share = np.mean(mesh.vertices[:, 2] > 0)
    assert share == pytest.approx(0.8, abs=0.05)


def test_vertex_areas_add_up():
    ball = primitives.sphere(2)
    areas = surface.vertex_areas(surface.Mesh(ball.vertices, ball.faces.astype(np.int64)))
    assert areas.sum() == pytest.approx(geometry.face_areas(ball).sum())


def test_refined_splits_until_edges_are_short():
    ball = primitives.icosahedron()
    mesh = surface.refined(surface.Mesh(ball.vertices, ball.faces.astype(np.int64)), 0.3)
    assert len(mesh.faces) == 20 * 16


def test_dual_of_cells_of_one_vertex_is_the_mesh_itself():
    faces = primitives.icosahedron().faces.astype(np.int64)
    dual = surface.dual(faces, np.arange(12))
    rolled = [tuple(np.roll(face, -np.argmin(face))) for face in faces]
    assert {tuple(np.roll(face, -np.argmin(face))) for face in dual} == set(rolled)


def test_dual_drops_places_that_cancel():
    """The faces 0 1 2 and 3 2 1 meet the cells a b c in opposite senses."""
    faces = np.array([[0, 1, 2], [3, 2, 1]])
    assert len(surface.dual(faces, np.array([0, 1, 2, 0]))) == 0
    assert len(surface.dual(faces, np.array([0, 1, 2, 3]))) == 2
