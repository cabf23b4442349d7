"""The methods panel, by mouse and keys."""

from html import unescape

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel

from app.ui.methods_panel import MethodsPanel
from core.smoothing import METHODS

pytestmark = pytest.mark.gui

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def methods(session, shown):
    return shown(MethodsPanel(session), 300, 620)


def test_blocks_show_the_study(methods):
    assert [block.title.text() for block in methods.blocks.values()] == [
        spec.title for spec in METHODS.values()
    ]
    assert methods.blocks["mean"].iterations.box.value() == 6
    assert not methods.blocks["laplacian"].check.isChecked()
    assert not methods.blocks["laplacian"].iterations.isVisible()


def test_tooltip_tells_formula_source_and_departure(methods):
    tip = unescape(methods.blocks["diffusion"].toolTip())
    spec = METHODS["diffusion"]
    for text in (spec.summary, spec.formula, spec.reference, spec.departure):
        assert text in tip


def test_check_box_takes_a_method_in_and_out(session, methods, hands):
    hands.click_check(methods.blocks["laplacian"].check)
    assert session.study.choice("laplacian").enabled
    assert methods.blocks["laplacian"].iterations.isVisible()
    hands.click_check(methods.blocks["mean"].check)
    assert not session.study.choice("mean").enabled


def test_keys_on_a_slider_change_the_iterations_as_one_step(qtbot, session, methods):
    slider = methods.blocks["median"].iterations.slider
    for _ in range(3):
        qtbot.keyClick(slider, Qt.Key.Key_Right)
    assert session.study.choice("median").iterations == 9
    assert session.history.undo_name == "Iterations of Angle median filter"
    session.undo()
    assert methods.blocks["median"].iterations.box.value() == 6


def test_master_slider_moves_all_checked_methods(session, methods, hands):
    hands.type_into(methods.master.box, "9")
    iterations = {choice.method: choice.iterations for choice in session.study.methods}
    assert iterations.pop("laplacian") == 6
    assert set(iterations.values()) == {9}


def test_gear_unfolds_the_parameters(qtbot, session, methods, hands):
    block = methods.blocks["weighted_laplacian"]
    assert not block.form.isVisible()
    qtbot.mouseClick(block.gear, LEFT)
    assert block.form.isVisible()
    hands.click_check(block.form.fields["clamp_negative"].editor)
    assert session.study.choice("weighted_laplacian").params == {"clamp_negative": False}
    session.undo()
    assert block.form.values() == {}


def test_state_tells_progress_error_and_divergence(qtbot, session, methods, change, diverging):
    block = methods.blocks["diffusion"]
    change("diffusion", iterations=40)
    assert block.state.text() == "6 of 40 …"
    qtbot.waitUntil(lambda: "ℓ̄²" in block.state.text(), timeout=10_000)
    change("diffusion", params=diverging)
    qtbot.waitUntil(lambda: "✕ diverged at iteration" in block.state.text(), timeout=10_000)
    assert session.run("diffusion").diverged == int(block.state.text().split()[-1])


def test_state_warns_of_doing_worse_than_nothing(qtbot, methods, change):
    change("bilateral", iterations=25)
    state = methods.blocks["bilateral"].state
    qtbot.waitUntil(lambda: "worse than the noisy input" in state.text(), timeout=10_000)


@pytest.mark.parametrize("part", ["title", "slider"])
def test_click_selects_a_method(qtbot, methods, part):
    block = methods.blocks["median"]
    target = block.title if part == "title" else block.iterations.slider
    with qtbot.waitSignal(methods.selected) as selected:
        qtbot.mouseClick(target, LEFT)
    assert selected.args == ["median"]


def test_tab_reaches_and_selects_the_next_method(qtbot, methods):
    methods.blocks["mean"].iterations.box.setFocus()
    with qtbot.waitSignal(methods.selected) as selected:
        qtbot.keyClick(methods.blocks["mean"].iterations.box, Qt.Key.Key_Tab)
    assert selected.args == ["median"]


def test_selected_block_looks_different(methods):
    plain = methods.blocks["mean"].grab().toImage()
    methods.set_selected("mean")
    assert methods.blocks["mean"].grab().toImage() != plain
    methods.set_selected(None)
    assert methods.blocks["mean"].grab().toImage() == plain


def test_nothing_is_cut_off_at_three_hundred_pixels(methods):
    for block in methods.blocks.values():
        for label in block.findChildren(QLabel):
            if label.isVisible() and not label.wordWrap():
                assert label.sizeHint().width() <= label.width()
