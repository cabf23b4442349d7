"""What cancels, what is equal and what has no area must not depend on rounding or on numbers."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.io import load_mesh
from core.mesh import TriangleMesh, primitives
from core.noise import add_noise
from core.smoothing import METHODS, smooth

SEEDS = range(8)


def turned(points, seed):
    return points @ Rotation.random(rng=np.random.default_rng(seed)).as_matrix().T


def fold_over(seed):
    """Faces 0 and 1 in one plane, turned over, of one size; face 2 stands at their vertex 0."""
    points = np.array([[0, 0, 0], [3, 1, 0], [1, 2, 0], [-2, 1, 0], [-1, -2, 0]], float)
    points = np.concatenate([points, [[1, 0, 2], [-1, 1, 3]]]) / 7
    return TriangleMesh(turned(points, seed), [[0, 1, 2], [0, 4, 3], [0, 5, 6]])


def shuffled(mesh, seed=4):
    """The mesh with vertices and faces in another order, each face from another corner."""
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(mesh.vertices))
    faces = np.argsort(order)[mesh.faces][rng.permutation(len(mesh.faces))]
    turns = (np.arange(3) + rng.integers(0, 3, (len(faces), 1))) % 3
    return TriangleMesh(mesh.vertices[order], np.take_along_axis(faces, turns, axis=1)), order


@pytest.mark.parametrize("seed", SEEDS)
def test_a_vertex_whose_normals_cancel_stays(seed, first_step):
    folded = TriangleMesh(fold_over(seed).vertices[:5], [[0, 1, 2], [0, 4, 3]])
    moved = first_step(folded, "bilateral", sigma_c=1.0, sigma_s=1.0)
    assert np.array_equal(moved[0], folded.vertices[0])


@pytest.mark.parametrize("seed", SEEDS)
def test_a_face_whose_ring_cancels_keeps_its_own_normal(seed, first_step):
    mesh = fold_over(seed)
    # Vertices 5 and 6 belong to face 2 alone, and lie in the plane of its own normal.
    moved = first_step(mesh, "mean")
    assert moved[5:] == pytest.approx(mesh.vertices[5:], abs=1e-15)


def test_of_two_equal_angles_the_first_face_is_taken(median_faces, first_step):
    # Face 0 lies flat between a wing that rises and one that falls, both by 45 degrees.
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, -1, 1], [-1, 1, -1]], float)
    flat, rising, falling = [0, 1, 2], [1, 0, 3], [0, 2, 4]
    slopes = []
    for wings in ([rising, falling], [falling, rising]):
        mesh = TriangleMesh(points, [flat, *wings])
        assert median_faces(mesh)[0] == 1
        slopes.append(first_step(mesh, "median"))
    assert np.abs(slopes[0] - slopes[1]).max() > 0.1


@pytest.mark.parametrize("method", ["mean", "median"])
def test_a_face_without_area_counts_as_nothing(method, first_step):
    # A tip on three faces; vertex 4 lies in the middle of the edge from 0 to 1.
    points = [[1, 1, 0], [-1, 1, 0], [0, -1, 0], [0.3, 0.1, 0.5], [0, 1, 0]]
    faces = [[0, 1, 3], [1, 2, 3], [2, 0, 3]]
    without = TriangleMesh(points, faces)
    with_flat = TriangleMesh(points, [*faces[:2], [0, 4, 1], faces[2]])
    assert np.array_equal(first_step(with_flat, method), first_step(without, method))


@pytest.mark.parametrize("method", METHODS)
def test_numbering_does_not_count_where_faces_fold_over(method, irregular):
    mesh, order = shuffled(irregular)
    expected = smooth(irregular, method, 1).vertices[order]
    assert smooth(mesh, method, 1).vertices == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("method", ["mean", "bilateral"])
def test_numbering_does_not_count_on_a_scan_with_folds(method, shared_models):
    scan = load_mesh(shared_models / "awkward" / "bunny_res2_nonmanifold.ply")
    mesh, order = shuffled(scan)
    difference = smooth(mesh, method, 2).vertices - smooth(scan, method, 2).vertices[order]
    assert np.abs(difference).max() < 1e-9 * scan.mean_edge_length


@pytest.mark.parametrize("method", METHODS)
def test_a_run_along_the_surface_gives_positions_in_the_order_of_the_file(method):
    mesh, _ = shuffled(add_noise(primitives.sphere(6), 0.1))
    assert mesh.along_surface() is not mesh
    spec = METHODS[method]
    steps = spec.steps(mesh, spec.params())
    next(steps)
    assert smooth(mesh, method, 2).vertices == pytest.approx(next(steps), abs=1e-12)
