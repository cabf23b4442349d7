"""The fields: by hand, their formulas, and what leaves them unchanged."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from core.fields import FIELDS, normalise, scalar_field
from core.mesh import MeshError, TriangleMesh, primitives
from core.parameters import ParameterError

OCTAHEDRON = [
    [0, 2, 4],
    [2, 1, 4],
    [1, 3, 4],
    [3, 0, 4],
    [2, 0, 5],
    [1, 2, 5],
    [3, 1, 5],
    [0, 3, 5],
]


def octahedron(a, b, c, at=(0, 0, 0)):
    corners = np.array([[a, 0, 0], [-a, 0, 0], [0, b, 0], [0, -b, 0], [0, 0, c], [0, 0, -c]])
    return TriangleMesh(corners + np.array(at, float), OCTAHEDRON)


@cache
def blob():
    """A ball with dents, so that no two vertices have the same distance."""
    ball = primitives.sphere(2)
    x, y, z = ball.vertices.T
    return ball.with_vertices(
        ball.vertices * (1 + 0.3 * x + 0.2 * y * z + 0.1 * z)[:, None] * [3, 2, 1]
    )


def moved(mesh, matrix, shift):
    return mesh.with_vertices(mesh.vertices @ np.asarray(matrix).T + shift)


def test_euclidean_by_hand():
    field = scalar_field(octahedron(1, 2, 3, at=(10, 0, -5)), "euclidean")
    assert field.raw_range == pytest.approx((1, 9))
    assert field.values == pytest.approx([0, 0, 3 / 8, 3 / 8, 1, 1])


def test_affine_is_constant_on_every_octahedron():
    # VᵀV = 2 diag(a², b², c²) and m = 6, so each vertex has the squared affine norm 3.
    field = scalar_field(octahedron(1, 2, 3), "affine")
    assert field.raw_range[0] == pytest.approx(3)
    assert field.is_constant
    assert not field.values.any()
    assert field.notes == ("The field affine is constant on this mesh.",)


def test_height_follows_its_direction():
    mesh = octahedron(1, 2, 3, at=(4, 4, 4))
    assert scalar_field(mesh, "height").values == pytest.approx([0.5, 0.5, 0.5, 0.5, 1, 0])
    sideways = scalar_field(mesh, "height", x=-0.5, z=0)
    assert sideways.values == pytest.approx([0, 1, 0.5, 0.5, 0.5, 0.5])
    assert sideways.raw_range == pytest.approx((-1, 1))


def test_mixture_is_its_formula():
    mesh = blob()
    euclidean = FIELDS["euclidean"].evaluate(mesh, None)
    affine = FIELDS["affine"].evaluate(mesh, None)
    assert affine.mean() == pytest.approx(3)
    euclidean *= 3 / euclidean.mean()
    share = euclidean / (euclidean + affine)
    per_vertex = scalar_field(mesh, "mixture")
    expected = share * euclidean + (1 - share) * affine
    assert per_vertex.raw(per_vertex.values) == pytest.approx(expected)
    constant = scalar_field(mesh, "mixture", weight=0.25)
    assert constant.raw(constant.values) == pytest.approx(0.25 * euclidean + 0.75 * affine)


@pytest.mark.parametrize(("weight", "name"), [(0, "affine"), (1, "euclidean")])
def test_mixture_ends_in_its_parts(weight, name):
    mesh = blob()
    mixed = scalar_field(mesh, "mixture", weight=weight)
    assert mixed.values == pytest.approx(scalar_field(mesh, name).values)


def test_the_printed_mixture_depends_on_the_unit():
    mesh = blob()
    large = moved(mesh, 100 * np.eye(3), 0)
    printed = [scalar_field(m, "mixture", scale_invariant=False).values for m in (mesh, large)]
    scaled = [scalar_field(m, "mixture").values for m in (mesh, large)]
    assert np.abs(printed[0] - printed[1]).max() > 0.01
    assert np.array_equal(*scaled)


def test_flat_models_use_the_pseudo_inverse_and_say_so():
    mesh = primitives.grid(4, 3)
    for name in ("affine", "mixture"):
        field = scalar_field(mesh, name)
        assert "rank 2" in field.notes[0]
        assert np.isfinite(field.values).all()
    assert FIELDS["affine"].evaluate(mesh, None).mean() == pytest.approx(2)


def test_vertices_without_a_face_move_nothing():
    mesh = blob()
    strays = np.array([[1e3, 0, 0], [0, 0, 0]])
    more = TriangleMesh(np.concatenate([mesh.vertices, strays]), mesh.faces)
    for name in FIELDS:
        field = scalar_field(more, name)
        assert np.array_equal(field.values[:-2], scalar_field(mesh, name).values)
        assert 0 <= field.values.min() <= field.values.max() <= 1


@pytest.mark.parametrize("name", FIELDS)
def test_values_are_normalised_and_read_only(name):
    values = scalar_field(blob(), name).values
    assert (values.min(), values.max()) == (0, 1)
    with pytest.raises(ValueError, match="read-only"):
        values[0] = 0.5


angles = st.floats(-3.2, 3.2)
shifts = hnp.arrays(np.float64, 3, elements=st.floats(-10, 10))


def rotation(a, b, c):
    turn = np.eye(3)
    for angle, (i, j) in zip((a, b, c), ((0, 1), (1, 2), (0, 2)), strict=True):
        step = np.eye(3)
        step[[i, i, j, j], [i, j, i, j]] = (
            np.cos(angle),
            -np.sin(angle),
            np.sin(angle),
            np.cos(angle),
        )
        turn = turn @ step
    return turn


@settings(deadline=None, max_examples=40)
@given(angles, angles, angles, shifts, st.floats(1e-3, 1e3), st.booleans())
def test_distances_do_not_change_with_a_similarity(a, b, c, shift, scale, mirror):
    mesh = blob()
    matrix = rotation(a, b, c) @ np.diag([1, 1, -1 if mirror else 1]) * scale
    for name in ("euclidean", "affine", "mixture"):
        before = scalar_field(mesh, name).values
        assert scalar_field(moved(mesh, matrix, shift * scale), name).values == pytest.approx(
            before, abs=1e-10
        )


@settings(deadline=None, max_examples=40)
@given(hnp.arrays(np.float64, (3, 3), elements=st.floats(-1, 1)), shifts)
def test_affine_does_not_change_with_any_affine_map(matrix, shift):
    matrix = matrix + 4 * np.eye(3)
    mesh = blob()
    after = scalar_field(moved(mesh, matrix, shift), "affine").values
    assert after == pytest.approx(scalar_field(mesh, "affine").values, abs=1e-9)


def test_errors_say_what_is_allowed():
    mesh = primitives.tetrahedron()
    with pytest.raises(ParameterError, match="allowed: mixture, euclidean, affine, height"):
        scalar_field(mesh, "colour")
    with pytest.raises(ParameterError, match=r"mixture\.weight=2 is not allowed"):
        scalar_field(mesh, "mixture", weight=2)
    with pytest.raises(ParameterError, match="direction is"):
        scalar_field(mesh, "height", z=0)
    with pytest.raises(MeshError, match="at least one vertex"):
        scalar_field(TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int)), "mixture")
    with pytest.raises(MeshError, match="3 values for 4 vertices"):
        normalise(mesh, np.zeros(3))
    with pytest.raises(MeshError, match="not finite"):
        normalise(mesh, np.array([0, 1, np.nan, 2]))
