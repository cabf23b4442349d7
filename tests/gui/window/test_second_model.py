"""A second model from a file, in the Statistics tab: saved with the study, and asked for."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox

from core.io import save_mesh
from core.mesh import primitives
from core.study import Study
from core.study_files import write_study_file


@pytest.fixture
def second(user):
    return user.window.statistics.second


@pytest.fixture
def ring(user, second, tmp_path):
    """File of a torus, laid over the model of a study that was saved and left."""
    path = tmp_path / "ring.ply"
    save_mesh(primitives.torus(), path)
    write_study_file(Study(methods=()), tmp_path / "first.burnish")
    user.window.files.open(str(tmp_path / "first.burnish"))
    user.rest()
    second.choose(str(path))
    user.wait(second.model)
    user.press(Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    user.wait(lambda: not user.window.files.documents.is_modified)
    second.choose("none")
    return path


def open_again(user, path):
    """Open the study again as it was saved."""
    user.window.files.open(str(path.with_name("first.burnish")))
    assert "Save the changes" in answer(user, "Discard")


def answer(user, word):
    """Click the button of the open question whose text has a word; return what was asked."""
    boxes = lambda: [b for b in user.window.findChildren(QMessageBox) if b.isVisible()]  # noqa: E731
    user.wait(boxes)
    box = boxes()[-1]
    text = box.text()
    button = next(b for b in box.buttons() if word in b.text().replace("&", ""))
    user.qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    return text


def test_it_is_saved_with_the_study(user, second, ring):
    open_again(user, ring)
    user.wait(lambda: second.chosen == str(ring) and second.model())
    assert second.model().name == "ring"
    assert not user.window.files.documents.is_modified


def test_where_it_is_missing_it_is_asked_for(user, second, ring):
    moved = ring.rename(ring.with_name("moved.ply"))
    open_again(user, ring)
    assert "its second model ring.ply is not at" in answer(user, "Choose")
    user.answer_file_dialog(moved)
    user.wait(lambda: second.chosen == str(moved) and second.model())


def test_the_study_can_be_opened_without_it(user, second, ring):
    second.choose("noisy")
    ring.unlink()
    open_again(user, ring)
    assert "its second model ring.ply is not at" in answer(user, "without it")
    user.wait(lambda: second.chosen == "none")
    assert user.window.windowTitle().startswith("first.burnish ")


def test_where_it_has_changed_it_is_read_again_when_accepted(user, second, ring):
    save_mesh(primitives.tetrahedron(), ring)
    open_again(user, ring)
    assert "its second model ring.ply is not the one" in answer(user, "anyway")
    user.wait(lambda: second.chosen == str(ring) and len(second.model().mesh.vertices) == 4)
