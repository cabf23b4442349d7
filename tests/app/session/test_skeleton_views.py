"""The graphs of the Skeleton tab: what is drawn, when, and of which surface."""

import queue
import time

import numpy as np
import pytest

from app.session import Session, skeleton_maker
from app.session.skeleton_invariance import is_same_graph, random_motion
from app.session.skeleton_maker import SkeletonMaker, SkeletonSource
from app.session.skeleton_views import SkeletonViews
from core.io import save_mesh
from core.mesh import primitives, remesh
from core.skeleton import skeletal_graph
from core.study import MethodChoice, SkeletonSettings, SkeletonView, Study

_LONG = 60.0


class Desk:
    """A session with its graphs, and the thread that owns them."""

    def __init__(self):
        self.calls = queue.Queue()
        self.session = Session(self.calls.put)
        self.views = SkeletonViews(self.session)
        self.changes, self.notes = [], []
        self.views.changed.connect(self.changes.append)
        self.session.notified.connect(self.notes.append)

    def work_until(self, condition):
        end = time.monotonic() + _LONG
        while not condition():
            self.calls.get(timeout=max(end - time.monotonic(), 0.01))()

    def settle(self):
        self.work_until(lambda: self.session.activity is None and self.views.is_settled)

    def change(self, view, **update):
        settings = self.session.study.skeleton
        changed = settings.views[view].model_copy(update=update)
        study = self.session.study.model_copy(
            update={"skeleton": settings.with_view(view, changed)}
        )
        self.session.apply(study, "Change")


@pytest.fixture
def desk(tmp_path):
    path = tmp_path / "torus.ply"
    save_mesh(primitives.torus(40, 20), path)
    desk = Desk()
    methods = (MethodChoice(method="mean", iterations=2),)
    desk.session.apply(Study(model=str(path), methods=methods), "Open")
    desk.settle()
    yield desk
    desk.session.close()


@pytest.fixture
def awake(desk):
    desk.views.set_awake(True)
    desk.settle()
    return desk


def test_nothing_is_drawn_before_the_tab_is_shown(desk):
    assert desk.changes == []
    assert desk.views.skeleton(0) is None


def test_both_views_are_drawn_once_it_is(awake):
    assert [awake.views.skeleton(view).view.field for view in (0, 1)] == ["euclidean", "mixture"]
    graph = awake.views.skeleton(1).graph
    assert graph.loops == 1
    assert awake.views.skeleton(1).genus == 1


def test_one_view_alone_draws_only_the_right_one(desk):
    settings = SkeletonSettings(compare=False)
    study = desk.session.study.model_copy(update={"skeleton": settings})
    desk.session.apply(study, "Compare")
    desk.views.set_awake(True)
    desk.settle()
    assert set(desk.changes) == {1}


def test_a_dragged_slider_ends_at_its_last_place(awake):
    for resolution in range(1, 40):
        awake.change(1, resolution=resolution)
    awake.work_until(lambda: awake.views.skeleton(1).view.resolution == 39)
    awake.settle()
    assert awake.views.skeleton(1).graph.resolution == 39
    assert awake.changes.count(1) < 39


def test_the_surface_is_kept_while_only_the_resolution_changes(awake):
    before = awake.views.skeleton(1)
    awake.change(1, resolution=9)
    awake.settle()
    after = awake.views.skeleton(1)
    assert after.mesh is before.mesh
    assert after.field is before.field


@pytest.mark.parametrize("source", ["original", "noisy", "mean"])
def test_every_surface_of_the_denoise_tab_has_a_graph(awake, source):
    awake.change(1, source=source)
    awake.settle()
    vertices = awake.views.skeleton(1).mesh.vertices
    comparison = awake.session.meshes.comparison
    expected = {
        "original": comparison.original.vertices,
        "noisy": comparison.noisy.vertices,
        "mean": awake.session.run("mean").vertices(2),
    }
    assert np.allclose(vertices, expected[source])


def test_a_surface_that_is_not_there_is_explained(awake):
    awake.change(1, source="bilateral")
    awake.settle()
    assert awake.views.skeleton(1) is None
    assert "has not run" in awake.views.problem(1)


def test_a_setting_that_is_not_allowed_is_explained(awake):
    awake.change(1, field="height", params={"z": 0.0})
    awake.settle()
    assert awake.views.skeleton(1) is None
    assert "(0, 0, 0)" in awake.views.problem(1)


def test_decimation_leaves_a_share_of_the_faces(awake):
    awake.change(0, keep=0.25)
    awake.settle()
    assert len(awake.views.skeleton(0).mesh.faces) == pytest.approx(400, abs=4)
    assert awake.views.skeleton(0).graph.loops == 1


