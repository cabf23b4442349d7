"""The session as a window uses it, without a window: calls come back through a queue."""

import queue
import time
from pathlib import Path

import numpy as np
import pytest

from app.session import Session
from core.io import save_mesh
from core.mesh import primitives
from core.noise import NoiseParams
from core.study import MethodChoice, Study

_LONG = 60.0


class Desk:
    """A session and the thread that owns it."""

    def __init__(self):
        self.calls = queue.Queue()
        self.session = Session(self.calls.put)
        self.failures = []
        self.faults = []
        self.session.failed.connect(self.failures.append)
        self.session.broken.connect(self.faults.append)

    def work_until(self, condition):
        end = time.monotonic() + _LONG
        while not condition():
            self.calls.get(timeout=max(end - time.monotonic(), 0.01))()

    def rest(self):
        self.work_until(lambda: self.session.activity is None)


@pytest.fixture
def ball_file(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(2), path)
    return str(path)


@pytest.fixture
def desk():
    desk = Desk()
    yield desk
    desk.session.close()


def study_of(path, *methods, iterations=3):
    choices = tuple(MethodChoice(method=m, iterations=iterations) for m in methods)
    return Study(model=path, methods=choices)


def test_opening_a_model_runs_its_methods(desk, ball_file):
    desk.session.apply(study_of(ball_file, "mean", "diffusion"), "Open")
    desk.rest()
    for method in ("mean", "diffusion"):
        run = desk.session.run(method)
        assert run.computed == 3
        assert len(run.positions) == 4
        assert desk.session.shown_iteration(method) == 3


def test_more_iterations_go_on_where_the_run_stopped(desk, ball_file):
    study = study_of(ball_file, "mean")
    desk.session.apply(study, "Open")
    desk.rest()
    first = desk.session.run("mean").positions[3]
    choice = study.methods[0].model_copy(update={"iterations": 7})
    desk.session.apply(study.with_choice(choice), "Iterations")
    desk.rest()
    run = desk.session.run("mean")
    assert run.computed == 7
    assert run.positions[3] is first


def test_other_parameters_are_another_run_and_undo_brings_the_first_back(desk, ball_file):
    study = study_of(ball_file, "diffusion")
    desk.session.apply(study, "Open")
    desk.rest()
    first = desk.session.run("diffusion")
    choice = study.methods[0].model_copy(update={"params": {"gradient_scale": 10.0}})
    desk.session.apply(study.with_choice(choice), "Parameters")
    desk.rest()
    assert desk.session.run("diffusion") is not first
    assert desk.session.history.undo_name == "Parameters"
    desk.session.undo()
    assert desk.session.run("diffusion") is first
    desk.session.redo()
    assert desk.session.study.methods[0].params == {"gradient_scale": 10.0}


def test_noise_changes_the_meshes_and_shares_the_topology(desk, ball_file):
    study = study_of(ball_file, "mean")
    desk.session.apply(study, "Open")
    desk.rest()
    before = desk.session.meshes.comparison
    desk.session.apply(study.model_copy(update={"noise": NoiseParams(sigma=0.3)}), "Noise")
    desk.rest()
    after = desk.session.meshes.comparison
    assert after.original is before.original
    assert after.noisy_errors["visual_error"] > before.noisy_errors["visual_error"]
    assert desk.session.run("mean").computed == 3


def test_a_file_that_cannot_be_read_leaves_everything_as_it_was(desk, ball_file, tmp_path):
    study = study_of(ball_file, "mean")
    desk.session.apply(study, "Open")
    desk.rest()
    meshes = desk.session.meshes
    desk.session.apply(study.model_copy(update={"model": str(tmp_path / "no.ply")}), "Open")
    desk.rest()
    assert len(desk.failures) == 1
    assert "no.ply" in desk.failures[0]
    assert desk.session.study == study
    assert desk.session.meshes is meshes


