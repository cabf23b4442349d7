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

    def counted(self, choice, wanted):
        for snapshot in snapshots(self, choice, wanted):
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


def changes_of_the_skeleton(tab):
    """Change what the Skeleton tab keeps in the study; yields the name of each step."""
    bar = tab.centre.resolutions[0]
    bar.slider.setValue(9)
    yield None
    tab.side.layers.layers["show_curves"].click()
    yield None
    tab.side.compare.click()
    yield "Compare views"


def changes_of_the_statistics(tab):
    """Change what the Statistics tab keeps in the study; yields the name of each step."""
    side = tab.side
    side.colour.setCurrentIndex(side.colour.findData("degree"))
    yield "Colour of the models"
    side.matrix.setCurrentIndex(1)
    yield "Spectrum"
    side.relative.click()
    yield "Unit of the distances"
    side.geodesic.set_values({"sources": 20})
    side.geodesic.changed.emit({"sources": 20})
    yield "Geodesic distances"
    side.second.activated.emit(side.second.findData("noisy"))
    yield "Second model"


def counts(tab):
    """Nodes and arcs of the graphs that are shown, and the texts above them."""
    panes, _ = tab.panes(1.0)
    return [(pane.title, pane.caption) for pane in panes]


def test_steps_of_the_skeleton_tab_bring_graphs_and_numbers_back(user, ball_file):
    user.open(ball_file)
    user.press(Qt.Key.Key_2, CONTROL)
    tab, session = user.window.skeleton, user.window.session
    undo = user.window.actions_["undo"]

    def rest():
        user.wait(lambda: tab.views.is_settled and all(map(tab.views.skeleton, tab.views.shown)))

    rest()
    seen = [(session.study, counts(tab))]
    for name in changes_of_the_skeleton(tab):
        user.wait(lambda: session.study != seen[-1][0])
        rest()
        assert undo.text().startswith("&Undo ")
        assert name is None or undo.text() == f"&Undo {name}"
        seen.append((session.study, counts(tab)))
    assert seen[0][1] != seen[1][1]
    for study, shown in reversed(seen[:-1]):
        user.press(Qt.Key.Key_Z, CONTROL)
        assert session.study == study
        rest()
        user.wait(lambda shown=shown: counts(tab) == shown)
    assert not undo.isEnabled()
    for study, shown in seen[1:]:
        user.press(Qt.Key.Key_Z, CONTROL | SHIFT)
        assert session.study == study
        rest()
        user.wait(lambda shown=shown: counts(tab) == shown)


def numbers(tab):
    """What panel, plots and models of the statistics show."""
    series = tab.work.series()
    side = tab.side
    return (
        side.settings(),
        side.second.currentData(),
        [one.name for one in series],
        [one.relative for one in series],
        [one.geodesic.pairs if one.geodesic else None for one in series],
        [one.spectrum.eigenvalues.sum() if one.spectrum else None for one in series],
    )


def test_steps_of_the_statistics_tab_bring_plots_and_numbers_back(user, ball_file):
    user.open(ball_file)
    user.press(Qt.Key.Key_3, CONTROL)
    tab, session = user.window.statistics, user.window.session
    undo = user.window.actions_["undo"]

    def rest(count):
        user.wait(lambda: len(tab.work.series()) == count and tab.work.activity is None)

    rest(1)
    seen = [(session.study, numbers(tab))]
    for name in changes_of_the_statistics(tab):
        user.wait(lambda: session.study != seen[-1][0])
        rest(1 + (session.study.statistics.second != "none"))
        assert undo.text() == f"&Undo {name}"
        seen.append((session.study, numbers(tab)))
    assert len({str(shown) for _, shown in seen}) == len(seen)
    for study, shown in reversed(seen[:-1]):
        user.press(Qt.Key.Key_Z, CONTROL)
        assert session.study == study
        user.wait(lambda shown=shown: str(numbers(tab)) == str(shown))
    assert not undo.isEnabled()
    for study, shown in seen[1:]:
        user.press(Qt.Key.Key_Z, CONTROL | SHIFT)
        assert session.study == study
        user.wait(lambda shown=shown: str(numbers(tab)) == str(shown))
