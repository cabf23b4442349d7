"""Which file a study belongs to, across undo and redo, in a session of any length."""

import gc
import queue
from pathlib import Path

import pytest

from app.session import Session, history
from app.session.documents import Document, Documents
from core.io import save_mesh
from core.mesh import primitives
from core.study import Study

STEPS = 6


class Reader:
    """Someone who opens one study after another and goes back and forth."""

    def __init__(self, folder):
        self._calls = queue.Queue()
        self.session = Session(self._calls.put)
        self.documents = Documents(self.session)
        self.models = [folder / "ball.ply", folder / "torus.ply"]
        for path, mesh in zip(self.models, (primitives.sphere(1), primitives.torus()), strict=True):
            save_mesh(mesh, path)

    def open(self, number):
        study = Study(model=str(self.models[number % 2]), methods=())
        document = Document(Path(f"{number}.burnish"), saved=study)
        self.documents.open(study, document, f"Open {number}")
        self._rest()

    def travel(self, way):
        getattr(self.session, way)()
        self._rest()
        return self.documents.current.path.name

    def _rest(self):
        while self.session.activity is not None:
            self._calls.get(timeout=60)()


@pytest.fixture
def reader(tmp_path, monkeypatch):
    monkeypatch.setattr(history, "_STEPS", STEPS)
    reader = Reader(tmp_path)
    yield reader
    reader.session.close()


def kept_studies():
    gc.collect()
    return sum(isinstance(each, Study) for each in gc.get_objects())


def test_undo_and_redo_bring_the_documents_back(reader):
    for number in range(2 * STEPS):
        reader.open(number)
    back = [reader.travel("undo") for _ in range(STEPS)]
    assert back == [f"{2 * STEPS - 2 - k}.burnish" for k in range(STEPS)]
    assert [reader.travel("redo") for _ in range(STEPS)] == [
        f"{STEPS + k}.burnish" for k in range(STEPS)
    ]
    reader.travel("undo")
    reader.open(99)
    assert reader.documents.current.path.name == "99.burnish"
    assert reader.travel("undo") == f"{2 * STEPS - 2}.burnish"


def test_studies_that_no_undo_comes_to_are_not_kept(reader):
    for number in range(2 * STEPS):
        reader.open(number)
    before = kept_studies()
    for number in range(2 * STEPS, 6 * STEPS):
        reader.open(number)
    assert kept_studies() <= before + 2
