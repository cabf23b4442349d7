"""Lengths, areas and normals of shapes whose values are known."""

import numpy as np
import pytest

from core.mesh import TriangleMesh, geometry, primitives

RIGHT_TRIANGLE = TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])


def test_right_triangle_by_hand():
    assert geometry.face_areas(RIGHT_TRIANGLE).tolist() == [6]
    assert geometry.face_normals(RIGHT_TRIANGLE).tolist() == [[0, 0, 1]]
    assert geometry.edge_lengths(RIGHT_TRIANGLE).tolist() == [3, 4, 5]
    assert RIGHT_TRIANGLE.mean_edge_length == 4
    angles = np.degrees(geometry.corner_angles(RIGHT_TRIANGLE))
    assert angles[0] == pytest.approx([90, 53.1301, 36.8699], abs=1e-4)


def test_degenerate_face_has_no_normal_and_no_angle():
    flat = TriangleMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
    assert geometry.face_areas(flat).tolist() == [0]
    assert geometry.face_normals(flat).tolist() == [[0, 0, 0]]
    assert geometry.vertex_normals(flat).tolist() == [[0, 0, 0]] * 3


@pytest.mark.parametrize("weighting", ["uniform", "area", "angle"])
def test_vertex_normals_of_a_sphere_point_outwards(ball, weighting):
    normals = geometry.vertex_normals(ball, weighting)
    assert np.einsum("ix,ix->i", normals, ball.vertices).min() > 0.999


def test_weightings_differ_where_areas_and_angles_do():
    # Two faces meet at vertex 0: one three times as large, both with a right angle there.
    mesh = TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2], [0, 2, 3]])
    uniform = geometry.vertex_normals(mesh)[0]
    area = geometry.vertex_normals(mesh, "area")[0]
    angle = geometry.vertex_normals(mesh, "angle")[0]
    assert uniform == pytest.approx(np.array([1, 0, 1]) / np.sqrt(2))
    assert area == pytest.approx(np.array([1, 0, 3]) / np.sqrt(10))
    assert angle == pytest.approx(uniform)


def test_unknown_weighting_names_the_allowed_ones(ball):
    with pytest.raises(ValueError, match="uniform, area, angle"):
        geometry.vertex_normals(ball, "volume")


def test_shading_normals_are_area_weighted(ball):
    sums = geometry.shading_normals(ball.vertices, ball.faces)
    assert geometry.normalized(sums) == pytest.approx(geometry.vertex_normals(ball, "area"))


def test_volume_of_a_tetrahedron_and_of_a_fine_sphere():
    assert geometry.volume(primitives.tetrahedron()) == pytest.approx(8 / 3)
    assert geometry.volume(primitives.sphere(4)) == pytest.approx(4 * np.pi / 3, rel=0.01)
