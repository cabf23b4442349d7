"""What is set and read beside the views of the Skeleton tab."""

import pytest
from PySide6.QtCore import Qt

pytestmark = pytest.mark.gui

LONG = 60_000


def test_field_levels_bands_and_root_reach_the_graph(tab, settle, hands):
    panel = tab.side.panels[1]
    hands.choose(panel.field, "height")
    hands.choose(panel.spacing, "area")
    assert tab.session.history.undo_name == "Levels"
    hands.choose(panel.bands, "vertices")
    hands.click_check(panel.root)
    settle()
    skeleton = tab.views.skeleton(1)
    assert (skeleton.graph.field, skeleton.graph.bands) == ("height", "vertices")
    assert skeleton.graph.root is not None
    assert skeleton.view.spacing == "area"


def test_the_weight_of_the_mixture_can_be_set(tab, settle, hands):
    weight = tab.side.panels[1].forms["mixture"].fields["weight"]
    hands.click_check(weight.auto)
    hands.type_into(weight.editor, "0.25")
    settle()
    assert tab.session.study.skeleton.views[1].params == {"weight": 0.25}
    assert "λ = 0.25" in tab.panes(1.0)[0][1].title


def test_a_decimated_and_a_denoised_surface_beside_the_original(qtbot, tab, settle, hands):
    tab.side.tabs.setCurrentIndex(0)
    hands.type_into(tab.side.panels[0].keep.number, "25")
    qtbot.waitUntil(lambda: tab.session.study.skeleton.views[0].keep == 0.25, timeout=LONG)
    hands.choose(tab.side.panels[1].source, "mean")
    settle()
    assert len(tab.views.skeleton(0).mesh.faces) < 450
    assert tab.views.skeleton(1).view.source == "mean"


def test_one_view_alone(tab, settle, hands):
    hands.click_check(tab.side.compare)
    settle()
    assert len(tab.panes(1.0)[0]) == 1
    assert tab.centre.flat[0].isHidden()
    assert tab.centre.resolutions[0].isHidden()


def test_check_invariance_tells_the_outcome(qtbot, tab, hands):
    hands.click(tab.side.facts.check)
    qtbot.waitUntil(lambda: bool(tab.side.facts.outcome.text()), timeout=LONG)
    assert "the same graph" in tab.side.facts.outcome.text()


def test_the_outcome_of_a_check_comes_into_sight(qtbot, tab):
    tab.side.verticalScrollBar().setValue(0)
    qtbot.mouseClick(tab.side.facts.check, Qt.MouseButton.LeftButton)
    outcome, sight = tab.side.facts.outcome, tab.side.viewport()

    def is_seen():
        end = outcome.mapTo(sight, outcome.rect().bottomLeft())
        return outcome.isVisible() and sight.rect().contains(end)

    qtbot.waitUntil(is_seen, timeout=LONG)


def test_the_reason_of_a_part_is_not_cut_off(qtbot, tab):
    table = tab.side.facts.table
    qtbot.waitUntil(lambda: table.rowHeight(0) >= table.sizeHintForRow(0))
    assert table.viewport().height() >= table.rowHeight(0)


def test_layers_and_colours_are_part_of_the_study(tab, settle, hands):
    for name in ("show_bands", "show_curves", "show_graph", "show_shells"):
        before = getattr(tab.session.study.skeleton, name)
        hands.click_check(tab.side.layers.layers[name])
        assert getattr(tab.session.study.skeleton, name) is not before
    hands.choose(tab.side.layers.node_colour, "kind")
    settle()
    assert tab.session.study.skeleton.node_colour == "kind"
    assert not tab.side.layers.legend.isHidden()


def test_loops_stand_beside_the_genus(tab):
    table = tab.side.facts.table
    assert [table.item(0, column).text() for column in range(3)] == ["1", "1", "1"]
