"""The real models, against the numbers that other programs gave."""

import re

import numpy as np
import pytest

from core.io import load_mesh, read_mesh

ROW = re.compile(r"^\| (\S+\.\w+) \| (\d+) \| (\d+) \| (\d+) \| [yn] \| (-?\d+)", re.MULTILINE)
PAIR = re.compile(r"^\| (\S+__gt\.\w+) \| (\S+) \| (\d+) \| (\d+) \| ([\d.]+) \|", re.MULTILINE)

# Files that the index lists as other readers see them: as they should be read.
OTHERWISE = {
    "awkward/cow_tristrips.ply": (2903, 5804, "923 triangle strips cut into 5,804 faces"),
    "awkward/double_torus_quads.off": (231, 466, "220 polygons triangulated"),
    "awkward/cow_polygons.obj": (2903, 5804, "2,529 polygons triangulated"),
    "awkward/conrod_soup.stl": (3223, 6442, "19,326 corners merged into 3,223 vertices"),
    "awkward/teapot_soup.stl": (480, 894, "2,682 corners merged into 480 vertices"),
    "awkward/bunny_res2_nonmanifold.ply": (8146, 16301, "25 unreferenced vertices dropped"),
}


def test_every_model_has_the_vertices_faces_and_edges_of_the_index(shared_models):
    rows = ROW.findall((shared_models / "INDEX.md").read_text())
    rows = [row for row in rows if row[0] not in OTHERWISE]
    assert len(rows) > 35
    for name, *numbers in rows:
        mesh = load_mesh(shared_models / name)
        found = len(mesh.vertices), len(mesh.faces), len(mesh.edges), mesh.euler_characteristic
        assert found == tuple(map(int, numbers)), name


@pytest.mark.parametrize("name", OTHERWISE)
def test_awkward_files_give_the_right_mesh_and_say_what_was_changed(name, shared_models):
    vertices, faces, summary = OTHERWISE[name]
    result = read_mesh(shared_models / name)
    assert (len(result.mesh.vertices), len(result.mesh.faces)) == (vertices, faces)
    assert result.summary == summary


def test_strips_and_polygons_of_the_cow_are_wound_like_its_triangles(shared_models):
    for name in ("awkward/cow_tristrips.ply", "awkward/cow_polygons.obj", "cow_2903.obj"):
        mesh = load_mesh(shared_models / name)
        assert mesh.topology.is_closed, name
        assert mesh.topology.is_consistently_wound, name
        assert mesh.euler_characteristic == 1, name


def test_a_noisy_model_and_its_original_match_vertex_by_vertex(shared_models):
    """The RMS displacement in mean edge lengths is the one that the index states."""
    rows = PAIR.findall((shared_models / "INDEX.md").read_text())
    assert len(rows) == 10
    for original_name, noisy_name, vertices, faces, rms in rows:
        original = load_mesh(shared_models / "pairs" / original_name)
        noisy = load_mesh(shared_models / "pairs" / noisy_name)
        assert (len(original.vertices), len(original.faces)) == (int(vertices), int(faces))
        assert np.array_equal(original.faces, noisy.faces)
        moved = np.linalg.norm(noisy.vertices - original.vertices, axis=1)
        found = np.sqrt(np.mean(moved**2)) / original.mean_edge_length
        assert found == pytest.approx(float(rms), abs=0.002), noisy_name


def test_models_with_skeletons_are_closed_and_connected(shared_models):
    for path in sorted((shared_models / "skeletons").glob("*.obj")):
        mesh = load_mesh(path)
        assert mesh.topology.is_closed, path.name
        assert mesh.topology.component_count == 1, path.name
