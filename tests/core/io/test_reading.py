"""What is said about files that cannot even be opened, and the report of those that can."""

import os
from pathlib import Path

import pytest

from core.io import LoadedMesh, LoadError, load_mesh, read_mesh, reading
from core.mesh import TriangleMesh


def refused(path) -> str:
    with pytest.raises(LoadError) as caught:
        read_mesh(path)
    return str(caught.value)


def test_a_missing_file(tmp_path):
    assert refused(tmp_path / "none.ply") == "none.ply: there is no such file."


def test_a_folder(tmp_path):
    folder = tmp_path / "folder.ply"
    folder.mkdir()
    assert refused(folder) == "folder.ply: this is a folder, not a file."
    assert refused("/") == "/: this is a folder, not a file."


def test_an_unknown_suffix(write):
    message = refused(write("mesh.docx", "x"))
    assert message == (
        "mesh.docx: files of this kind are not read; "
        "allowed are .ply .obj .off .stl .glb .gltf .vtp .vtk .3mf."
    )


def test_a_pipe_is_not_waited_for(tmp_path):
    if not hasattr(os, "mkfifo"):
        pytest.skip("this system has no named pipes")
    os.mkfifo(tmp_path / "pipe.ply")
    assert refused(tmp_path / "pipe.ply") == "pipe.ply: this is not an ordinary file."


def test_no_permission(write, monkeypatch):
    """Caused by hand, because the superuser may read everything."""

    def deny(path: Path) -> bytes:
        raise PermissionError(13, "Permission denied", str(path))

    path = write("secret.obj", "v 0 0 0\n")
    monkeypatch.setattr(Path, "read_bytes", deny)
    assert refused(path) == "secret.obj: cannot be read (Permission denied)."


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (MemoryError(), "a.obj: needs more memory than there is."),
        (RuntimeError("first\nsecond"), "a.obj: is not well-formed (first second)."),
        (AssertionError(), "a.obj: is not well-formed (its parts do not fit together)."),
        (KeyError("count"), "a.obj: is not well-formed ('count' is missing or unknown)."),
    ],
)
def test_whatever_a_reader_raises_becomes_one_sentence(error, message, write, monkeypatch):
    def fail(_path: Path) -> None:
        raise error

    monkeypatch.setitem(reading._READERS, ".obj", fail)
    path = write("a.obj", "v")
    assert refused(path) == message


def test_the_summary_is_one_line(write):
    content = "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 3 4 5\n"
    result = read_mesh(str(write("quad.obj", content)))
    assert isinstance(result, LoadedMesh)
    assert isinstance(result.mesh, TriangleMesh)
    assert result.name == "quad.obj"
    assert result.summary == "1 polygon triangulated; 1 unreferenced vertex dropped"
    assert load_mesh(write("same.obj", content)).faces.tolist() == result.mesh.faces.tolist()


def test_nothing_to_report_gives_an_empty_summary(write):
    assert not read_mesh(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).summary
