"""A disk that is full: one sentence, the old file as it was, nothing half left behind."""

import errno
import os
import subprocess
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

from app.export.bundle import write_comparison
from app.export.outcomes import study_outcomes
from app.export.pictures import PictureError, save_picture
from app.export.plots import error_curves, save_error_plot
from app.export.tables import save_table, study_rows
from app.usage import UsageError
from core.comparison import run
from core.io import SUPPORTED_WRITE, SaveError, save_mesh
from core.mesh import MeshError, primitives
from core.mesh.matrices import laplacian_matrix, save_matrix
from core.skeleton import skeletal_graph, write_graph
from core.study import MethodChoice, Study
from core.study_files import StudyFileError, write_study_file

mpl.use("Agg")

SAID = (SaveError, StudyFileError, PictureError, MeshError, UsageError, OSError)


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    model = tmp_path_factory.mktemp("model") / "ball.ply"
    save_mesh(primitives.sphere(2), model)
    return run(Study(model=str(model), methods=(MethodChoice(method="mean", iterations=1),)))


def write_plot(path, result):
    spec = result.study.metrics["visual_error"]
    curves = error_curves(study_outcomes(result), spec.id)
    save_error_plot(path, curves, result.comparison.noisy_errors[spec.id], spec)


WRITERS = {
    **{f"mesh{suffix}": lambda path, _: save_mesh(primitives.sphere(2), path)
       for suffix in SUPPORTED_WRITE},
    "plain.burnish": lambda path, result: write_study_file(result.study, path),
    "packed.burnish": lambda path, result: write_study_file(result.study, path, packed=True),
    **{f"table.{suffix}": lambda path, result: save_table(path, study_rows(result))
       for suffix in ("csv", "md", "tex")},
    **{f"graph.{suffix}": lambda path, _: write_graph(skeletal_graph(primitives.sphere(2)), path)
       for suffix in ("graphml", "json", "obj", "csv", "swc")},
    **{f"matrix.{suffix}": lambda path, _: save_matrix(
        laplacian_matrix(primitives.sphere(2)), path) for suffix in ("mtx", "npz")},
    **{f"plot.{suffix}": write_plot for suffix in ("svg", "pdf", "png")},
    "picture.png": lambda path, _: save_picture(np.zeros((9, 9, 3), np.uint8), path),
}  # fmt: skip


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 256 KB in memory."""
    place = tmp_path / "disk"
    place.mkdir()
    words = ["mount", "-t", "tmpfs", "-o", "size=256k", "none", str(place)]
    try:
        mounted = subprocess.run(words, capture_output=True, check=False).returncode == 0
    except FileNotFoundError:
        mounted = False
    if not mounted:
        pytest.skip("a small file system cannot be mounted by this user")
    yield place
    subprocess.run(["umount", str(place)], check=True)


def fill(disk: Path) -> None:
    size = os.statvfs(disk)
    (disk / "filler").write_bytes(bytes(size.f_bavail * size.f_frsize))


def refused(name: str, path: Path, result) -> str:
    with pytest.raises(SAID) as caught:
        WRITERS[name](path, result)
    return str(caught.value)


@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_leaves_the_old_file_and_nothing_else(name, small_disk, result):
    path = small_disk / name
    path.write_bytes(b"old" * 100)
    fill(small_disk)
    before = sorted(small_disk.iterdir())
    sentence = refused(name, path, result)
    assert "No space left on device" in sentence
    assert "\n" not in sentence
    assert path.read_bytes() == b"old" * 100
    assert sorted(small_disk.iterdir()) == before


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EIO, errno.EDQUOT])
def test_a_disk_that_fails_when_asked_to_keep_is_told(number, name, tmp_path, result, monkeypatch):
    def fail(_: int) -> None:
        raise OSError(number, os.strerror(number))

    path = tmp_path / name
    path.write_bytes(b"old")
    monkeypatch.setattr(os, "fsync", fail)
    assert os.strerror(number) in refused(name, path, result)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("name", WRITERS)
def test_a_file_that_another_program_holds_is_told(name, tmp_path, result, monkeypatch):
    """As on Windows, where what another program has open cannot be replaced."""

    def fail(source: str | Path, target: str | Path) -> None:
        raise PermissionError(errno.EACCES, "The file is in use by another process", str(target))

    path = tmp_path / name
    path.write_bytes(b"old")
    monkeypatch.setattr(os, "replace", fail)
    assert "in use by another process" in refused(name, path, result)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("name", WRITERS)
def test_a_folder_that_was_removed_is_told(name, tmp_path, result):
    folder = tmp_path / "gone"
    folder.mkdir()
    folder.rmdir()
    assert "\n" not in refused(name, folder / name, result)
    assert not folder.exists()


def test_a_comparison_that_does_not_fit_is_told(small_disk, result):
    fill(small_disk)
    with pytest.raises(SAID, match="No space left on device"):
        write_comparison(result, small_disk / "out")
