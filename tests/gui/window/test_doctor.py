"""The mesh doctor by mouse: read, point out, repair, undo, redo, save, open again."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.ui.doctor_dialog import DoctorDialog
from core.doctor import FINDINGS
from core.io import save_mesh
from core.mesh import TriangleMesh, primitives
from core.study_files import read_study_file

pytestmark = pytest.mark.gui

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def bad_file(tmp_path):
    """A sphere with a face twice and a hole around a vertex."""
    ball = primitives.sphere(3)
    faces = ball.faces[(ball.faces != 300).all(axis=1)]
    used = np.arange(len(ball.vertices)) != 300
    faces = (np.cumsum(used) - 1)[np.concatenate([faces, faces[50:51]])]
    path = tmp_path / "bad.ply"
    save_mesh(TriangleMesh(ball.vertices[used], faces), path)
    return path


@pytest.fixture
def doctor(user, bad_file):
    """The doctor's dialog on a bad model, opened by the sign in the model panel."""
    user.open(bad_file)
    sign = user.denoise.model.sign
    user.wait(lambda: sign.text() == "2 kinds of defects …")
    click(user, sign)
    user.wait(lambda: dialogs(user))
    return dialogs(user)[0]


def dialogs(user):
    return [d for d in user.window.findChildren(DoctorDialog) if d.isVisible()]


def click(user, button):
    user.qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def card(doctor, id_):
    return next(card for card in doctor.cards if card.finding.spec.id == id_)


def close(user, doctor):
    doctor.close()
    user.window.activateWindow()
    user.qtbot.waitUntil(user.window.isActiveWindow)


def settled(user, doctor, faces):
    model = user.window.denoise.model
    user.wait(lambda: not model.doctor.is_busy and model.facts["faces"].text() == faces)
    user.rest()


def numbers(user):
    """Counts of the model, and every error of every run."""
    session = user.window.session
    methods = [choice.method for choice in session.study.methods if choice.enabled]
    original = session.meshes.comparison.original
    errors = {method: session.run(method).errors for method in methods}
    return len(original.vertices), len(original.faces), errors


def test_reads_in_words(doctor):
    assert doctor.name.text() == "bad.ply"
    assert doctor.headline.text().startswith("641 vertices, 1,275 faces, 1 component")
    assert [c.text.text() for c in doctor.cards] == [
        "1 face lies exactly on an earlier one.",
        "3 edges belong to more than two faces, at 3 vertices.",
        "1 boundary loop with 6 edges; 1 small hole to fill.",
    ]
    found = {"Duplicate faces", "Non-manifold edges", "Open boundary"}
    assert set(doctor.checks.titles) == {spec.title for spec in FINDINGS} - found
    assert doctor.height() > 600
    assert "finite" in card(doctor, "duplicate_faces").meaning.text()


def test_the_shortcut_opens_it_once(user, doctor):
    user.press(Qt.Key.Key_D, CONTROL)
    assert dialogs(user) == [doctor]


def test_a_sound_model_is_a_quiet_tick(user, ball_file):
    user.open(ball_file)
    user.wait(lambda: user.denoise.model.sign.text() == "No defects")
    user.press(Qt.Key.Key_D, CONTROL)
    user.wait(lambda: dialogs(user))
    doctor = dialogs(user)[0]
    assert doctor.verdict.text() == "Nothing is wrong with this mesh."
    assert not doctor.repair_all.isEnabled()
    assert set(doctor.checks.titles) == {spec.title for spec in FINDINGS}
    user.wait(doctor.checks.isVisible)
    assert doctor.checks.visibleRegion().boundingRect() == doctor.checks.rect()
    assert doctor.height() < 400  # no empty half