def test_undo_brings_the_old_graph_back(awake):
    awake.change(1, resolution=5)
    awake.settle()
    awake.session.undo()
    awake.settle()
    assert awake.views.skeleton(1).view.resolution == 22


def test_automatic_resolution_goes_into_the_study(awake):
    awake.views.find_resolution(1)
    awake.work_until(lambda: awake.notes)
    awake.settle()
    assert awake.session.study.skeleton.views[1].resolution < 22
    assert "1 loops" in awake.notes[-1]


def test_a_motion_leaves_the_graph_as_it_is(awake):
    reports = []
    awake.views.invariance_checked.connect(lambda _, report: reports.append(report))
    awake.views.check_invariance(1, 7)
    awake.work_until(lambda: reports)
    (report,) = reports
    assert report.isomorphic
    assert report.before == report.after
    assert report.displacement < 1e-9
    assert "the same graph" in report.text


def test_a_height_turns_with_the_direction_and_the_report_says_so(awake):
    reports = []
    awake.views.invariance_checked.connect(lambda _, report: reports.append(report))
    awake.change(1, field="height", params={"x": 0.3, "z": 1.0})
    awake.settle()
    awake.views.check_invariance(1, 7)
    awake.work_until(lambda: reports)
    assert not reports[0].isomorphic
    assert "another graph" in reports[0].text


def test_a_motion_can_be_undone():
    points = np.random.default_rng(1).normal(size=(5, 3))
    motion = random_motion(3, 2.0)
    assert np.allclose(motion.undo(motion.move(points)), points)
    assert np.linalg.det(motion.matrix) < 0


def test_same_graph_means_isomorphic_with_bands():
    one = skeletal_graph(primitives.torus(), "height", 8, x=1, z=0)
    assert is_same_graph(one, skeletal_graph(primitives.torus(), "height", 8, x=-1, z=0))
    assert not is_same_graph(one, skeletal_graph(primitives.torus(), "height", 9, x=1, z=0))


def test_the_settings_are_part_of_the_study_file():
    view = SkeletonView(source="noisy", keep=0.5, field="mixture", params={"weight": 0.3})
    study = Study(skeleton=SkeletonSettings(views=(view, SkeletonView()), show_shells=True))
    assert Study.model_validate_json(study.model_dump_json()) == study


def test_what_was_cancelled_is_told_and_drawn_on_request(awake):
    awake.change(1, resolution=30)
    assert not awake.views.is_cancelled(1)
    awake.session.cancel()
    awake.settle()
    assert awake.views.is_cancelled(1)
    assert awake.views.skeleton(1).view.resolution == 22
    awake.views.resume(1)
    assert not awake.views.is_cancelled(1)
    awake.settle()
    assert awake.views.skeleton(1).view.resolution == 30


def test_what_was_cancelled_is_not_begun_again_by_itself(awake):
    awake.change(1, resolution=30)
    awake.session.cancel()
    awake.change(0, resolution=9)
    awake.settle()
    assert awake.views.skeleton(0).view.resolution == 9
    assert awake.views.skeleton(1).view.resolution == 22
    assert awake.views.is_cancelled(1)


@pytest.mark.parametrize("resolution", [22, 31])
def test_another_resolution_ends_a_cancellation(awake, resolution):
    awake.change(1, resolution=30)
    awake.session.cancel()
    awake.change(1, resolution=resolution)
    assert not awake.views.is_cancelled(1)
    awake.settle()
    assert awake.views.skeleton(1).view.resolution == resolution


def test_what_was_drawn_already_is_not_called_cancelled(awake):
    awake.change(1, resolution=30)
    awake.change(1, resolution=22)
    awake.session.cancel()
    assert not awake.views.is_cancelled(1)


def test_a_large_surface_is_decimated_in_steps(monkeypatch):
    """Both what is shown and its coarse copy come from another process where that takes long."""
    monkeypatch.setattr(remesh, "_LONG", -1)
    monkeypatch.setattr(skeleton_maker, "_SKETCH_FACES", 300)
    ball = primitives.sphere(3)
    maker, view = SkeletonMaker(), SkeletonView(keep=0.5)
    source = SkeletonSource("ball", lambda: ball)
    *waiting, last = maker.steps(source, view)
    assert len(waiting) > 2
    assert {step.value for step in waiting} == {None}
    at_once = SkeletonMaker().make(source, view)
    assert np.array_equal(last.value.mesh.vertices, at_once.mesh.vertices)
    assert np.array_equal(last.value.sketch.nearest, at_once.sketch.nearest)
    assert len(last.value.sketch.mesh.faces) <= 300 < len(last.value.mesh.faces) == 640
