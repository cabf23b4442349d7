"""Work that fails beside the window: what is told, and that the session goes on."""

import queue

import numpy as np
import pytest

from app.session import Job, Session
from core.io import save_mesh
from core.mesh import primitives
from core.smoothing import METHODS
from core.study import MethodChoice, Study


class Owner:
    """The thread of a session, without a window."""

    def __init__(self, model):
        self.calls = queue.Queue()
        self.session = Session(self.calls.put)
        self.failed, self.broken = [], []
        self.session.failed.connect(self.failed.append)
        self.session.broken.connect(self.broken.append)
        choice = MethodChoice(method="mean", iterations=1)
        self.session.apply(Study(model=str(model), methods=(choice,)), "Open")
        self.wait(lambda: self.session.meshes and self.session.activity is None)

    def wait(self, condition):
        while not condition():
            self.calls.get(timeout=60)()

    def run(self, work):
        """Carry out a job, and wait for its end."""
        ended = []
        job = Job(work, on_error=self.session.report, on_done=lambda: ended.append(True), title="x")
        self.session.jobs.start(job)
        self.wait(lambda: ended)


@pytest.fixture
def owner(tmp_path):
    save_mesh(primitives.sphere(2), tmp_path / "ball.ply")
    owner = Owner(tmp_path / "ball.ply")
    yield owner
    owner.session.close()


def failing(error):
    raise error
    yield


def hungry():
    yield np.zeros(1 << 60, np.uint8)


def test_numpy_without_memory_is_one_sentence(owner):
    study = owner.session.study
    owner.run(hungry())
    assert len(owner.failed) == 1
    assert owner.failed[0].startswith("There is not enough memory for that.")
    assert not owner.broken
    assert owner.session.study == study


@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        (MemoryError(), "There is not enough memory for that. What was open is as it was;"),
        (OSError(28, "No space left on device", "/far/away/a.ply"), "a.ply: No space left on dev"),
        (OSError("odd"), "odd."),
        (ChildProcessError("Its own process has ended"), "Its own process has ended."),
        (ValueError("a.ply: it is cut short."), "a.ply: it is cut short."),
        (ValueError(), "ValueError"),
    ],
)
def test_what_is_not_the_programs_fault_is_one_sentence(error, sentence, owner):
    owner.run(failing(error))
    assert owner.failed[0].startswith(sentence)
    assert not owner.broken


@pytest.mark.parametrize(
    "error", [RuntimeError("x"), RecursionError(), ZeroDivisionError(), KeyError("x"), Exception()]
)
def test_a_fault_of_the_program_is_reported_as_one(error, owner):
    owner.run(failing(error))
    assert owner.broken == [error]
    assert not owner.failed


@pytest.mark.parametrize("error", [MemoryError(), RuntimeError("x"), OSError(5, "I/O error")])
def test_after_a_method_fails_the_session_goes_on(error, owner, monkeypatch):
    def fail(mesh, params):
        yield mesh.vertices
        raise error

    spec = METHODS["laplacian"]
    broken = type(spec)(**{**vars(spec), "steps": fail})
    monkeypatch.setitem(METHODS, "laplacian", broken)
    session = owner.session
    before = session.study
    choice = MethodChoice(method="laplacian", iterations=3)
    session.apply(session.study.with_choice(choice), "Laplacian")
    owner.wait(lambda: owner.failed or owner.broken)
    owner.wait(lambda: session.activity is None)
    assert session.run("laplacian").computed == 1
    session.undo()
    assert session.study == before
    session.apply(session.study.with_choice(MethodChoice(method="mean", iterations=4)), "Mean")
    owner.wait(lambda: session.run("mean").computed == 4)
    assert len(owner.failed) + len(owner.broken) == 1
