"""The model panel and its noise, by mouse and keys."""

import pytest
from PySide6.QtCore import QPoint, Qt

from app.ui.denoise_tab import LEFT_WIDTH
from app.ui.model_panel import ModelPanel
from app.ui.noise_controls import position_of, sigma_at
from app.ui.theme import set_mode
from core.io import save_mesh
from core.mesh import primitives
from core.noise import add_noise

pytestmark = pytest.mark.gui

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def model(qtbot, session, shown):
    panel = shown(ModelPanel(session), 230, 420)
    qtbot.waitUntil(lambda: panel.facts["faces"].text() == "320")
    return panel


def test_facts_of_the_model(model):
    assert model.name.text() == "ball.ply"
    texts = {name: label.text() for name, label in model.facts.items()}
    assert texts["vertices"] == "162"
    assert texts["edges"] == "480"
    assert texts["components"] == "1"
    assert texts["genus"] == "0"
    assert texts["boundary"] == "none (closed)"
    assert not model.report.isVisible()


def test_open_model_says_why_it_has_no_genus_and_what_was_changed(qtbot, session, model, tmp_path):
    path = tmp_path / "square.off"
    path.write_text("OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n4 0 1 2 3\n")
    session.apply(session.study.model_copy(update={"model": str(path)}), "Open")
    qtbot.waitUntil(lambda: model.facts["faces"].text() == "2", timeout=10_000)
    assert model.facts["genus"].text() == "–"
    assert "boundary" in model.facts["genus"].toolTip()
    assert model.facts["boundary"].text() == "4 edges"
    assert model.report.isVisible()
    assert session.meshes.report[0] in model.report.text()


@pytest.mark.parametrize("sigma", [0.0, 0.005, 0.02, 0.1, 0.5, 1.0])
def test_slider_of_the_noise_reaches_small_and_large_values(sigma):
    assert sigma_at(position_of(sigma)) == pytest.approx(sigma, abs=0.002)
    assert 0 <= position_of(sigma) <= 1000


def test_common_noise_is_not_at_the_end_of_the_slider():
    assert 300 < position_of(0.02) < 700


def test_dragging_the_noise_is_one_step_after_a_pause(qtbot, session, model):
    slider = model.noise.slider
    changes = []
    session.study_changed.connect(lambda new, old: changes.append(new.noise.sigma))
    middle = slider.height() // 2
    qtbot.mousePress(slider, LEFT, pos=QPoint(slider.width() // 2, middle))
    for x in range(slider.width() // 2, slider.width() - 10, 10):
        qtbot.mouseMove(slider, QPoint(x, middle))
    assert model.noise.sigma.value() > 0.2
    assert changes == []
    qtbot.mouseRelease(slider, LEFT, pos=QPoint(slider.width() - 20, middle))
    qtbot.waitUntil(lambda: len(changes) == 1, timeout=10_000)
    assert changes == [model.noise.sigma.value()]
    session.undo()
    qtbot.waitUntil(lambda: model.noise.sigma.value() == 0.1, timeout=10_000)


def test_typed_noise_and_new_seed_change_the_noisy_mesh(qtbot, session, model, hands):
    hands.type_into(model.noise.sigma, "0.0375")
    qtbot.waitUntil(lambda: session.study.noise.sigma == 0.0375, timeout=10_000)
    before = session.meshes.comparison.noisy.vertices
    qtbot.mouseClick(model.noise.dice, LEFT)
    qtbot.waitUntil(lambda: session.study.noise.seed == model.noise.seed.value(), timeout=10_000)
    assert session.study.noise.sigma == 0.0375
    assert (session.meshes.comparison.noisy.vertices != before).any()


def test_noise_does_not_need_the_file_again(qtbot, session, model, ball_file, hands):
    ball_file.unlink()
    hands.type_into(model.noise.sigma, "0.5")
    qtbot.waitUntil(lambda: session.study.noise.sigma == 0.5, timeout=10_000)


def test_noise_that_cannot_be_had_goes_back(qtbot, model, hands, monkeypatch):
    def refuse(*_):
        raise MemoryError

    monkeypatch.setattr("app.session.meshes.add_noise", refuse)
    hands.type_into(model.noise.sigma, "0.5")
    qtbot.waitUntil(lambda: model.noise.sigma.value() == 0.1, timeout=10_000)


def test_separate_noisy_file_replaces_the_noise(qtbot, session, model, tmp_path):
    with qtbot.waitSignal(model.noisy_file_requested):
        qtbot.mouseClick(model.noise.choose_file, LEFT)
    assert not model.noise.clear_file.isVisible()
    scan = tmp_path / "scan.ply"
    save_mesh(add_noise(primitives.sphere(2), 0.05), scan)
    session.apply(session.study.model_copy(update={"noisy": str(scan)}), "Noisy file")
    qtbot.waitUntil(model.noise.clear_file.isVisible, timeout=10_000)
    assert not model.noise.sigma.isEnabled()
    assert "scan.ply" in model.noise.note.text()
    qtbot.mouseClick(model.noise.clear_file, LEFT)
    qtbot.waitUntil(model.noise.sigma.isEnabled, timeout=10_000)
    assert session.study.noisy is None
    assert not model.noise.note.isVisible()


def test_model_panel_fits_its_width(model):
    set_mode("light")  # the window's style, whatever other tests have set
    inside = model.noise.parentWidget()
    assert inside.minimumSizeHint().width() <= LEFT_WIDTH
