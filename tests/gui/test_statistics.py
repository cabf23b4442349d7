"""The Statistics tab: what it computes and when, hovering, a second model, saving, mesh tools."""

import threading
from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QGuiApplication, QMouseEvent

from app.export.statistics_axes import NOT_YET
from app.export.statistics_plots import PLOTS
from app.export.statistics_series import SERIES_COLOURS, Series
from app.scene.colours import DARK, LIGHT
from app.session import Job
from app.ui import statistics_tools
from app.ui.statistics_plot import StatisticsPlot
from app.ui.statistics_saving import cell_writer, copy_numbers
from app.ui.statistics_tab import StatisticsTab
from app.ui.statistics_work import Model
from core import mesh_statistics
from core.io import save_mesh
from core.mesh import primitives, remesh
from core.statistics import connectivity

pytestmark = pytest.mark.gui


def settle(qtbot, tab):
    qtbot.waitUntil(lambda: bool(tab.work.series()) and tab.work.activity is None, timeout=60_000)
    qtbot.waitUntil(lambda: all(drawn(plot, tab.work.series()) for plot in tab.plots.values()))
    qtbot.wait(150)


def drawn(plot, series):
    """Whether a plot shows what is known, and its axes have found their places."""
    same = plot._shown(plot.series) == plot._shown(series)
    return same and not plot._redraw_soon.isActive() and plot._background is not None


@pytest.fixture
def tab(qtbot, session, shown):
    tab = StatisticsTab(session, LIGHT)
    shown(tab, 1280, 760)
    settle(qtbot, tab)
    yield tab
    tab.close_graphics()


@pytest.fixture
def point_at(qtbot, tab):
    """Move the pointer to a place on the scales of a plot's axes."""

    def point(plot, x, y, *, beside=False):
        cell = tab.plots[plot]
        cell.canvas.draw()
        axes = cell._axes.child_axes[0] if beside else cell._axes
        px, py = axes.transData.transform((x, y))
        ratio = cell.canvas.device_pixel_ratio
        place = QPointF(px / ratio, cell.canvas.height() - py / ratio)
        move(cell.canvas, place)
        qtbot.wait(30)

    return point


def move(widget, place):
    nothing, keys = Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier
    where = QPointF(widget.mapToGlobal(place.toPoint()))
    event = QMouseEvent(QEvent.Type.MouseMove, place, where, nothing, nothing, keys)
    QGuiApplication.sendEvent(widget, event)


def lit(tab):
    """Number of vertices lit up on each model."""
    masks = tab.view._masks or [None] * len(tab.work.models)
    return [0 if mask is None else int(mask.sum()) for mask in masks]


def test_nothing_is_computed_before_the_tab_is_shown(qtbot, session):
    tab = StatisticsTab(session, LIGHT)
    qtbot.addWidget(tab)
    session.meshes_changed.emit()
    qtbot.wait(400)
    assert (tab.work.models, tab.work.series(), tab.work.activity) == ((), [], None)
    tab.close_graphics()


def test_all_five_plots_come(tab):
    (series,) = tab.work.series()
    assert series.spectrum.exact
    assert series.geodesic.sources == 162
    titles = [plot.spec.title for plot in tab.plots.values()]
    assert titles == [
        "Spectrum", "Vertex degree", "Assortativity", "Clustering", "Geodesic distance",
    ]  # fmt: skip
    for plot in tab.plots.values():
        assert plot.isVisible()
        assert len(plot.words.text()) > 40
        assert plot._axes.get_xlabel()


def test_each_plot_is_drawn_once(qtbot, session, shown):
    tab, drawn = StatisticsTab(session, LIGHT), []
    for plot in tab.plots.values():
        plot.spec = replace(plot.spec, draw=noted(plot.spec, drawn))
    shown(tab, 1280, 760)
    settle(qtbot, tab)
    tab.close_graphics()
    assert sorted(drawn) == sorted(tab.plots)


def noted(spec, drawn):
    def draw(*arguments):
        drawn.append(spec.id)
        return spec.draw(*arguments)

    return draw


@pytest.mark.parametrize("id_", ["spectrum", "geodesic"])
def test_a_plot_that_is_not_computed_yet_says_so(qtbot, shown, id_):
    mesh = primitives.sphere(1)
    plot = StatisticsPlot(PLOTS[id_])
    shown(plot, 320, 270)
    half = Series.of_vertices("ball", SERIES_COLOURS[0], connectivity(mesh))
    plot.show_series([half], LIGHT)
    qtbot.waitUntil(lambda: [text.get_text() for text in plot.canvas.figure.texts] == [NOT_YET])
    plot.show_series([Series.of_statistics("ball", mesh_statistics(mesh))], LIGHT)
    qtbot.waitUntil(lambda: bool(plot.canvas.figure.axes))
    assert not plot.canvas.figure.texts


def test_summary_is_shown(tab):
    texts = [tab.side._summary.itemAt(i).widget().text() for i in range(6)]
    assert texts == ["Vertices", "162", "Edges", "480", "Faces", "320"]


