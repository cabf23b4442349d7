"""What repairs do, what they leave alone, and that doing them twice changes nothing more."""

import numpy as np
import pytest

from core.doctor import (
    NOTHING,
    REPAIRS,
    RepairChoice,
    RepairError,
    examine,
    needed_repairs,
    repair,
    repaired,
)
from core.io import load_mesh
from core.mesh import TriangleMesh, primitives
from core.mesh.geometry import face_areas, volume
from core.parameters import ParameterError, describe

REPAIRED_BY = {
    "needle": "degenerate_faces",
    "cap": "degenerate_faces",
    "twice": "duplicate_faces",
    "torn": "duplicate_vertices",
    "isolated": "unreferenced_vertices",
    "book": "split",
    "bow_tie": "split",
    "turned": "orient",
    "inside_out": "orient",
    "speck": "small_components",
    "holed": "fill_holes",
}
every_case = pytest.mark.parametrize(("case", "id_"), REPAIRED_BY.items())
AWKWARD = (
    "bunny_res2_nonmanifold.ply", "blobby_shuffled_winding.off", "conrod_soup.stl",
    "teapot_soup.stl", "degenerate_faces.off", "many_small_holes.ply", "nonmanifold_hole.ply",
    "elephant_with_holes.off", "cow_polygons.obj", "cow_tristrips.ply",
)  # fmt: skip


@every_case
def test_removes_the_finding(defective, case, id_):
    mesh = defective(case)
    report = examine(repair(mesh, id_).mesh)
    assert not report.defects
    assert not any(report.count(spec.id) for spec in REPAIRS[id_].removes)
    if case in {"speck", "holed"}:
        assert report.findings == ()


@every_case
def test_a_second_time_changes_nothing(defective, case, id_):
    once = repair(defective(case), id_).mesh
    again = repair(once, id_)
    assert again.changes == (NOTHING,)
    assert again.mesh is once


@every_case
def test_moves_no_vertex(defective, case, id_):
    mesh = defective(case)
    result = repair(mesh, id_)
    assert np.array_equal(result.mesh.vertices, mesh.vertices[result.sources])


@pytest.mark.parametrize("id_", REPAIRS)
def test_leaves_a_sound_mesh_alone(id_):
    mesh = primitives.torus()
    result = repair(mesh, id_)
    assert result.changes == (NOTHING,)
    assert np.array_equal(result.mesh.faces, mesh.faces)


@every_case
def test_does_the_same_on_renumbered_vertices_and_faces(defective, case, id_):
    mesh = defective(case)
    rng = np.random.default_rng(7)
    order = rng.permutation(len(mesh.vertices))
    number = np.argsort(order)
    other = TriangleMesh(mesh.vertices[order], number[mesh.faces][rng.permutation(len(mesh.faces))])
    one, two = repair(mesh, id_), repair(other, id_)
    assert one.changes == two.changes
    assert face_areas(one.mesh).sum() == pytest.approx(face_areas(two.mesh).sum())
    assert one.mesh.euler_characteristic == two.mesh.euler_characteristic


@pytest.mark.parametrize("id_", REPAIRS)
def test_declares_itself_fully(id_):
    spec = REPAIRS[id_]
    assert spec.id == id_
    assert all((spec.title, spec.summary, spec.apply.__doc__))
    assert all(parameter.help for parameter in describe(spec.params))


def test_a_cap_leaves_no_crack(defective):
    mesh = defective("cap")
    result = repair(mesh, "degenerate_faces")
    assert result.changes == ("Removed 1 face without area, 1 edge exchanged.",)
    assert len(result.mesh.faces) == 4
    assert face_areas(result.mesh).sum() == pytest.approx(2)
    assert len(result.mesh.vertices) == 5


def test_a_needle_is_drawn_together(defective):
    result = repair(defective("needle"), "degenerate_faces")
    assert result.mesh.faces.tolist() == [[0, 1, 2], [1, 3, 2]]
    assert result.sources.tolist() == [0, 1, 3, 4]


