"""VTK's formats: what its readers give, and that they cannot take anything else down."""

import sys

import numpy as np
import pytest

from core.io import LoadError, load_mesh, read_mesh, vtk_polydata

STRIP = ("POLYGONS 1 5\n4 0 1 2 3", "TRIANGLE_STRIPS 1 5\n4 0 1 3 2")


def test_strips_alternate_their_winding(squares, write):
    text = squares["old.vtk"].decode().replace(*STRIP)
    result = read_mesh(write("strip.vtk", text))
    assert result.mesh.faces.tolist() == [[0, 1, 3], [3, 1, 2]]
    assert result.report == ("1 triangle strip cut into 2 faces",)


@pytest.mark.parametrize(
    ("name", "old", "new", "reason"),
    [
        ("old.vtk", "POINTS 4", "POINTS 4000000000", "VTK cannot read it"),
        ("old.vtk", "POLYGONS 1 5", "POLYGONS 4000000000 16000000000", "VTK cannot read it"),
        ("old.vtk", "4 0 1 2 3", "4 0 1 2 9", "face 0 names vertex 9; allowed are 0 to 3"),
        ("old.vtk", "1 1 0", "1 nan 0", "coordinates must be finite"),
        ("old.vtk", "POLYDATA", "UNSTRUCTURED_GRID", "its data set is UNSTRUCTURED_GRID"),
        ("old.vtk", "# vtk", "# kvt", "it does not begin with '# vtk DataFile'"),
        ("new.vtp", 'NumberOfPoints="4"', 'NumberOfPoints="4000000000"', "VTK cannot read it"),
        ("new.vtp", "</Polys>", "</Pollys>", "VTK cannot read it"),
        ("new.vtp", '"PolyData"', '"ImageData"', "its VTKFile is of another type"),
        ("new.vtp", "<VTKFile", "<KVTFile", "it has no element <VTKFile>"),
    ],
)
def test_bad_files_are_refused(name, old, new, reason, squares, write):
    with pytest.raises(LoadError, match=reason):
        load_mesh(write(name, squares[name].decode().replace(old, new, 1)))


def test_a_reader_that_does_not_end_is_stopped(squares, write, monkeypatch, tmp_path):
    worker = tmp_path / "endless.py"
    worker.write_text("while True: pass")
    monkeypatch.setattr(vtk_polydata, "_WORKER", worker)
    monkeypatch.setattr(vtk_polydata, "_SECONDS", 0.2)
    with pytest.raises(LoadError, match="VTK did not get through it in 0 s"):
        load_mesh(write("a.vtk", squares["old.vtk"]))


def test_a_reader_that_crashes_takes_nothing_with_it(squares, write, monkeypatch, tmp_path):
    worker = tmp_path / "crash.py"
    worker.write_text("import os; os.abort()")
    monkeypatch.setattr(vtk_polydata, "_WORKER", worker)
    with pytest.raises(LoadError, match="its reader broke down"):
        load_mesh(write("a.vtk", squares["old.vtk"]))


def test_vtk_stays_out_of_this_process(squares, write):
    before = {name for name in sys.modules if name.startswith("vtkmodules")}
    mesh = load_mesh(write("a.vtp", squares["new.vtp"]))
    assert np.array_equal(mesh.faces, [[0, 1, 2], [0, 2, 3]])
    assert {name for name in sys.modules if name.startswith("vtkmodules")} == before
