"""Work that fails beside the window: one sentence, the study as it was, and on it goes."""

import os

import numpy as np
import pytest
from PySide6.QtWidgets import QMessageBox

from core.smoothing import METHODS
from core.study_files import read_study_file


def told(user):
    """Close the message that is shown, and return what it said."""
    user.wait(lambda: boxes(user))
    box = boxes(user)[0]
    text = box.text()
    box.close()
    return text


def boxes(user):
    return [box for box in user.window.findChildren(QMessageBox) if box.isVisible()]


def test_a_reader_that_crashes_does_not_take_the_window_with_it(
    user, ball_file, tmp_path, monkeypatch
):
    from core.io import vtk_polydata

    worker = tmp_path / "crash.py"
    worker.write_text("import os; os.abort()")
    monkeypatch.setattr(vtk_polydata, "_WORKER", worker)
    path = tmp_path / "a.vtk"
    path.write_text("# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\n")
    user.open(ball_file)
    user.window.open_model(str(path))
    assert told(user) == "a.vtk: VTK cannot read it (its reader broke down)."
    user.rest()
    assert user.window.windowTitle().startswith("ball.ply")


def test_a_method_without_memory_is_one_sentence(user, ball_file, monkeypatch):
    def hungry(mesh, params):
        yield np.zeros((1 << 55, 3))

    spec = METHODS["laplacian"]
    user.open(ball_file)
    study = user.window.session.study
    broken = type(spec)(**{**vars(spec), "steps": hungry})
    monkeypatch.setitem(METHODS, "laplacian", broken)
    user.denoise.methods.blocks["laplacian"].check.setChecked(True)
    assert told(user).startswith("There is not enough memory for that.")
    user.window.session.undo()
    user.rest()
    assert user.window.session.study == study


@pytest.mark.parametrize("word", ["No space left on device", "Input/output error"])
def test_a_study_that_cannot_be_saved_stays_unsaved(user, ball_file, tmp_path, monkeypatch, word):
    user.open(ball_file)
    path = tmp_path / "first.burnish"
    user.window.files._write(path, False, lambda: None)
    user.wait(lambda: user.window.windowTitle().startswith("first.burnish "))
    user.type_iterations("mean", 9)
    user.rest()

    def fail(_):
        raise OSError(28 if "space" in word else 5, word)

    monkeypatch.setattr(os, "fsync", fail)
    user.window.files.save()
    assert word in told(user)
    monkeypatch.undo()
    assert user.window.windowTitle().startswith("first.burnish* ")
    assert read_study_file(path).study.choice("mean").iterations != 9
    user.window.files.save()
    user.wait(lambda: user.window.windowTitle().startswith("first.burnish "))
    assert read_study_file(path).study.choice("mean").iterations == 9