def test_hovering_a_degree_lights_its_vertices(tab, point_at):
    point_at("degree", 5, 0.01)
    assert lit(tab) == [12]
    assert "degree 5: 12 vertices" in tab.plots["degree"].words.text()
    point_at("clustering", 6, 0.4)
    assert lit(tab) == [150]
    assert "degree 6" not in tab.plots["degree"].words.text()
    tab.lights.point(None)
    assert lit(tab) == [0]


def test_hovering_the_histogram_beside_lights_its_vertices(tab, point_at):
    point_at("clustering", 0.3, 0.499, beside=True)
    assert lit(tab) == [12]
    point_at("assortativity", 0.3, 5.999, beside=True)
    assert 0 < lit(tab)[0] < 162


def test_spectrum_is_read_off_without_lighting(tab, point_at):
    point_at("spectrum", 0.5, 3)
    assert lit(tab) == [0]
    assert "% of the eigenvalues are above" in tab.plots["spectrum"].words.text()


def test_picked_vertex_gives_distances(qtbot, tab, point_at):
    point_at("geodesic", 4, 0.01)
    assert "Click the model" in tab.plots["geodesic"].words.text()
    tab.lights.point(None)
    tab._pick(0, 7)
    qtbot.waitUntil(lambda: tab.work.distances(0) is not None)
    assert tab.side.colour.currentData() == "distance"
    assert tab.work.distances(0)[7] == 0
    qtbot.wait(200)
    assert lit(tab) == [1]
    point_at("geodesic", 4, 0.01)
    assert 0 < lit(tab)[0] < 162


def test_a_click_on_the_model_picks_a_vertex(qtbot, tab):
    view = tab.view.interactor
    with qtbot.waitSignal(tab.view.picked) as picked:
        qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=view.rect().center())
    assert picked.args[0] == 0
    qtbot.waitUntil(lambda: tab.work.distances(0) is not None)


def test_a_picked_vertex_is_forgotten_with_its_mesh(qtbot, tab):
    ball, ring = primitives.sphere(2), primitives.torus(8, 6)
    first = tab.work.models
    tab.work.show((*first, Model("ball", ball)))
    tab.work.pick(1, 161)
    tab.work.show((*first, Model("ring", ring)))
    assert tab.work.picked is None
    tab.work.pick(0, 161)
    tab.work.show((*first, Model("ball", ball)))
    assert tab.work.picked == (0, 161)


def test_a_click_on_a_model_that_is_gone_picks_nothing(qtbot, tab):
    tab.work.show((Model("ring", primitives.torus(8, 6)),))
    tab.view.picked.emit(0, 161)
    tab.view.picked.emit(1, 0)
    assert tab.work.picked is None


@pytest.mark.parametrize("colour", ["degree", "assortativity", "clustering"])
def test_model_is_coloured(qtbot, tab, colour):
    tab.side.colour.setCurrentIndex(tab.side.colour.findData(colour))
    qtbot.waitUntil(lambda: tab.view._look.colour_title != "")
    assert len(tab.view._panes[0].pane.values) == 162


def test_second_model_from_a_file(qtbot, tab, tmp_path):
    path = tmp_path / "ring.ply"
    save_mesh(primitives.torus(), path)
    tab.second.choose(str(path))
    qtbot.waitUntil(lambda: len(tab.work.models) == 2)
    settle(qtbot, tab)
    assert [one.name for one in tab.work.series()] == ["ball", "ring"]
    assert tab.side.second.currentText() == "ring.ply"
    for plot in tab.plots.values():
        labels = [text.get_text() for text in plot._axes.figure.legends[0].get_texts()]
        assert labels == ["ball", "ring"]
    tab.second.choose("none")
    qtbot.waitUntil(lambda: len(tab.work.models) == 1)


@pytest.mark.parametrize(("choice", "name"), [("noisy", "noisy"), ("method:mean", "k = 6")])
def test_second_model_from_the_session(qtbot, tab, choice, name):
    tab.second.choose(choice)
    qtbot.waitUntil(lambda: len(tab.work.models) == 2)
    settle(qtbot, tab)
    first, second = tab.work.series()
    assert name in second.name
    # The connections are the same, so the spectrum is not computed again.
    assert second.spectrum is first.spectrum
    assert second.geodesic is not first.geodesic


def test_second_model_that_is_not_there_is_told(qtbot, session, tab):
    told = []
    session.failed.connect(told.append)
    tab.second.choose("gone.ply")
    qtbot.waitUntil(lambda: bool(told))
    assert "gone.ply" in told[0]
    assert tab.second.chosen == "none"


def test_parameters_start_another_measurement(qtbot, tab):
    tab.side.geodesic.set_values({"along": "edges", "sources": 10})
    tab.side.geodesic.changed.emit({})
    tab.side.matrix.setCurrentIndex(1)
    settle(qtbot, tab)
    (series,) = tab.work.series()
    assert (series.geodesic.params.along, series.geodesic.sources) == ("edges", 10)
    assert series.spectrum.matrix == "normalized_laplacian"


