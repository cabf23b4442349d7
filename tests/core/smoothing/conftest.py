"""The formulas of the smoothing methods in plain numpy, from nothing but vertices and faces."""

from functools import cached_property

import numpy as np
import pytest

from core.kernels import unsigned
from core.mesh.geometry import face_normals
from core.smoothing import METHODS
from core.smoothing.median_faces import set_median_faces


def unit(vector):
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else np.zeros(3)


class Plain:
    """Quantities of one mesh."""

    def __init__(self, mesh):
        self.mesh = mesh

    @cached_property
    def rings(self):
        rings = [set() for _ in self.mesh.vertices]
        for i, j, k in self.mesh.faces.tolist():
            rings[i] |= {j, k}
            rings[j] |= {i, k}
            rings[k] |= {i, j}
        return [sorted(ring) for ring in rings]

    @cached_property
    def faces_around(self):
        faces, m = self.mesh.faces, len(self.mesh.vertices)
        return [np.flatnonzero((faces == i).any(axis=1)) for i in range(m)]

    @cached_property
    def face_rings(self):
        around = [faces.tolist() for faces in self.faces_around]
        faces = self.mesh.faces.tolist()
        return [sorted({t for i in f for t in around[i]} - {own}) for own, f in enumerate(faces)]

    @cached_property
    def area_vectors(self):
        a, b, c = self.mesh.vertices[self.mesh.faces].transpose(1, 0, 2)
        return np.cross(b - a, c - a) / 2

    @cached_property
    def areas(self):
        return np.linalg.norm(self.area_vectors, axis=1)

    @cached_property
    def centroids(self):
        return self.mesh.vertices[self.mesh.faces].mean(axis=1)

    @cached_property
    def normals(self):
        return np.array([unit(vector) for vector in self.area_vectors])

    @cached_property
    def mean_normals(self):
        vectors = self.area_vectors
        sums = np.array([vectors[ring].sum(axis=0) for ring in self.face_rings])
        totals = np.array([self.areas[ring].sum() for ring in self.face_rings])
        cancelled = np.linalg.norm(sums, axis=1) <= 1e-9 * totals
        return np.array([unit(v) for v in np.where(cancelled[:, None], vectors, sums)])

    @cached_property
    def vertex_normals(self):
        sums = [self.normals[around].sum(axis=0) for around in self.faces_around]
        lengths = np.linalg.norm(sums, axis=1)
        counts = [len(around) for around in self.faces_around]
        cancelled = lengths <= 1e-9 * np.array(counts)
        return np.where(cancelled[:, None], 0, [unit(vector) for vector in sums])

    def moved(self, move):
        """Positions after `move(i, ring)` is added to each vertex that has a ring."""
        pairs = enumerate(zip(self.mesh.vertices, self.rings, strict=True))
        return np.array([v + move(i, ring) if ring else v for i, (v, ring) in pairs])

    def fitted(self, normals):
        """Positions after step 3 of the normal filters."""
        result = self.mesh.vertices.copy()
        for i, around in enumerate(self.faces_around):
            areas, m = self.areas[around], normals[around]
            if areas.sum() > 0:
                heights = np.einsum("tx,tx->t", self.centroids[around] - result[i], m)
                result[i] += (areas * heights) @ m / areas.sum()
        return result

    def squared_gradients(self, *, printed):
        v, d = self.mesh.vertices, np.array([max(len(ring), 1) for ring in self.rings])
        if printed:
            scaled = v / np.sqrt(d)[:, None]
            return np.array(
                [((scaled[r] - scaled[i]) ** 2).sum() for i, r in enumerate(self.rings)]
            )
        return np.array([((v[r] - v[i]) ** 2).sum() / d[i] for i, r in enumerate(self.rings)])


@pytest.fixture
def plain(irregular):
    return Plain(irregular)


@pytest.fixture
def plain_of():
    return Plain


@pytest.fixture
def median_faces():
    """Face at the lower median angle of each ring."""

    def medians(mesh):
        table, found = unsigned(*mesh.topology.face_ring), np.empty(len(mesh.faces), np.int32)
        set_median_faces(face_normals(mesh), 0, *table, found)
        return found

    return medians


@pytest.fixture
def first_step():
    """Positions after the first iteration of a method with these parameters."""

    def step(mesh, method, **params):
        spec = METHODS[method]
        return next(iter(spec.steps(mesh, spec.params(**params))))

    return step
