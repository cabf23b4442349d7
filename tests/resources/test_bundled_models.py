from pathlib import Path

import numpy as np
import pytest

from core.io import load_mesh
from core.mesh import TriangleMesh
from core.mesh.geometry import corner_angles, edge_lengths, face_normals, volume

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "models"
GENUS = {"creature": 0, "double_torus": 2, "machine_part": 5}
FACES = {
    "creature": (28_000, 32_000),
    "double_torus": (8_000, 12_000),
    "machine_part": (15_000, 25_000),
}


@pytest.fixture(scope="module", params=list(GENUS))
def name(request):
    return request.param


@pytest.fixture(scope="module")
def mesh(name) -> TriangleMesh:
    return load_mesh(FOLDER / f"{name}.ply")


@pytest.fixture(scope="module")
def part() -> TriangleMesh:
    """The machine part lying as it was constructed, with z up; the file has y up."""
    mesh = load_mesh(FOLDER / "machine_part.ply")
    return mesh.with_vertices(mesh.vertices[:, [0, 2, 1]] * [1, -1, 1])


def sharp_edges(mesh: TriangleMesh) -> np.ndarray:
    """Edges whose faces meet at more than 30°, (k, 2)."""
    faces = mesh.topology.edge_corners.items.reshape(-1, 2) // 3
    first, second = face_normals(mesh)[faces].transpose(1, 0, 2)
    return mesh.edges[np.sum(first * second, axis=1) < np.cos(np.radians(30))]


def test_the_models_are_small_together():
    files = list(FOLDER.glob("*.ply"))
    assert {file.stem for file in files} == set(GENUS)
    assert sum(file.stat().st_size for file in files) <= 6_000_000


def test_files_are_binary_with_single_precision(name):
    header = (FOLDER / f"{name}.ply").read_bytes()[:400].decode("ascii", errors="replace")
    assert "format binary_little_endian 1.0" in header
    assert "property float x" in header


def test_one_closed_surface_of_the_promised_genus(name, mesh):
    topology = mesh.topology
    assert topology.is_closed
    assert topology.is_manifold
    assert topology.is_consistently_wound
    assert topology.component_count == 1
    assert mesh.genus == GENUS[name]


def test_wound_outwards(mesh):
    assert volume(mesh) > 0


def test_face_count(name, mesh):
    low, high = FACES[name]
    assert low <= len(mesh.faces) <= high


def test_faces_are_well_shaped_and_of_about_equal_size(mesh):
    smallest = np.degrees(corner_angles(mesh).min(axis=1))
    assert np.mean(smallest > 20) > 0.99
    assert smallest.min() > 15
    assert smallest.mean() > 45
    lengths = edge_lengths(mesh)
    assert lengths.max() < 2.5 * mesh.mean_edge_length
    assert lengths.min() > mesh.mean_edge_length / 4


def test_creature_stands_on_the_ground_and_is_about_one_high():
    heights = load_mesh(FOLDER / "creature.ply").vertices[:, 1]
    assert heights.min() == pytest.approx(0, abs=0.003)
    assert heights.max() == pytest.approx(1.05, abs=0.1)


@pytest.mark.parametrize("name", ["creature", "double_torus"])
def test_smooth_models_have_no_long_creases(name):
    mesh = load_mesh(FOLDER / f"{name}.ply")
    assert len(sharp_edges(mesh)) < 0.03 * len(mesh.edges)


def test_sharp_edges_of_the_part_are_unbroken_curves(part):
    ends = np.bincount(sharp_edges(part).ravel(), minlength=len(part.vertices))
    assert len(sharp_edges(part)) > 1_000
    assert not np.any(ends == 1)


def test_sharp_vertices_of_the_bolt_holes_lie_on_their_circles(part):
    corners = part.vertices[np.unique(sharp_edges(part))]
    distance = np.hypot(np.abs(corners[:, 0]) - 1.03, np.abs(corners[:, 1]) - 0.43)
    around = distance < 0.22
    circles = {(0.12, 0.0): 0, (0.12, 0.2): 0, (0.2, 0.2): 0, (0.2, 0.3): 0}
    for radius, height in circles:
        fits = np.abs(distance[around] - radius) + np.abs(corners[around, 2] - height) < 1e-6
        circles[radius, height] = fits.sum()
    assert all(circles.values())
    assert sum(circles.values()) == around.sum()


def test_part_is_symmetric(part):
    for axis in (0, 1):
        low, high = part.vertices[:, axis].min(), part.vertices[:, axis].max()
        assert low == pytest.approx(-high)
