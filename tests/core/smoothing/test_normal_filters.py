"""The methods that use normals, kernel by kernel, against their formulas in plain numpy."""

import numpy as np
import pytest

from core.kernels import unsigned
from core.mesh import TriangleMesh, primitives
from core.smoothing import bilateral
from core.smoothing.mean import set_area_vectors, set_mean_planes
from core.smoothing.normal_update import fit_vertices, set_areas_and_normals


def test_areas_normals_and_fit(irregular, plain):
    areas, normals = np.empty(len(irregular.faces)), np.empty((len(irregular.faces), 3))
    set_areas_and_normals(irregular.vertices, *unsigned(irregular.faces), areas, normals)
    assert areas == pytest.approx(plain.areas)
    assert normals == pytest.approx(plain.normals)
    planes = np.c_[normals, np.einsum("tx,tx->t", plain.centroids, normals)]
    around = unsigned(*irregular.topology.vertex_faces)
    ours = fit_vertices(irregular.vertices, *around, areas, planes)
    assert ours == pytest.approx(plain.fitted(normals))


def test_mean_planes(irregular, plain):
    (faces,), ring = unsigned(irregular.faces), unsigned(*irregular.topology.face_ring)
    planes, areas, vectors = (
        np.empty((len(faces), 4)),
        np.empty(len(faces)),
        np.empty((len(faces), 3)),
    )
    set_area_vectors(irregular.vertices, faces, areas, vectors)
    assert areas == pytest.approx(plain.areas)
    assert vectors == pytest.approx(plain.area_vectors)
    set_mean_planes(irregular.vertices, faces, areas, vectors, 0, *ring, planes)
    assert planes[:, :3] == pytest.approx(plain.mean_normals)
    heights = np.einsum("tx,tx->t", plain.centroids, plain.mean_normals)
    assert planes[:, 3] == pytest.approx(heights)


def test_mean_filter(irregular, plain, first_step):
    assert first_step(irregular, "mean") == pytest.approx(plain.fitted(plain.mean_normals))


@pytest.mark.parametrize("method", ["mean", "median"])
def test_a_face_without_a_ring_keeps_its_normal(plain_of, first_step, method):
    alone = plain_of(TriangleMesh(np.eye(3), [[0, 1, 2]]))
    assert first_step(alone.mesh, method) == pytest.approx(alone.fitted(alone.normals))


def test_median_faces(plain, median_faces):
    ours, normals, rings = median_faces(plain.mesh), plain.normals, plain.face_rings
    assert all(face in ring for face, ring in zip(ours, rings, strict=True) if ring)
    # Equal angles may differ in their last bit, so that either face is right.
    cosines = np.einsum("tx,tx->t", normals[ours], normals)
    for t, ring in enumerate(rings):
        if ring:
            descending = -np.sort(-normals[ring] @ normals[t])
            assert cosines[t] == pytest.approx(descending[(len(ring) - 1) // 2], abs=1e-14)
        else:
            assert ours[t] == t


def test_median_filter(irregular, plain, first_step, median_faces):
    expected = plain.fitted(plain.normals[median_faces(irregular)])
    assert first_step(irregular, "median") == pytest.approx(expected)


def test_of_equal_angles_the_first_face_is_taken(plain_of, median_faces):
    flat = plain_of(primitives.grid(6, 6))
    assert median_faces(flat.mesh).tolist() == [ring[0] for ring in flat.face_rings]


def test_bilateral(irregular, plain, first_step):
    v, normals, width = irregular.vertices, plain.vertex_normals, irregular.mean_edge_length

    def move(i, ring):
        offsets = v[ring] - v[i]
        heights = offsets @ normals[i]
        squares = (offsets**2).sum(axis=1)
        weights = np.exp(-squares / (2 * width**2) - heights**2 / (2 * (0.5 * width) ** 2))
        return normals[i] * (weights @ heights) / weights.sum()

    ours = first_step(irregular, "bilateral", sigma_c=1.0, sigma_s=0.5)
    assert ours == pytest.approx(plain.moved(move))


def test_automatic_width_of_heights(irregular, plain):
    v, normals = irregular.vertices, plain.vertex_normals
    heights = [(v[ring] - v[i]) @ normals[i] for i, ring in enumerate(plain.rings)]
    sigma_c, sigma_s = bilateral.automatic_widths(irregular, bilateral.BilateralParams())
    assert sigma_c == irregular.mean_edge_length
    assert sigma_s == pytest.approx(np.concatenate(heights).std())
