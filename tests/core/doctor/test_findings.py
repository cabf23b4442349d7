"""What the doctor finds, case by case."""

import numpy as np
import pytest

from core.doctor import FINDINGS, REPAIRS, examine, repair_for
from core.mesh import TriangleMesh, primitives

FOUND = {
    "needle": {"degenerate_faces": 1},
    "cap": {"degenerate_faces": 1},
    "twice": {"duplicate_faces": 1, "nonmanifold_edges": 3},
    "torn": {"duplicate_vertices": 6},
    "isolated": {"unreferenced_vertices": 2},
    "book": {"nonmanifold_edges": 1},
    "bow_tie": {"pinched_vertices": 1},
    "turned": {"winding": 9},
    "inside_out": {"inside_out": 1},
    "moebius": {"one_sided": 1},
    "speck": {"components": 2},
    "holed": {"boundary": 1},
}
MEANT = {"boundary", "components", "touching_vertices"}


@pytest.mark.parametrize("case", FOUND)
def test_finds_the_defect_and_no_other(defective, case):
    report = examine(defective(case))
    found = {each.spec.id: each.found.count for each in report.findings}
    assert {id_: n for id_, n in found.items() if id_ not in MEANT - FOUND[case].keys()} == (
        FOUND[case]
    )
    assert report.is_sound == (not report.defects)


@pytest.mark.parametrize("make", [primitives.tetrahedron, primitives.sphere, primitives.torus])
def test_finds_nothing_in_a_sound_surface(make):
    report = examine(make())
    assert report.findings == ()
    assert report.is_sound
    assert report.components == 1
    assert report.boundary_loops == 0
    assert report.count("boundary") == 0


def test_says_where(defective):
    report = examine(defective("bow_tie"))
    (finding,) = report.defects
    assert finding.found.vertices.tolist() == [0]
    assert finding.found.text == "1 vertex joins pieces of surface that touch only there."
    assert finding.repair == "split"


@pytest.mark.parametrize("case", FOUND)
def test_places_are_vertices_of_the_mesh_in_order(defective, case):
    mesh = defective(case)
    for finding in examine(mesh).findings:
        vertices = finding.found.vertices
        assert len(vertices)
        assert (np.diff(vertices) > 0).all()
        assert 0 <= vertices[0] <= vertices[-1] < len(mesh.vertices)


def test_every_finding_declares_itself_fully():
    for spec in FINDINGS:
        assert all((spec.id, spec.title, spec.meaning.endswith(".")))
        assert repair_for(spec) in {"", *REPAIRS}
    assert len({spec.id for spec in FINDINGS}) == len(FINDINGS)


def test_two_holes_that_touch_have_one_boundary():
    grid = primitives.grid(6, 6)
    middle = grid.vertices[grid.faces].mean(axis=1)
    # Two unit squares that share only a corner.
    holes = ((middle[:, :2] > 1) & (middle[:, :2] < 2)).all(axis=1)
    holes |= ((middle[:, :2] > 2) & (middle[:, :2] < 3)).all(axis=1)
    report = examine(TriangleMesh(grid.vertices, grid.faces[~holes]))
    assert report.count("pinched_vertices") == 1
    assert report.boundary_loops == 2


def test_a_hollow_keeps_its_inner_wall():
    ball = primitives.sphere(1)
    m = len(ball.vertices)
    wall = ball.faces[:, ::-1] + m
    vertices = np.concatenate([ball.vertices, 0.5 * ball.vertices])
    hollow = TriangleMesh(vertices, np.concatenate([ball.faces, wall]))
    assert examine(hollow).is_sound


def test_vertices_that_only_touch_are_a_note(shared_models):
    from core.io import load_mesh

    report = examine(load_mesh(shared_models / "cow_2904.off"))
    assert report.is_sound
    assert report.count("touching_vertices") == 2
    assert report.genus == 0


@pytest.mark.parametrize("scale", [1e-9, 1, 1e9])
def test_does_not_depend_on_the_units(defective, scale):
    for case in FOUND:
        mesh = defective(case)
        scaled = mesh.with_vertices(scale * mesh.vertices)
        assert [f.found.text for f in examine(scaled).findings] == [
            f.found.text for f in examine(mesh).findings
        ]


@pytest.mark.parametrize(
    ("file", "expected"),
    [
        ("teapot_3644.obj", {"duplicate_vertices": 403, "pinched_vertices": 38}),
        ("scan_photogram_owl_12442.vtp", {"nonmanifold_edges": 1}),
        ("spider_4670.ply", {"nonmanifold_edges": 2, "pinched_vertices": 2}),
        ("cow_2903.obj", {"pinched_vertices": 1}),
        ("awkward/bunny_res2_nonmanifold.ply", {"nonmanifold_edges": 150, "duplicate_faces": 87}),
        ("awkward/blobby_shuffled_winding.off", {"winding": 3069}),
        ("awkward/degenerate_faces.off", {"degenerate_faces": 4}),
        ("awkward/many_small_holes.ply", {"pinched_vertices": 6}),
        ("awkward/nonmanifold_hole.ply", {"pinched_vertices": 5}),
        ("awkward/knot2_2comps.off", {}),
        ("awkward/double_torus_quads.off", {}),
    ],
)
def test_finds_in_the_models_what_their_index_says(shared_models, file, expected):
    from core.io import load_mesh

    report = examine(load_mesh(shared_models / file))
    assert {f.spec.id: f.found.count for f in report.defects} == expected
