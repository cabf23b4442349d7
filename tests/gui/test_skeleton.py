"""The Skeleton tab, used as a person would."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtWidgets import QDialog

from app.export.pictures import composed
from app.scene.colours import DARK, LIGHT
from app.session import Session
from app.ui.screenshot_dialog import Request, ScreenshotDialog
from app.ui.skeleton_export import film
from app.ui.skeleton_film_dialog import FilmDialog, FilmRequest
from app.ui.skeleton_tab import SkeletonTab
from app.ui.tasks import Poster
from core.io import save_mesh
from core.mesh import primitives
from core.study import MethodChoice, Study

pytestmark = pytest.mark.gui

LONG = 60_000


@pytest.fixture
def torus_session(qtbot, tmp_path):
    path = tmp_path / "torus.ply"
    save_mesh(primitives.torus(40, 20), path)
    session = Session(Poster())
    methods = (MethodChoice(method="mean", iterations=1),)
    session.apply(Study(model=str(path), methods=methods), "Open")
    qtbot.waitUntil(lambda: session.meshes is not None and session.activity is None, timeout=LONG)
    yield session
    session.close()


@pytest.fixture
def hidden_tab(qtbot, torus_session):
    tab = SkeletonTab(torus_session, LIGHT)
    qtbot.addWidget(tab, before_close_func=SkeletonTab.close_graphics)
    tab.resize(1100, 750)
    return tab


@pytest.fixture
def settle(qtbot, hidden_tab):
    """Wait until the graphs are drawn and the viewport shows them."""

    def settle():
        tab = hidden_tab
        qtbot.waitUntil(
            lambda: (
                tab.session.activity is None
                and tab.views.is_settled
                and not tab._redraw_timer.isActive()
            ),
            timeout=LONG,
        )

    return settle


@pytest.fixture
def tab(qtbot, hidden_tab, settle):
    hidden_tab.show()
    with qtbot.waitExposed(hidden_tab):
        pass
    settle()
    return hidden_tab


def view(tab, index=1):
    return tab.session.study.skeleton.views[index]


def click(qtbot, widget, place=None):
    qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=place or widget.rect().center())


def choose(box, key):
    """Choose an entry of a combo box as the mouse does."""
    box.setCurrentIndex(box.findData(key))
    box.activated.emit(box.currentIndex())


def test_nothing_is_computed_before_the_tab_is_shown(hidden_tab):
    assert hidden_tab.views.skeleton(1) is None


def test_it_opens_with_euclidean_beside_mixture(tab):
    panes, _ = tab.panes(1.0)
    assert [pane.title for pane in panes] == [
        "Euclidean distance, R = 22",
        "Mixture distance, R = 22",
    ]
    assert all("1 loops / genus 1" in pane.caption for pane in panes)


def test_a_dragged_slider_redraws_and_is_one_step_of_undo(qtbot, tab, settle):
    slider = tab.centre.resolutions[1].slider
    slider.setFocus()
    for _ in range(6):
        qtbot.keyClick(slider, Qt.Key.Key_Left)
    settle()
    assert tab.views.skeleton(1).graph.resolution == 16
    assert tab.centre.resolutions[1].number.value() == 16
    assert view(tab, 0).resolution == 22
    tab.session.undo()
    settle()
    assert tab.views.skeleton(1).graph.resolution == 22
    assert slider.value() == 22


def test_a_dragged_slider_does_not_lay_out_the_tab_anew(qtbot, tab, settle):
    requests = []

    class Watch(QObject):
        def eventFilter(self, _, event):  # noqa: N802 (the name is Qt's)
            if event.type() == QEvent.Type.LayoutRequest:
                requests.append(event)
            return False

    watch = Watch()
    tab.installEventFilter(watch)
    for resolution in (8, 12, 40):
        tab.centre.resolutions[1].slider.setValue(resolution)
        settle()
    assert tab.centre.growth.label.text() == "all 40 bands"
    assert not requests


def test_one_views_resolution_leaves_the_other_view_as_it_is(qtbot, tab, settle):
    before, look = tab.panes(1.0)
    slider = tab.centre.resolutions[1].slider
    slider.setFocus()
    qtbot.keyClick(slider, Qt.Key.Key_Left)
    settle()
    after, same_look = tab.panes(1.0)
    assert same_look == look
    assert after[0].skeleton is before[0].skeleton
    assert after[1].skeleton is not before[1].skeleton


def test_auto_chooses_a_resolution(qtbot, tab, settle):
    click(qtbot, tab.centre.resolutions[1].automatic)
    qtbot.waitUntil(lambda: view(tab).resolution != 22, timeout=LONG)
    settle()
    assert tab.views.skeleton(1).graph.loops == 1


def test_field_levels_bands_and_root_reach_the_graph(qtbot, tab, settle, hands):
    panel = tab.side.panels[1]
    choose(panel.field, "height")
    choose(panel.spacing, "area")
    choose(panel.bands, "vertices")
    hands.click_check(panel.root)
    settle()
    skeleton = tab.views.skeleton(1)
    assert (skeleton.graph.field, skeleton.graph.bands) == ("height", "vertices")
    assert skeleton.graph.root is not None
    assert skeleton.view.spacing == "area"


def test_the_weight_of_the_mixture_can_be_set(qtbot, tab, settle, hands):
    weight = tab.side.panels[1].forms["mixture"].fields["weight"]
    hands.click_check(weight.auto)
    hands.type_into(weight.editor, "0.25")
    settle()
    assert view(tab).params == {"weight": 0.25}
    assert "λ = 0.25" in tab.panes(1.0)[0][1].title


def test_a_decimated_and_a_denoised_surface_beside_the_original(qtbot, tab, settle, hands):
    tab.side.tabs.setCurrentIndex(0)
    hands.type_into(tab.side.panels[0].keep.number, "25")
    qtbot.waitUntil(lambda: view(tab, 0).keep == 0.25, timeout=LONG)
    choose(tab.side.panels[1].source, "mean")
    settle()
    assert len(tab.views.skeleton(0).mesh.faces) < 450
    assert tab.views.skeleton(1).view.source == "mean"


def test_one_view_alone(qtbot, tab, settle, hands):
    hands.click_check(tab.side.compare)
    settle()
    assert len(tab.panes(1.0)[0]) == 1
    assert tab.centre.flat[0].isHidden()
    assert tab.centre.resolutions[0].isHidden()


def test_growth_by_hand_and_by_itself(qtbot, tab, settle):
    tab.growth.slider.setFocus()
    qtbot.keyClick(tab.growth.slider, Qt.Key.Key_Home)
    settle()
    assert tab.step == 0
    with qtbot.waitSignal(tab.growth.changed, timeout=LONG):
        click(qtbot, tab.growth.play)
    assert tab.growth.is_playing
    click(qtbot, tab.growth.pause)
    assert not tab.growth.is_playing
    qtbot.keyClick(tab.growth.slider, Qt.Key.Key_End)
    settle()
    assert tab.step is None


def test_picking_is_linked_both_ways(qtbot, tab, settle):
    drawing = tab.centre.flat[1]
    node = 4
    x, y = drawing.places()[node]
    click(qtbot, drawing, QPoint(round(x), round(y)))
    settle()
    pane = tab.panes(1.0)[0][1]
    assert pane.picked == node
    assert pane.note.startswith(f"node {node}, ")
    empty = QPoint(3, tab.viewport.interactor.height() - 5)
    click(qtbot, tab.viewport.interactor, empty)
    settle()
    assert tab.selected == 0
    size = tab.viewport.pixel_size()
    places, _, _ = tab.viewport.grid._project(0, size)
    left, bottom = places[-1]
    click(qtbot, tab.viewport.interactor, QPoint(round(left), round(size[1] - bottom)))
    settle()
    assert tab.panes(1.0)[0][0].picked is not None


def test_check_invariance_tells_the_outcome(qtbot, tab):
    click(qtbot, tab.side.facts.check)
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


def test_layers_and_colours_are_part_of_the_study(qtbot, tab, settle, hands):
    for name in ("show_bands", "show_curves", "show_graph", "show_shells"):
        before = getattr(tab.session.study.skeleton, name)
        hands.click_check(tab.side.layers.layers[name])
        assert getattr(tab.session.study.skeleton, name) is not before
    choose(tab.side.layers.node_colour, "kind")
    settle()
    assert tab.session.study.skeleton.node_colour == "kind"
    assert not tab.side.layers.legend.isHidden()


def test_loops_stand_beside_the_genus(tab):
    table = tab.side.facts.table
    assert [table.item(0, column).text() for column in range(3)] == ["1", "1", "1"]


def test_a_dark_theme_changes_the_ground(qtbot, tab, settle):
    size = tab.viewport.pixel_size()
    light = composed(tab.desk.picture(Request("grid", 1, transparent=False), size))
    tab.set_theme(DARK)
    settle()
    dark = composed(tab.desk.picture(Request("grid", 1, transparent=False), size))
    assert dark[-4, 4].mean() < light[-4, 4].mean() - 80


def test_pictures_have_the_size_that_the_dialog_says(qtbot, tab):
    width, height = tab.viewport.pixel_size()
    size = tab.desk.subjects()["pane"].size
    picture = composed(tab.desk.picture(Request("pane", 2, transparent=True), size))
    assert picture.shape == (2 * height, 2 * (width // 2), 4)


def test_the_dialogs_ask_for_what_is_chosen(qtbot, tab):
    pictures = ScreenshotDialog(tab, {"grid": ("Both views", (800, 400))})
    pictures.scale.setValue(3)
    assert "2,400 × 1,200" in pictures.size_label.text()
    films = FilmDialog(tab)
    films.subject.setCurrentIndex(1)
    with qtbot.waitSignal(films.wanted) as wanted:
        films._accept()
    assert wanted.args[0].subject == "growth"
    assert films.result() == QDialog.DialogCode.Accepted


@pytest.mark.parametrize(("subject", "suffix"), [("turn", ".gif"), ("growth", ".mp4")])
def test_films_are_written_beside_the_window(qtbot, tab, tmp_path, subject, suffix):
    path = tmp_path / f"film{suffix}"
    film(tab, FilmRequest(subject, suffix, 3, 5.0), path)
    qtbot.waitUntil(path.exists, timeout=LONG)
    assert path.stat().st_size > 1000


def test_a_cancelled_graph_is_told_with_a_button_to_draw_it(qtbot, tab, settle):
    bar = tab.centre.resolutions[1]
    assert not bar.notice.isVisible()
    bar.number.setValue(40)
    tab.session.cancel()
    assert bar.notice.isVisible()
    assert bar.notice.text().startswith("Cancelled")
    assert not tab.centre.resolutions[0].notice.isVisible()
    click(qtbot, bar.resume)
    assert not bar.notice.isVisible()
    settle()
    assert tab.views.skeleton(1).view.resolution == 40


def test_a_film_is_among_what_runs_and_can_be_cancelled(qtbot, tab, tmp_path):
    path, tasks = tmp_path / "film.gif", tab.session.tasks
    film(tab, FilmRequest("turn", ".gif", 50, 5.0), path)
    qtbot.waitUntil(lambda: tasks.states()[-1].share, timeout=LONG)
    assert tasks.states()[-1].title == "Writing film.gif"
    tasks.cancel_all()
    qtbot.waitUntil(lambda: not tasks.states(), timeout=LONG)
    assert not list(tmp_path.glob("*film*"))


def test_an_unchanged_view_keeps_its_pixels(qtbot, tab, settle):
    qtbot.waitUntil(lambda: not tab.viewport._rest.isActive(), timeout=LONG)
    before = _pixels(tab)
    tab.centre.resolutions[1].number.setValue(9)
    settle()
    after = _pixels(tab)
    half = before.shape[1] // 2
    assert np.abs(after[60:-60, half + 20 :] - before[60:-60, half + 20 :]).max() > 60
    assert np.abs(after[60:-60, : half - 20] - before[60:-60, : half - 20]).mean() < 12


def _pixels(tab):
    image = tab.viewport.interactor.grabFramebuffer().convertToFormat(
        tab.viewport.interactor.grabFramebuffer().Format.Format_RGB888
    )
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), -1, 3).astype(int)