def test_points_a_place_out_and_takes_the_dots_away(user, doctor):
    shown = card(doctor, "duplicate_faces")
    before = user.denoise.viewport.pose
    click(user, shown.show_button)
    user.wait(lambda: user.denoise.is_drawn and user.denoise.viewport.grid.look.marks is not None)
    assert user.denoise.viewport.grid.look.marks.tolist() == shown.finding.found.vertices.tolist()
    assert user.denoise.viewport.pose != before
    other = card(doctor, "boundary")
    click(user, other.show_button)
    assert not shown.show_button.isChecked()
    user.wait(lambda: len(user.denoise.viewport.grid.look.marks) == 6)
    click(user, other.show_button)
    user.wait(lambda: user.denoise.viewport.grid.look.marks is None)


def test_repair_undo_redo_save_and_open_again(user, doctor, ball_file, tmp_path):
    window = user.window
    click(user, card(doctor, "duplicate_faces").repair_button)
    settled(user, doctor, "1,274")
    assert doctor.changes.text() == "Removed 1 face that lay on others."
    assert doctor.outcome.text() == "Removed 1 face that lay on others."
    assert window.statusBar().currentMessage() == "Removed 1 face that lay on others."
    assert window.actions_["undo"].text() == "&Undo Remove duplicate faces"
    assert user.denoise.model.sign.text() == "No defects, 1 note …"

    click(user, card(doctor, "boundary").repair_button)
    settled(user, doctor, "1,278")
    assert doctor.verdict.isVisible()
    assert window.statusBar().currentMessage() == "Filled 1 hole with 4 faces."

    user.qtbot.keyClick(doctor, Qt.Key.Key_Z, CONTROL)
    settled(user, doctor, "1,274")
    assert doctor.outcome.text() == "The mesh is as it was before the repair."
    assert [c.finding.spec.id for c in doctor.cards] == ["boundary"]
    user.qtbot.keyClick(doctor, Qt.Key.Key_Z, CONTROL | SHIFT)
    settled(user, doctor, "1,278")
    close(user, doctor)

    before = numbers(user)
    path = tmp_path / "repaired.burnish"
    user.press(Qt.Key.Key_S, CONTROL | SHIFT)
    user.answer_file_dialog(path)
    user.wait(lambda: window.windowTitle().startswith("repaired.burnish "))
    repairs = read_study_file(path).study.repairs
    assert [choice.repair for choice in repairs] == ["duplicate_faces", "fill_holes"]
    user.open(ball_file)
    assert window.session.study.repairs == ()
    user.open(path)
    assert window.session.study.repairs == repairs
    assert numbers(user) == before


def test_repair_all_does_what_keeps_the_shape(user, doctor):
    click(user, doctor.repair_all)
    settled(user, doctor, "1,274")
    assert user.window.actions_["undo"].text() == "&Undo Repair all"
    assert [c.finding.spec.id for c in doctor.cards] == ["boundary"]
    assert not doctor.repair_all.isEnabled()


def test_the_number_of_edges_is_used(user, doctor):
    field = card(doctor, "boundary").form.fields["most_edges"].editor
    field.setFocus()
    field.selectAll()
    user.qtbot.keyClicks(field, "4")
    user.qtbot.keyClick(field, Qt.Key.Key_Tab)
    click(user, card(doctor, "boundary").repair_button)
    user.wait(lambda: doctor.outcome.text() == "Nothing to change.")
    assert user.window.session.study.repairs == ()


def test_another_model_starts_without_repairs(user, doctor, ball_file):
    click(user, doctor.repair_all)
    settled(user, doctor, "1,274")
    close(user, doctor)
    user.open(ball_file)
    assert user.window.session.study.repairs == ()
    user.wait(lambda: user.denoise.model.sign.text() == "No defects")


def test_a_cancelled_examination_is_said_and_done_after_all(user, ball_file, monkeypatch):
    def endless(mesh):
        while True:
            yield

    with monkeypatch.context() as held:
        held.setattr("app.session.doctor.examination_steps", endless)
        user.open(ball_file)
        sign = user.denoise.model.sign
        assert sign.text() == "Examining …"
        user.press(Qt.Key.Key_Escape)
        user.wait(lambda: sign.text() == "Not examined …")
    click(user, sign)
    user.wait(lambda: sign.text() == "No defects")
    assert dialogs(user)[0].checks.isVisible()
