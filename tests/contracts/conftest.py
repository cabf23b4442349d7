"""Meshes that numbers have to survive."""

import numpy as np
import pytest

from core.mesh import TriangleMesh, primitives
from core.noise import add_noise

POWERS = (-12, -9, -6, -3, 0, 3, 6, 9, 12)


def noisy_torus() -> TriangleMesh:
    return add_noise(primitives.torus(14, 9), sigma=0.1, seed=3)


def far() -> TriangleMesh:
    """Moved by 1e9: what is left of the coordinates are steps of 1e-7."""
    torus = noisy_torus()
    return torus.with_vertices(torus.vertices + np.array([1e9, -1e9, 1e9]))


def whole_numbers() -> TriangleMesh:
    torus = noisy_torus()
    return TriangleMesh(np.round(1000 * torus.vertices).astype(np.int32), torus.faces)


def single_precision() -> TriangleMesh:
    torus = noisy_torus()
    return TriangleMesh(torus.vertices.astype(np.float32), torus.faces.astype(np.uint16))


def triangle() -> TriangleMesh:
    return TriangleMesh([[0, 0, 0], [1, 0, 0], [0.2, 0.9, 0.1]], [[0, 1, 2]])


def fan(faces: int = 50_000) -> TriangleMesh:
    """A vertex in the middle of all faces of a wavy disc."""
    angles = np.linspace(0, 2 * np.pi, faces, endpoint=False)
    rim = np.stack([np.cos(angles), np.sin(angles), 0.1 * np.sin(7 * angles)], axis=1)
    after = np.arange(1, faces + 1)
    corners = np.stack([np.zeros_like(after), after, after % faces + 1], axis=1)
    return TriangleMesh(np.vstack([[0, 0, 0.3], rim]), corners)


def needle() -> TriangleMesh:
    """A ball drawn out a million times."""
    ball = primitives.sphere(2)
    return ball.with_vertices(ball.vertices * np.array([1e6, 1, 1e-6]))


def flat() -> TriangleMesh:
    return primitives.grid(6, 6)


def point() -> TriangleMesh:
    """All vertices at one place: there is no length to measure by."""
    ball = primitives.sphere(1)
    return ball.with_vertices(np.ones_like(ball.vertices))


def with_strays() -> TriangleMesh:
    """Vertices without a face, faces without an area, a face twice, two parts in one point."""
    places = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [9, 9, 9], [2, 0, 0], [3, 0, 0]]
    corners = [[0, 1, 2], [0, 2, 3], [1, 5, 6], [0, 1, 2], [0, 5, 6]]
    return TriangleMesh(places, corners)


def scaled(power: int) -> TriangleMesh:
    torus = noisy_torus()
    return torus.with_vertices(10.0**power * torus.vertices)


MESHES = {
    **{f"1e{power}": lambda power=power: scaled(power) for power in POWERS},
    **{make.__name__: make for make in (far, whole_numbers, single_precision, triangle, fan)},
    **{make.__name__: make for make in (needle, flat, point, with_strays)},
    "hub": lambda: fan(1_000),
}


@pytest.fixture(scope="session", params=MESHES)
def hard_mesh(request):
    """Each mesh that numbers have to survive, with its connectivity kept for all tests."""
    return MESHES[request.param]()


@pytest.fixture
def huge_fan():
    return fan()


@pytest.fixture
def small_fan():
    return fan(50)


@pytest.fixture(scope="session", params=[name for name in MESHES if name != "fan"])
def modest_mesh(request):
    """The same without the largest; the spectrum of 50,000 faces in a fan takes minutes."""
    return MESHES[request.param]()
