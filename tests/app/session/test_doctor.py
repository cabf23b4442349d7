"""The doctor of a session: reports, repairs as steps that can be undone, and what is told."""

import queue
import time

import numpy as np
import pytest

from app.session import Session
from app.session.doctor import REPAIR_ALL, Doctor
from core.io import save_mesh
from core.mesh import TriangleMesh, primitives
from core.noise import NoiseParams
from core.study import MethodChoice, Study

_LONG = 60.0


class Practice:
    """A session with its doctor, and the thread that owns both."""

    def __init__(self):
        self.calls = queue.Queue()
        self.session = Session(self.calls.put)
        self.doctor = Doctor(self.session)
        self.told, self.failed = [], []
        self.session.notified.connect(self.told.append)
        self.session.failed.connect(self.failed.append)

    def work_until(self, condition):
        end = time.monotonic() + _LONG
        while not condition():
            self.calls.get(timeout=max(end - time.monotonic(), 0.01))()

    def rest(self):
        self.work_until(lambda: self.session.activity is None and not self.doctor.is_busy)

    def open(self, path, **update):
        choices = (MethodChoice(method="laplacian", iterations=2),)
        self.session.apply(Study(model=str(path), methods=choices, **update), "Open")
        self.work_until(lambda: self.doctor.report is not None)
        self.rest()

    @property
    def faces(self):
        return len(self.session.meshes.comparison.original.faces)


@pytest.fixture
def practice():
    practice = Practice()
    yield practice
    practice.session.close()


@pytest.fixture
def bad_file(tmp_path):
    """A sphere with a face twice, and three faces turned round."""
    ball = primitives.sphere(2)
    faces = ball.faces.copy()
    faces[:3] = faces[:3, ::-1]
    path = tmp_path / "bad.ply"
    save_mesh(TriangleMesh(ball.vertices, np.concatenate([faces, faces[100:101]])), path)
    return path


def test_examines_what_is_opened(practice, bad_file):
    practice.open(bad_file)
    assert {finding.spec.id for finding in practice.doctor.report.defects} == {
        "duplicate_faces",
        "nonmanifold_edges",
        "winding",
    }


def test_a_repair_is_a_step_that_says_what_it_changed(practice, bad_file):
    practice.open(bad_file)
    practice.doctor.repair("duplicate_faces", {})
    assert practice.doctor.is_busy
    practice.rest()
    assert practice.faces == 320
    assert practice.told[-1] == "Removed 1 face that lay on others."
    assert practice.doctor.changes == ("Removed 1 face that lay on others.",)
    assert practice.session.history.undo_name == "Remove duplicate faces"
    assert practice.doctor.report.count("duplicate_faces") == 0


def test_undo_and_redo_bring_mesh_and_report_back(practice, bad_file):
    practice.open(bad_file)
    before = practice.doctor.report.count("winding")
    practice.doctor.repair_all()
    practice.rest()
    assert practice.doctor.report.is_sound
    assert practice.session.history.undo_name == REPAIR_ALL
    practice.session.undo()
    practice.rest()
    assert practice.doctor.report.count("winding") == before
    assert practice.faces == 321
    assert practice.doctor.changes == ()
    practice.session.redo()
    practice.rest()
    assert practice.doctor.report.is_sound
    assert len(practice.doctor.changes) == len(practice.session.study.repairs) == 2


def test_a_repair_that_changes_nothing_is_no_step(practice, bad_file):
    practice.open(bad_file)
    practice.doctor.repair("fill_holes", {})
    practice.rest()
    assert practice.told[-1] == "Nothing to change."
    assert practice.session.study.repairs == ()
    assert practice.session.history.undo_name is None


def test_other_noise_keeps_the_repaired_topology(practice, bad_file):
    practice.open(bad_file)
    practice.doctor.repair_all()
    practice.rest()
    mesh, report = practice.session.meshes.comparison.original, practice.doctor.report
    noise = NoiseParams(sigma=0.3)
    practice.session.apply(practice.session.study.model_copy(update={"noise": noise}), "Noise")
    practice.rest()
    assert practice.session.study.noise == noise
    assert practice.session.meshes.comparison.original is mesh
    assert practice.doctor.report is report


def test_a_repair_that_cannot_be_done_is_refused_and_all_stays(practice, tmp_path):
    path = tmp_path / "line.off"
    path.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n")
    practice.open(path)
    practice.doctor.repair("degenerate_faces", {})
    practice.rest()
    assert "no face" in practice.failed[-1]
    assert practice.session.study.repairs == ()
    assert practice.faces == 1


def test_a_separate_noisy_file_is_repaired_too(practice, bad_file, tmp_path):
    noisy = tmp_path / "noisy.ply"
    save_mesh(TriangleMesh(1.1 * (m := _mesh(bad_file)).vertices, m.faces), noisy)
    practice.open(bad_file, noisy=str(noisy))
    practice.doctor.repair_all()
    practice.rest()
    pair = practice.session.meshes.comparison
    assert np.allclose(pair.noisy.vertices, 1.1 * pair.original.vertices)
    assert pair.noisy.topology is pair.original.topology


def _mesh(path):
    from core.io import load_mesh

    return load_mesh(path)


def endless(*_):
    """Work that does not end by itself."""
    while True:
        yield


def test_a_cancelled_examination_can_be_done_after_all(practice, bad_file, monkeypatch):
    monkeypatch.setattr("app.session.doctor.examination_steps", endless)
    choices = (MethodChoice(method="laplacian", iterations=2),)
    practice.session.apply(Study(model=str(bad_file), methods=choices), "Open")
    practice.work_until(lambda: practice.doctor.is_busy)
    practice.session.cancel()
    practice.work_until(lambda: practice.doctor.is_cancelled)
    assert not practice.doctor.is_busy
    monkeypatch.undo()
    practice.doctor.resume()
    practice.work_until(lambda: practice.doctor.report is not None)
    assert not practice.doctor.is_cancelled


@pytest.mark.parametrize("where", ["app.session.doctor", "app.session.meshes"])
def test_a_repair_that_is_cancelled_between_its_steps_changes_nothing(
    practice, bad_file, monkeypatch, where
):
    """While it is looked whether it changes anything, and while the mesh is repaired."""
    practice.open(bad_file)
    monkeypatch.setattr(f"{where}.repair_steps", endless)
    practice.doctor.repair("duplicate_faces", {})
    if where == "app.session.meshes":
        practice.work_until(lambda: practice.session.is_loading)
    practice.session.cancel()
    practice.rest()
    assert (practice.faces, practice.session.study.repairs) == (321, ())
    monkeypatch.undo()
    practice.doctor.repair("duplicate_faces", {})
    practice.rest()
    assert practice.faces == 320
