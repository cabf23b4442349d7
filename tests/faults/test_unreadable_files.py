"""Files that cannot be read, change under the reader's hands, or kill it."""

import os
import signal
import sys
import tempfile
from pathlib import Path

import pytest

from app.cli import main
from app.session.meshes import MeshReader
from core.io import LoadError, load_mesh, save_mesh, vtk_polydata
from core.mesh import primitives
from core.noise import NoiseParams
from core.study import Study
from core.study_files import StudyFileError, read_study_file

NOBODY = 65534


@pytest.fixture
def as_nobody():
    """Without the superuser's right to read everything, while the test runs."""
    if sys.platform == "win32":
        pytest.skip("this system has no such rights")
    usual = os.geteuid()
    if usual == 0:
        os.seteuid(NOBODY)
    yield
    os.seteuid(usual)


@pytest.fixture
def open_folder():
    """A folder that everybody may enter."""
    with tempfile.TemporaryDirectory() as name:
        os.chmod(name, 0o755)
        yield Path(name)


@pytest.fixture
def locked_file(open_folder):
    path = open_folder / "locked.ply"
    save_mesh(primitives.tetrahedron(), path)
    path.chmod(0)
    return path


@pytest.fixture
def in_locked_folder(open_folder):
    folder = open_folder / "locked"
    folder.mkdir()
    path = folder / "inside.ply"
    save_mesh(primitives.tetrahedron(), path)
    folder.chmod(0)
    yield path
    folder.chmod(0o700)


def test_a_file_without_permission(locked_file, as_nobody):
    with pytest.raises(LoadError, match=r"^locked\.ply: cannot be read \(Permission denied\)\.$"):
        load_mesh(locked_file)


def test_a_folder_without_permission(in_locked_folder, as_nobody):
    with pytest.raises(LoadError, match=r"^inside\.ply: cannot be read \(Permission denied\)\.$"):
        load_mesh(in_locked_folder)
    with pytest.raises(StudyFileError, match=r"^inside\.burnish: cannot be read"):
        read_study_file(in_locked_folder.with_suffix(".burnish"))


def test_a_folder_that_may_not_be_written(open_folder, as_nobody):
    with pytest.raises(ValueError, match=r"^new\.ply: cannot be written \(Permission denied\)\.$"):
        save_mesh(primitives.tetrahedron(), open_folder / "new.ply")


@pytest.mark.parametrize("name", ["two\nlines.ply", "red\x1b[31m.ply", "\udcff.ply", "  a  b .ply"])
def test_strange_names_are_told_in_one_line(name, tmp_path):
    (tmp_path / name).write_text("ply")
    with pytest.raises(LoadError) as caught:
        load_mesh(tmp_path / name)
    assert str(caught.value).isprintable()


@pytest.fixture
def model(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(1), path)
    return path


def study_of(model: Path, seed: int = 0) -> Study:
    return Study(model=str(model), noise=NoiseParams(seed=seed))


def test_a_model_that_is_removed_while_it_is_open_stays_open(model):
    reader = MeshReader(10**9)
    first = reader.read(study_of(model))
    model.unlink()
    again = reader.read(study_of(model, seed=1))
    assert again.comparison.original is first.comparison.original
    assert again.fingerprints == first.fingerprints
    other = MeshReader(10**9)
    with pytest.raises(LoadError, match="there is no such file"):
        other.read(study_of(model))


def test_a_model_that_is_replaced_while_it_is_open_is_read_again(model):
    reader = MeshReader(10**9)
    first = reader.read(study_of(model))
    save_mesh(primitives.torus(), model)
    os.utime(model, ns=(5, 5))
    again = reader.read(study_of(model, seed=1))
    assert again.comparison.original.genus == 1
    assert again.fingerprints != first.fingerprints


def test_a_model_that_is_cut_while_it_is_open_is_told(model):
    reader = MeshReader(10**9)
    reader.read(study_of(model))
    model.write_bytes(model.read_bytes()[:500])
    with pytest.raises(LoadError, match=r"ball\.ply: the file is cut short"):
        reader.read(study_of(model, seed=1))


@pytest.mark.parametrize("change", [Path.unlink, lambda path: os.utime(path, ns=(7, 7))])
def test_a_model_that_changes_while_it_is_read_is_not_believed(change, model, monkeypatch):
    from app.session import meshes

    usual = meshes.read_model

    def read(name):
        loaded = usual(name)
        change(Path(name))
        return loaded

    monkeypatch.setattr(meshes, "read_model", read)
    with pytest.raises(LoadError, match=r"^ball\.ply: has changed while it was read; open it ag"):
        MeshReader(10**9).read(study_of(model))


@pytest.mark.parametrize("number", [signal.SIGSEGV, signal.SIGKILL, signal.SIGABRT])
def test_a_crash_of_a_reader_is_one_line_of_the_command_line(number, tmp_path, monkeypatch, capsys):
    worker = tmp_path / "crash.py"
    worker.write_text(f"import os; os.kill(os.getpid(), {int(number)})")
    monkeypatch.setattr(vtk_polydata, "_WORKER", worker)
    path = tmp_path / "a.vtk"
    path.write_text("# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\n")
    with pytest.raises(SystemExit) as stop:
        main(["stats", str(path)])
    said = capsys.readouterr()
    assert (stop.value.code, said.out) == (2, "")
    assert said.err == "burnish: a.vtk: VTK cannot read it (its reader broke down).\n"