def test_results_are_kept(qtbot, tab):
    before = tab.work.series()[0]
    tab.side.matrix.setCurrentIndex(1)
    settle(qtbot, tab)
    tab.side.matrix.setCurrentIndex(0)
    assert tab.work.series()[0].spectrum is before.spectrum
    assert tab.work.activity is None


def test_other_model_of_the_session_is_taken(qtbot, session, tab, tmp_path):
    path = tmp_path / "torus.ply"
    save_mesh(primitives.torus(), path)
    session.apply(session.study.model_copy(update={"model": str(path)}), "Open")
    qtbot.waitUntil(lambda: tab.work.models[0].name == "torus", timeout=20_000)
    settle(qtbot, tab)
    assert len(tab.work.series()[0].connectivity.degrees) == 288


def test_cancel_and_go_on(qtbot, session, tab, tmp_path):
    path = tmp_path / "large.ply"
    save_mesh(primitives.sphere(5), path)
    tab.second.choose(str(path))
    qtbot.waitUntil(lambda: len(tab.work.models) == 2 and tab.work.activity is not None)
    session.cancel()
    qtbot.waitUntil(lambda: tab.work.activity is None, timeout=20_000)
    assert tab.side.go_on.isVisible()
    assert tab.work.cancelled
    tab.side.go_on.click()
    settle(qtbot, tab)
    assert not tab.work.cancelled
    assert tab.work.series()[1].geodesic.sources == 200


def test_enlarge_and_back(qtbot, tab):
    tab.plots["degree"].enlarge.click()
    assert tab.plots["degree"].isVisible()
    assert tab.view.isVisible()
    assert not tab.plots["spectrum"].isVisible()
    tab.plots["degree"].enlarge.click()
    assert all(plot.isVisible() for plot in tab.plots.values())
    assert not tab.matrix.isVisible()


def test_matrix_beside_the_model(qtbot, tab, tmp_path):
    tab.enlarge("matrix")
    qtbot.waitUntil(lambda: "162 × 162, 1,122 entries" in tab.matrix.words.text())
    assert tab.matrix.isVisible()
    assert tab.view.isVisible()
    for name in ("matrix.mtx", "matrix.npz", "matrix.png"):
        cell_writer(tab, "matrix")(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 500


@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_plots_are_saved(tab, tmp_path, suffix):
    for plot in tab.plots:
        path = tmp_path / f"{plot}.{suffix}"
        cell_writer(tab, plot)(path)
        assert path.stat().st_size > 1000


def test_numbers_are_copied(tab):
    copy_numbers(tab, "degree")
    lines = QGuiApplication.clipboard().text().splitlines()
    assert lines[0] == "model\tdegree\tvertices\tshare"
    assert lines[1].startswith("ball\t5\t12\t0.07407")


def test_theme_reaches_the_plots(qtbot, tab):
    tab.set_theme(DARK)
    figure = tab.plots["degree"].canvas.figure
    ground = tuple(int(DARK.panel[i : i + 2], 16) / 255 for i in (1, 3, 5))
    qtbot.waitUntil(lambda: figure.get_facecolor()[:3] == pytest.approx(ground))


def test_distances_as_share_of_the_longest(qtbot, tab):
    tab.side.relative.setChecked(True)
    axes = tab.plots["geodesic"]
    qtbot.waitUntil(lambda: "longest" in axes._axes.get_xlabel())
    assert axes._axes.get_xlim()[1] < 1.3


def test_mesh_tools_are_undoable(qtbot, session, tab, tmp_path, monkeypatch):
    monkeypatch.setattr(statistics_tools, "user_cache_path", lambda *_, **__: tmp_path)
    statistics_tools.remesh(session, "barycentric")
    qtbot.waitUntil(
        lambda: session.meshes.name == "ball_barycentric.ply" and session.activity is None,
        timeout=60_000,
    )
    assert len(session.meshes.comparison.original.faces) == 6 * 320
    assert session.history.undo_name == "Barycentric subdivision (× 6)"
    session.undo()
    qtbot.waitUntil(lambda: session.meshes.name == "ball.ply", timeout=20_000)


def test_a_decimation_that_is_cancelled_leaves_nothing(qtbot, session, tmp_path, monkeypatch):
    """It takes place in another process, which is ended, and the worker goes on."""
    run_apart, begun, free = remesh.run_apart, threading.Event(), threading.Event()

    def endless(*work):
        begun.set()
        yield from run_apart(*work)
        while True:
            yield None

    monkeypatch.setattr(statistics_tools, "user_cache_path", lambda *_, **__: tmp_path / "cache")
    monkeypatch.setattr(remesh, "_LONG", -1)
    monkeypatch.setattr(remesh, "run_apart", endless)
    before = session.study
    statistics_tools.remesh(session, "half")
    qtbot.waitUntil(begun.is_set, timeout=20_000)
    session.cancel()
    session.jobs.start(Job(iter([None]), on_done=free.set))
    qtbot.waitUntil(free.is_set, timeout=20_000)
    assert session.study is before
    assert not (tmp_path / "cache").exists()
    assert "burnish-apart" not in [thread.name for thread in threading.enumerate()]