def test_what_is_changed_while_noise_is_added_is_kept(desk, ball_file):
    study = study_of(ball_file, "mean")
    desk.session.apply(study, "Open")
    desk.rest()
    desk.session.apply(study.model_copy(update={"noise": NoiseParams(sigma=0.3)}), "Noise")
    choice = study.methods[0].model_copy(update={"iterations": 5})
    desk.session.apply(desk.session.study.with_choice(choice), "Iterations")
    desk.rest()
    assert desk.session.study.noise.sigma == 0.3
    assert desk.session.shown_iteration("mean") == 5


def test_undo_to_a_file_that_is_gone_says_so_and_can_be_tried_again(desk, ball_file, tmp_path):
    other = tmp_path / "other.ply"
    save_mesh(primitives.torus(), other)
    desk.session.apply(study_of(ball_file, "mean"), "Open")
    desk.rest()
    desk.session.apply(study_of(str(other), "mean"), "Open other")
    desk.rest()
    Path(ball_file).rename(tmp_path / "away.ply")
    desk.session.undo()
    desk.rest()
    assert "ball.ply" in desk.failures[0]
    assert desk.session.study.model == str(other)
    (tmp_path / "away.ply").rename(ball_file)
    desk.session.undo()
    desk.rest()
    assert desk.session.study.model == ball_file


def test_cancel_keeps_what_is_there_and_moves_the_sliders_back(desk, ball_file):
    desk.session.apply(study_of(ball_file, "median", iterations=1000), "Open")
    desk.work_until(lambda: desk.session.meshes and desk.session.run("median").computed >= 3)
    desk.session.cancel()
    desk.rest()
    run, choice = desk.session.run("median"), desk.session.study.choice("median")
    assert 3 <= choice.iterations < 1000
    assert choice.iterations <= run.computed
    assert not desk.failures


def test_a_run_that_diverges_is_marked_and_not_tried_again(desk, tmp_path):
    ball = primitives.sphere(2)
    path = tmp_path / "far.ply"
    save_mesh(ball.with_vertices(ball.vertices + 30), path)
    wild = {"form": "printed", "raw_units": True, "c": 1000.0}
    study = Study(
        model=str(path),
        methods=(
            MethodChoice(method="diffusion", iterations=20, params=wild),
            MethodChoice(method="mean", iterations=4),
        ),
    )
    desk.session.apply(study, "Open")
    desk.rest()
    run = desk.session.run("diffusion")
    assert run.diverged == run.computed + 1
    assert np.isfinite(run.positions[-1]).all()
    assert desk.session.run("mean").computed == 4


def test_a_method_that_raises_is_told_once_and_leaves_the_others_alone(
    desk, ball_file, monkeypatch
):
    from core.smoothing import METHODS

    def fail(mesh, params):
        yield mesh.vertices
        raise RuntimeError("the kernel is on fire")

    spec = METHODS["bilateral"]
    monkeypatch.setitem(METHODS, "bilateral", type(spec)(**{**vars(spec), "steps": fail}))
    desk.session.apply(study_of(ball_file, "bilateral", "mean"), "Open")
    desk.rest()
    assert [str(fault) for fault in desk.faults] == ["the kernel is on fire"]
    assert not desk.failures
    assert desk.session.run("bilateral").computed == 1
    assert desk.session.run("mean").computed == 3


def test_old_runs_go_first_when_memory_is_short(ball_file):
    desk = Desk()
    desk.session.close()
    calls = queue.Queue()
    one_run = 4 * 162 * 3 * 4
    desk.calls, desk.session = calls, Session(calls.put, budget=2 * one_run)
    study = study_of(ball_file, "diffusion")
    desk.session.apply(study, "Open")
    desk.rest()
    first = desk.session.run("diffusion")
    for scale in (10.0, 20.0, 30.0):
        choice = study.methods[0].model_copy(update={"params": {"gradient_scale": scale}})
        desk.session.apply(study.with_choice(choice), f"Scale {scale}")
        desk.rest()
    desk.session.apply(study, "Back")
    desk.rest()
    again = desk.session.run("diffusion")
    assert again is not first
    assert np.array_equal(again.positions[3], first.positions[3])
    desk.session.close()


