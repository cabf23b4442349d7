"""Writing: exact, whole or not at all, and readable by other programs."""

import os
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from core.io import SUPPORTED_WRITE, SaveError, load_mesh, read_mesh, save_mesh
from core.mesh import TriangleMesh
from core.whole_files import write_atomically

EXACT = [".ply", ".obj", ".off"]
FACES = [[0, 1, 2], [3, 2, 1], [4, 0, 3]]


@pytest.mark.parametrize("suffix", EXACT)
@given(
    vertices=arrays(np.float64, (5, 3), elements=st.floats(allow_nan=False, allow_infinity=False))
)
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_every_finite_number_comes_back_exactly(suffix, vertices, tmp_path):
    path = tmp_path / f"mesh{suffix}"
    save_mesh(TriangleMesh(vertices, FACES), path)
    result = read_mesh(path)
    assert result.mesh.vertices.tobytes() == vertices.tobytes()
    assert result.mesh.faces.tolist() == FACES
    assert result.report == ()


@pytest.mark.parametrize("suffix", EXACT)
def test_coincident_vertices_stay_apart(suffix, tmp_path):
    mesh = TriangleMesh(np.zeros((5, 3)), FACES)
    save_mesh(mesh, tmp_path / f"mesh{suffix}")
    assert len(load_mesh(tmp_path / f"mesh{suffix}").vertices) == 5


def test_stl_gives_the_same_surface_in_32_bits(ball, tmp_path):
    save_mesh(ball, tmp_path / "ball.stl")
    mesh = load_mesh(tmp_path / "ball.stl")
    assert len(mesh.vertices) == len(ball.vertices)
    assert mesh.genus == 0
    corners = ball.vertices[ball.faces].astype(np.float32)
    assert np.array_equal(mesh.vertices[mesh.faces], corners)


@pytest.mark.parametrize("suffix", SUPPORTED_WRITE)
def test_another_program_reads_the_same_mesh(suffix, ball, tmp_path):
    path = tmp_path / f"ball{suffix}"
    save_mesh(ball, path)
    other = trimesh.load_mesh(path, process=False)
    assert other.vertices[other.faces] == pytest.approx(ball.vertices[ball.faces], abs=1e-6)
    assert other.volume == pytest.approx(trimesh.Trimesh(ball.vertices, ball.faces).volume)


def refused(mesh, path) -> str:
    with pytest.raises(SaveError) as caught:
        save_mesh(mesh, path)
    return str(caught.value)


def test_an_unknown_suffix(ball, tmp_path):
    message = "ball.glb: files of this kind are not written; allowed are .ply .obj .off .stl."
    assert refused(ball, tmp_path / "ball.glb") == message


def test_a_missing_folder(ball, tmp_path):
    folder = tmp_path / "none"
    assert refused(ball, folder / "ball.ply") == f"ball.ply: there is no folder {folder}."


def test_a_folder_of_that_name(ball, tmp_path):
    (tmp_path / "ball.ply").mkdir()
    assert refused(ball, tmp_path / "ball.ply") == "ball.ply: a folder has this name."


@pytest.mark.parametrize("step", ["open", "replace"])
def test_a_refusal_of_the_system_leaves_the_old_file_and_nothing_else(
    step, ball, tmp_path, monkeypatch
):
    def deny(*_args: object, **_options: object) -> None:
        raise OSError(28, "No space left on device")

    (tmp_path / "ball.ply").write_text("old")
    monkeypatch.setattr(Path, step, deny)
    message = refused(ball, tmp_path / "ball.ply")
    monkeypatch.undo()
    assert message == "ball.ply: cannot be written (No space left on device)."
    assert [path.name for path in tmp_path.iterdir()] == ["ball.ply"]
    assert (tmp_path / "ball.ply").read_text() == "old"


def test_a_file_is_replaced_and_a_link_stays_a_link(ball, tmp_path):
    (tmp_path / "real.ply").write_text("old")
    os.symlink(tmp_path / "real.ply", tmp_path / "link.ply")
    save_mesh(ball, str(tmp_path / "link.ply"))
    assert (tmp_path / "link.ply").is_symlink()
    assert len(load_mesh(tmp_path / "real.ply").faces) == len(ball.faces)


def test_the_new_file_has_the_usual_permissions(ball, tmp_path):
    (tmp_path / "plain").write_text("")
    write_atomically(tmp_path / "new", b"content")
    assert (tmp_path / "new").stat().st_mode == (tmp_path / "plain").stat().st_mode
