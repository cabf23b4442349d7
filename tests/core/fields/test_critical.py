"""Critical vertices: by hand, and their number against the Euler characteristic."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.fields import critical_vertices, scalar_field
from core.mesh import TriangleMesh, primitives


def fan(heights):
    """A vertex of value 0 with a ring of the given values around it."""
    count = len(heights)
    turns = np.arange(count) * 2 * np.pi / count
    ring = np.stack([np.cos(turns), np.sin(turns), np.zeros(count)], axis=1)
    faces = [[0, 1 + i, 1 + (i + 1) % count] for i in range(count)]
    return TriangleMesh(np.vstack([[0, 0, 0], ring]), faces), np.array([0, *heights], float)


MESHES = {
    "ball": primitives.sphere(1),
    "torus": primitives.torus(8, 5),
    "grid": primitives.grid(5, 4),
    "pinched": TriangleMesh(np.eye(5, 3), [[0, 1, 2], [0, 3, 4]]),
    "book": TriangleMesh(np.eye(5, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]]),
}


def balance(found):
    return len(found.minima) - found.multiplicity.sum() + len(found.maxima)


def test_tetrahedron_has_one_minimum_and_one_maximum():
    found = critical_vertices(primitives.tetrahedron(), np.array([3.0, 1, 4, 2]))
    assert (found.minima, found.maxima) == (1, 2)
    assert len(found.saddles) == 0


def test_a_torus_on_its_side_has_two_saddles():
    mesh = primitives.torus()
    found = critical_vertices(mesh, scalar_field(mesh, "height", x=1, y=0.01, z=0.001).values)
    assert (len(found.minima), len(found.saddles), len(found.maxima)) == (1, 2, 1)
    assert found.multiplicity.tolist() == [1, 1]


@pytest.mark.parametrize("folds", [1, 2, 3, 4])
def test_a_saddle_counts_its_valleys_less_one(folds):
    mesh, values = fan([-1, 1] * folds)
    found = critical_vertices(mesh, values)
    assert found.index[0] == 1 - folds
    assert found.saddles.tolist() == ([0] if folds > 1 else [])


def test_equal_values_are_ordered_by_number():
    found = critical_vertices(primitives.tetrahedron(), np.zeros(4))
    assert (found.minima, found.maxima) == (0, 3)


def test_a_boundary_maximum_counts_nothing():
    mesh = primitives.grid(3, 3)
    found = critical_vertices(mesh, mesh.vertices[:, 0] + 0.1 * mesh.vertices[:, 1])
    assert len(found.minima) == len(found.maxima) == 1
    assert found.index[found.minima] == 1
    assert found.index[found.maxima] == 0
    assert found.index_sum == mesh.euler_characteristic == 1


@settings(deadline=None)
@given(st.integers(0, 10**6), st.sampled_from(list(MESHES)))
def test_the_indices_of_any_field_sum_to_the_euler_characteristic(seed, kind):
    mesh = MESHES[kind]
    # Few different values, so that there are ties.
    values = np.random.default_rng(seed).integers(0, 12, len(mesh.vertices)).astype(float)
    found = critical_vertices(mesh, values)
    assert found.index_sum == mesh.euler_characteristic
    if mesh.topology.is_closed:
        assert balance(found) == mesh.euler_characteristic
