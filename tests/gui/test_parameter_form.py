"""The parameter form, by mouse and keys."""

import pytest
from PySide6.QtCore import Qt

from app.ui.parameter_form import ParameterForm
from core.smoothing import METHODS

pytestmark = pytest.mark.gui

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def forms(shown):
    def make(method):
        return shown(ParameterForm(METHODS[method].params), 300, 400)

    return make


@pytest.mark.parametrize("method", METHODS)
def test_form_begins_at_the_defaults_and_explains_itself(forms, method):
    form = forms(method)
    assert form.values() == {}
    for name, info in METHODS[method].params.model_fields.items():
        assert info.description in form.fields[name].toolTip()
        assert not form.fields[name].reset.isVisible()


def test_a_switch_is_told_in_the_words_of_its_domain(forms):
    field = forms("weighted_laplacian").fields["clamp_negative"]
    assert "Allowed: true or false. Default: true." in field.toolTip()
    assert field.reset.toolTip() == "Back to true"


def test_typed_number_is_reported_and_can_be_reset(qtbot, forms, hands):
    form = forms("diffusion")
    field = form.fields["gradient_scale"]
    assert field.editor.text() == "50"
    with qtbot.waitSignal(form.changed) as changed:
        hands.type_into(field.editor, "14.5")
    assert changed.args == [{"gradient_scale": 14.5}]
    with qtbot.waitSignal(form.changed) as changed:
        qtbot.mouseClick(field.reset, LEFT)
    assert changed.args == [{}]
    assert field.editor.text() == "50"
    assert not field.reset.isVisible()


def test_logarithmic_number_steps_by_its_size(qtbot, forms):
    editor = forms("diffusion").fields["gradient_scale"].editor
    qtbot.keyClick(editor, Qt.Key.Key_Up)
    assert editor.value() == 51
    editor.setValue(0.2)
    qtbot.keyClick(editor, Qt.Key.Key_Up)
    assert editor.value() == pytest.approx(0.21)


def test_number_shows_the_digits_it_needs(forms):
    assert forms("diffusion").fields["c"].editor.text() == "2.3849"


def test_automatic_value_can_be_set_by_hand(qtbot, forms, hands):
    form = forms("bilateral")
    field = form.fields["sigma_c"]
    assert field.auto.isChecked()
    assert not field.editor.isEnabled()
    with qtbot.waitSignal(form.changed) as changed:
        hands.click_check(field.auto)
    assert changed.args == [{"sigma_c": 1.0}]
    hands.type_into(field.editor, "0.5")
    assert form.values() == {"sigma_c": 0.5}
    assert field.editor.text() == "0.5 ℓ̄"
    hands.click_check(field.auto)
    assert form.values() == {}


def test_switch_and_choice(qtbot, forms, hands):
    form = forms("diffusion")
    hands.click_check(form.fields["raw_units"].editor)
    qtbot.keyClick(form.fields["form"].editor, Qt.Key.Key_Down)
    assert form.values() == {"form": "printed", "raw_units": True}


def test_set_values_is_silent_and_sets_the_rest_to_defaults(qtbot, forms):
    form = forms("diffusion")
    with qtbot.assertNotEmitted(form.changed):
        form.set_values({"c": 3.0})
        form.set_values({"gradient_scale": 14.0})
    assert form.values() == {"gradient_scale": 14.0}
    assert form.fields["gradient_scale"].reset.isVisible()
