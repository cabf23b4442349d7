"""Selecting instead of sorting, and what it is for: rings of thousands of faces."""

import time
from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.mesh import TriangleMesh, face_rings
from core.mesh.geometry import face_normals
from core.smoothing import METHODS, smooth
from core.smoothing.selection import select


def fan(faces, seed=5):
    """A disc of triangles around one vertex, each of which neighbours every other."""
    angles = np.linspace(0, 2 * np.pi, faces, endpoint=False)
    rim = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
    noise = np.random.default_rng(seed).normal(0, 0.2 / faces, (faces + 1, 3))
    after = np.arange(1, faces + 1)
    corners = np.stack([np.zeros_like(after), after, after % faces + 1], axis=1)
    return TriangleMesh(np.vstack([[0, 0, 0.3], rim]) + noise, corners)


def test_selecting_by_hand():
    assert [select(np.array([3.0, 1.0, 2.0]), place) for place in range(3)] == [1, 2, 3]
    assert select(np.array([7.0]), 0) == 7


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(-2, 2) | st.sampled_from([0.0, 1.0]), min_size=1), st.data())
def test_it_is_what_sorting_would_put_there(values, data):
    place = data.draw(st.integers(0, len(values) - 1))
    assert select(np.array(values), place) == sorted(values)[place]


@pytest.mark.parametrize(
    "values",
    [
        np.zeros(100_000),
        np.arange(100_000.0),
        np.arange(100_000.0)[::-1],
        np.arange(1e5) % 2,
        np.abs(np.arange(1e5) - 5e4),
        np.cos(np.linspace(0, 14 * np.pi, 100_000)),
    ],
    ids=["equal", "rising", "falling", "two", "there and back", "waves"],
)
def test_no_order_makes_it_slow(values):
    select(np.zeros(2), 1)
    expected = np.sort(values)[50_000]
    started = time.thread_time()
    assert select(values.copy(), 50_000) == expected
    assert time.thread_time() - started < 0.5


@pytest.mark.parametrize("place", [0, 5, 9])
def test_a_nan_does_not_keep_it_for_ever(place):
    for nans in ([0], [5], [9], [0, 5, 9], range(10)):
        values = np.arange(10.0)
        values[list(nans)] = np.nan
        select(values, place)


@pytest.mark.parametrize("faces", [60, 66, 300])
def test_medians_of_long_rings(faces, median_faces):
    wavy = fan(faces)
    # Two faces without area, which make no angle.
    flat = wavy.vertices.copy()
    flat[[10, 20]] = flat[[11, 21]]
    for mesh in (wavy, wavy.with_vertices(flat)):
        normals = face_normals(mesh)
        has_normal = normals.any(axis=1)
        for t, found in enumerate(median_faces(mesh)):
            others = np.flatnonzero(has_normal & (np.arange(faces) != t))
            cosines = normals[others] @ normals[t]
            expected = -np.sort(-cosines)[(len(others) - 1) // 2]
            assert normals[found] @ normals[t] == pytest.approx(expected, abs=1e-14)


def test_faces_without_normals_in_a_long_ring_keep_theirs(median_faces):
    mesh = fan(100)
    assert median_faces(mesh.with_vertices(0 * mesh.vertices)).tolist() == list(range(100))


def test_an_isolated_face_beside_a_long_ring(median_faces):
    disc = fan(100)
    vertices = np.vstack([disc.vertices, np.eye(3) + 5])
    mesh = TriangleMesh(vertices, np.vstack([disc.faces, [[101, 102, 103]]]))
    assert median_faces(mesh)[100] == 100


@pytest.mark.parametrize("kept", [0, 10**9])
@pytest.mark.parametrize("method", ["median", "mean"])
def test_an_iteration_in_parts_gives_the_same_positions(method, kept, monkeypatch):
    mesh, spec = fan(300), METHODS[method]
    first, second = islice(spec.steps(mesh, spec.params()), 2)
    monkeypatch.setattr(face_rings, "MOST_NEIGHBOURS", kept)
    monkeypatch.setattr(face_rings, "_FEW_NEIGHBOURS", 20_000)
    parts = list(islice(spec.steps(mesh, spec.params()), 12))
    found = [step for step in parts if step is not None]
    assert [step is None for step in parts[:6]] == [True] * 4 + [False, True]
    assert np.array_equal(found[0], first)
    assert np.array_equal(found[1], second)
    assert np.array_equal(smooth(mesh, method, 2).vertices, second)


@pytest.mark.parametrize("method", ["median", "mean"])
def test_a_fan_of_thousands_takes_a_moment(method):
    smooth(fan(100), method, 1)  # reads what is compiled
    mesh = fan(5000)
    started = time.process_time()
    smooth(mesh, method, 2)
    # Measured: median 0.5 s, and 15 s when it sorted.
    assert time.process_time() - started < 5
