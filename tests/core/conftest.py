"""Meshes on which every kernel is compared with its formula."""

import numpy as np
import pytest

from core.mesh import TriangleMesh, primitives
from core.noise import add_noise


def _open() -> TriangleMesh:
    """A sphere of which two faces in five are missing."""
    ball = primitives.sphere(3)
    kept = np.random.default_rng(2).random(len(ball.faces)) < 0.6
    return TriangleMesh(ball.vertices, ball.faces[kept])


def _tangled() -> TriangleMesh:
    """Random triangles on few vertices: edges of many faces, pinches, doubled and flat faces."""
    random = np.random.default_rng(7)
    faces = np.array([random.permutation(25)[:3] for _ in range(80)])
    faces = np.concatenate([faces, faces[:1], faces[1:2, ::-1], [[25, 26, 27]]])
    vertices = random.normal(size=(29, 3))
    vertices[25:28] = [[0, 0, 0], [1, 1, 1], [3, 3, 3]]  # no area; vertex 28 has no face
    return TriangleMesh(vertices, faces)


def _cone() -> TriangleMesh:
    """A tip with a hundred faces, so that every face has a long ring."""
    rim = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    vertices = np.stack([np.cos(rim), np.sin(rim), 0.1 * np.sin(7 * rim)], axis=1)
    faces = [[i, (i + 1) % 100, 100] for i in range(100)]
    return TriangleMesh(np.concatenate([vertices, [[0, 0, 1]]]), faces)


_MESHES = {
    "closed": add_noise(primitives.sphere(3), 0.3),
    "open": add_noise(_open(), 0.2),
    "non-manifold": _tangled(),
    "long ring": _cone(),
}


@pytest.fixture(params=list(_MESHES))
def irregular(request) -> TriangleMesh:
    """Irregular, open and non-manifold meshes."""
    return _MESHES[request.param]