def test_steps_of_one_name_in_a_row_are_one_undo_step(desk, ball_file):
    study = study_of(ball_file, "mean", iterations=1)
    desk.session.apply(study, "Open")
    desk.rest()
    for iterations in (2, 3, 4):
        choice = study.methods[0].model_copy(update={"iterations": iterations})
        desk.session.apply(study.with_choice(choice), "Iterations")
    desk.session.undo()
    assert desk.session.study == study


def test_undoing_noise_brings_meshes_and_runs_back_at_once(desk, ball_file):
    study = study_of(ball_file, "mean")
    desk.session.apply(study, "Open")
    desk.rest()
    meshes, run = desk.session.meshes, desk.session.run("mean")
    desk.session.apply(study.model_copy(update={"noise": NoiseParams(sigma=0.3)}), "Noise")
    desk.rest()
    desk.session.undo()
    assert desk.session.activity is None
    assert desk.session.meshes is meshes
    assert desk.session.run("mean") is run


def test_methods_in_use_do_not_push_each_other_out(ball_file):
    desk = Desk()
    desk.session.set_budget(1)
    desk.session.apply(study_of(ball_file, "mean", "diffusion", "median"), "Open")
    desk.rest()
    assert [desk.session.run(m).computed for m in ("mean", "diffusion", "median")] == [3, 3, 3]
    desk.session.apply(study_of(ball_file, "mean"), "Fewer")
    desk.session.set_budget(1)
    desk.session.undo()
    desk.rest()
    assert desk.session.run("median").computed == 3
    desk.session.close()


def test_a_study_opened_while_another_changes_keeps_both(desk, ball_file, tmp_path):
    other = tmp_path / "other.ply"
    save_mesh(primitives.torus(), other)
    desk.session.apply(study_of(ball_file, "mean"), "Open")
    desk.rest()
    opened = study_of(str(other), "diffusion", iterations=2)
    desk.session.apply(opened, "Open other")
    view = desk.session.study.view.model_copy(update={"edges": True})
    desk.session.apply(desk.session.study.model_copy(update={"view": view}), "Edges")
    desk.rest()
    assert desk.session.study == opened.model_copy(update={"view": view})


def iterate(desk, method, iterations):
    choice = desk.session.study.choice(method).model_copy(update={"iterations": iterations})
    desk.session.apply(desk.session.study.with_choice(choice), "Iterations")
    desk.rest()


def test_when_memory_is_short_snapshots_go_and_numbers_stay(desk, ball_file):
    desk.session.apply(study_of(ball_file, "mean"), "Open")
    desk.rest()
    whole = desk.session.run("mean")
    desk.session.set_budget(2 * whole.positions[0].nbytes)
    run = desk.session.run("mean")
    assert [run.holds(k) for k in range(4)] == [True, False, False, True]
    assert run.errors == whole.errors
    with pytest.raises(LookupError):
        run.vertices(2)


def test_a_snapshot_that_is_gone_is_made_again_when_it_is_asked_for(desk, ball_file):
    desk.session.apply(study_of(ball_file, "mean", "median"), "Open")
    desk.rest()
    second = desk.session.run("mean").positions[2]
    desk.session.set_budget(1)
    iterate(desk, "mean", 2)
    assert desk.session.shown_iteration("mean") == 2
    assert np.array_equal(desk.session.run("mean").positions[2], second)
    iterate(desk, "mean", 1)
    run = desk.session.run("mean")
    assert [run.holds(k) for k in range(4)] == [True, True, False, True]
    iterate(desk, "mean", 5)
    assert desk.session.run("mean").computed == 5
    assert desk.session.shown_iteration("mean") == 5


def test_a_run_beyond_the_budget_goes_on_to_its_end(ball_file):
    desk = Desk()
    desk.session.set_budget(1)
    desk.session.apply(study_of(ball_file, "laplacian", iterations=12), "Open")
    desk.rest()
    run = desk.session.run("laplacian")
    assert (run.computed, len(run.errors)) == (12, 13)
    assert sum(run.holds(k) for k in range(13)) == 2
    desk.session.close()