def test_a_torn_torus_is_whole_again(defective):
    result = repair(defective("torn"), "duplicate_vertices")
    assert result.changes == ("Merged 6 vertices into others at the same place.",)
    assert result.mesh.genus == 1


def test_split_vertices_stand_after_the_others(defective):
    mesh = defective("bow_tie")
    result = repair(mesh, "split")
    assert result.changes == ("Split 1 vertex into 2.",)
    assert result.sources.tolist() == [0, 1, 2, 3, 4, 5, 6, 0]
    assert result.mesh.genus == 0


def test_a_book_falls_into_three_pages(defective):
    result = repair(defective("book"), "split")
    assert result.changes == ("Split 2 vertices into 6.",)
    assert result.mesh.topology.component_count == 3


@pytest.mark.parametrize("case", ["turned", "inside_out"])
def test_the_outside_is_out(defective, case):
    mesh = repair(defective(case), "orient").mesh
    assert volume(mesh) == pytest.approx(volume(primitives.sphere(1)))


def test_an_open_surface_follows_its_majority():
    grid = primitives.grid(3, 3)
    faces = grid.faces.copy()
    faces[4] = faces[4][::-1]
    result = repair(TriangleMesh(grid.vertices, faces), "orient")
    assert result.changes == ("Turned 1 face round.",)
    assert {tuple(np.roll(f, -f.argmin())) for f in result.mesh.faces} == {
        tuple(np.roll(f, -f.argmin())) for f in grid.faces
    }


def test_a_one_sided_surface_stays_as_it_is(defective):
    mesh = defective("moebius")
    assert not mesh.topology.is_orientable
    assert repair(mesh, "orient").changes == (NOTHING,)


def test_two_sheets_that_lie_on_one_another_are_not_sewn_together():
    grid = primitives.grid(2, 2)
    m = len(grid.vertices)
    vertices = np.concatenate([grid.vertices, grid.vertices])
    double = TriangleMesh(vertices, np.concatenate([grid.faces, grid.faces + m]))
    assert repair(double, "duplicate_vertices").changes == (NOTHING,)
    single = repair(double, "duplicate_faces").mesh
    assert np.array_equal(single.faces, grid.faces)
    assert len(single.vertices) == m


def test_the_share_decides_which_components_are_small(defective):
    mesh = defective("speck")
    assert repair(mesh, "small_components", share=0.0005).changes == (NOTHING,)
    result = repair(mesh, "small_components")
    assert result.changes == ("Removed 1 component with 1 face.",)
    everything = repair(primitives.tetrahedron(), "small_components", share=1)
    assert everything.changes == (NOTHING,)


def test_all_that_is_needed_is_found_by_itself(shared_models):
    for name in AWKWARD:
        mesh = load_mesh(shared_models / "awkward" / name)
        choices = needed_repairs(mesh)
        assert all(REPAIRS[choice.repair].keeps_shape for choice in choices)
        result = repaired(mesh, choices)
        assert examine(result.mesh).is_sound, name
        assert needed_repairs(result.mesh) == ()
        assert np.array_equal(result.mesh.vertices, mesh.vertices[result.sources])


def test_a_noisy_twin_is_repaired_with_its_original(defective):
    mesh = defective("torn")
    noisy = mesh.with_vertices(mesh.vertices + 1)
    result = repair(mesh, "duplicate_vertices")
    twin = result.carry(noisy)
    assert np.array_equal(twin.vertices, result.mesh.vertices + 1)
    assert twin.topology is result.mesh.topology


def test_refuses_to_leave_nothing():
    line = TriangleMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
    with pytest.raises(RepairError, match="no face"):
        repair(line, "degenerate_faces")


def test_names_what_is_allowed():
    with pytest.raises(ParameterError, match="polish is not a repair; allowed: degenerate_faces"):
        repair(primitives.tetrahedron(), "polish")
    with pytest.raises(ParameterError, match="use 3 to 200"):
        repair(primitives.tetrahedron(), "fill_holes", most_edges=1)
    with pytest.raises(ParameterError, match=r"split\.share is not a parameter"):
        _ = RepairChoice(repair="split", params={"share": 1}).settings
