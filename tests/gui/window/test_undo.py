"""Every change is a named step; going back and forth computes nothing again."""

import pytest
from PySide6.QtCore import Qt

from core.comparison import Comparison
from core.io import save_mesh
from core.mesh import primitives
from core.noise import add_noise

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def computed(monkeypatch):
    """Iterations that were computed, as they are."""
    snapshots, made = Comparison.snapshots, []

    def counted(self, choice):
        for snapshot in snapshots(self, choice):
            made.append(choice.method)
            yield snapshot

    monkeypatch.setattr(Comparison, "snapshots", counted)
    return made


def changes(user, tmp_path):
    """Change everything that a study holds; yields the name that each step should have."""
    denoise = user.denoise
    user.type_iterations("mean", 8)
    yield "Iterations of Mean filter"
    denoise.methods.blocks["diffusion"].form.changed.emit({"gradient_scale": 20.0})
    yield "Parameters of Vertex diffusion"
    denoise.methods.blocks["laplacian"].check.setChecked(True)
    yield "Show Laplacian flow"
    user.type_iterations_of_all(4)
    yield "Iterations of all methods"
    denoise.model.noise.seed.setValue(5)
    yield "Seed"
    denoise.model.noise.sigma.setValue(0.2)
    yield "Noise"
    user.window.actions_["advance"].trigger()
    yield "More iterations"
    user.press(Qt.Key.Key_W)
    yield "Edges"
    user.press(Qt.Key.Key_S)
    yield "Shading"
    user.press(Qt.Key.Key_L)
    yield "Link cameras"
    scan = tmp_path / "scan.ply"
    save_mesh(add_noise(primitives.sphere(3), 0.3), scan)
    user.window.actions_["open_noisy"].trigger()
    user.answer_file_dialog(scan)
    user.wait(lambda: user.window.session.study.noisy)
    yield "Noisy file"
    denoise.model.noise.clear_file.click()
    user.wait(lambda: user.window.session.study.noisy is None)
    yield "Added noise"
    user.window.open_model("sample:double_torus")
    user.wait(lambda: user.window.windowTitle().startswith("double_torus"))
    yield "Open double_torus"


def test_every_step_is_named_and_comes_back_without_being_computed(
    user, ball_file, tmp_path, computed
):
    def type_into_master(count):
        user.denoise.methods.master.slider.setValue(count)

    user.type_iterations_of_all = type_into_master
    undo, session = user.window.actions_["undo"], user.window.session
    user.open(ball_file)
    studies = [session.study]
    for name in changes(user, tmp_path):
        user.wait(lambda: session.study != studies[-1] and session.activity is None)
        user.rest()
        assert undo.text() == f"&Undo {name}"
        studies.append(session.study)
    done = len(computed)
    for study in reversed(studies[:-1]):
        user.press(Qt.Key.Key_Z, CONTROL)
        assert session.activity is None
        assert session.study == study
    assert not undo.isEnabled()
    for study in studies[1:]:
        user.press(Qt.Key.Key_Z, CONTROL | SHIFT)
        assert session.activity is None
        assert session.study == study
    user.rest()
    assert len(computed) == done
