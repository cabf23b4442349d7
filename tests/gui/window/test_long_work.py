"""What runs, in one place: seen, cancelled, and left behind when the window closes."""

import os
import subprocess
import sys
import threading
import time

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.session import Job
from core.io import save_mesh
from core.mesh import primitives

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def status(user):
    return user.window.statusBar()


def _start(user, gate, title, **options):
    """Start a step that cannot be cut until the gate is opened."""

    def steps():
        yield 0
        gate.wait(60)
        yield 1

    return user.window.session.jobs.start(Job(steps(), title=title, **options))


def _click(widget):
    QTest.mouseClick(widget, LEFT)


def _stands_above(status):
    """Whether the list is inside the window, above the status bar."""
    frame = status.list.frameGeometry()
    is_above = frame.bottom() <= status.mapToGlobal(status.rect().topLeft()).y()
    return is_above and status.window().frameGeometry().contains(frame)


def test_quick_work_is_not_shown(user, ball_file, status, qtbot):
    shown = []
    status.busy_changed.connect(lambda: shown.append(1))
    job = user.window.session.jobs.start(Job(iter([1, 2])))
    user.wait(lambda: job not in [state.task for state in user.window.session.tasks.states()])
    qtbot.wait(600)
    assert not shown
    assert not status.summary.isVisible()


def test_the_status_bar_sums_up_and_the_list_shows_each(user, status, gate):
    half = {"share": lambda: 0.5}
    jobs = [_start(user, gate, title, **half) for title in ("Mean filter", "Spectrum of cow")]
    user.wait(status.summary.isVisible)
    user.wait(lambda: status.summary.text.startswith("Mean filter and 1 more: 50 %"))
    _click(status.summary)
    user.wait(status.list.isVisible)
    user.wait(lambda: list(status.list.rows) == jobs)
    assert status.list.rows[jobs[1]].strip.text.startswith("Spectrum of cow: 50 %")
    assert _stands_above(status)


def test_the_open_list_grows_upwards(user, status, gate):
    _start(user, gate, "Mean filter")
    user.wait(status.summary.isVisible)
    _click(status.summary)
    _start(user, gate, "Spectrum of cow")
    user.wait(lambda: len(status.list.rows) == 2)
    user.wait(lambda: all(row.isVisible() for row in status.list.rows.values()))
    user.qtbot.wait(50)
    assert _stands_above(status)


def test_one_thing_is_cancelled_in_the_list(user, status, gate):
    jobs = [_start(user, gate, title) for title in ("Mean filter", "Spectrum of cow")]
    user.wait(status.summary.isVisible)
    _click(status.opener)
    user.wait(lambda: list(status.list.rows) == jobs)
    _click(status.list.rows[jobs[1]].button)
    assert [job.cancelled for job in jobs] == [False, True]
    gate.set()
    user.wait(lambda: not status.list.rows)
    assert status.list._nothing.isVisible()
    user.wait(lambda: not status.is_busy)


def test_cancel_all_and_escape_reach_everything(user, status, gate):
    jobs = [_start(user, gate, title) for title in ("Mean filter", "Spectrum of cow")]
    user.wait(status.summary.isVisible)
    _click(status.opener)
    user.wait(status.list.isVisible)
    _click(status.list.cancel_all)
    assert all(job.cancelled for job in jobs)
    QTest.keyClick(status.list, Qt.Key.Key_Escape)
    assert not status.list.isVisible()
    late = _start(user, gate, "Decimation")
    user.press(Qt.Key.Key_Escape)
    assert late.cancelled
    gate.set()
    user.wait(lambda: not status.is_busy)
    assert not user.window.actions_["cancel"].isEnabled()


def test_a_method_is_cancelled_alone_and_keeps_what_it_has(user, ball_file):
    user.open(ball_file)
    session = user.window.session
    reached = []

    def cancel(method):
        if method == "median" and not reached:
            reached.append(session.run(method).computed)
            tasks = [state.task for state in session.tasks.states()]
            session.tasks.cancel(next(task for task in tasks if "median" in task.title))

    session.run_changed.connect(cancel)
    for method in ("mean", "median"):
        user.type_iterations(method, 100)
    user.wait(lambda: reached)
    user.rest()
    assert session.study.choice("median").iterations == reached[0] < 100
    assert session.shown_iteration("median") == reached[0]
    assert session.run("mean").computed == 100


def test_cancel_reaches_the_statistics(user, tmp_path, status):
    path = tmp_path / "large.ply"
    save_mesh(primitives.sphere(5), path)
    user.open(path)
    statistics = user.window.statistics
    user.window.tabs.setCurrentWidget(statistics)
    user.wait(lambda: statistics.work.activity)
    user.wait(user.window.actions_["cancel"].isEnabled)
    user.press(Qt.Key.Key_Escape)
    user.wait(lambda: statistics.work.activity is None)
    assert statistics.work.cancelled
    assert statistics.side.go_on.isVisible()


def test_a_fault_in_the_statistics_is_reported_like_all_others(user, ball_file, monkeypatch):
    from app.ui import statistics_work

    def broken(*_):
        raise ZeroDivisionError("a fault")
        yield

    monkeypatch.setattr(statistics_work, "spectrum_steps", broken)
    user.open(ball_file)
    faults = []
    user.window.session.broken.disconnect()
    user.window.session.broken.connect(faults.append)
    user.window.tabs.setCurrentWidget(user.window.statistics)
    user.wait(lambda: faults)
    assert isinstance(faults[0], ZeroDivisionError)


def test_the_window_closes_while_a_step_cannot_be_cut(user, ball_file, gate):
    user.open(ball_file)
    user.window.files.discard_changes()
    job = _start(user, gate, "Decimation")
    user.wait(lambda: user.window.session.tasks.states(older_than=0.1))
    started = time.monotonic()
    user.window.close()
    # The step would take a minute; the rest is room for a busy machine.
    assert time.monotonic() - started < 20
    assert not user.window.isVisible()
    assert job not in [state.task for state in user.window.session.tasks.states()]


def test_closing_waits_for_a_study_that_is_being_saved(user, ball_file, tmp_path, monkeypatch):
    from app.ui import study_files

    user.open(ball_file)
    user.type_iterations("mean", 7)
    user.rest()
    write, begun = study_files.write_study_file, threading.Event()

    def slowly(*arguments, **options):
        begun.set()
        time.sleep(1)
        write(*arguments, **options)

    monkeypatch.setattr(study_files, "write_study_file", slowly)
    path = tmp_path / "late.burnish"
    user.press(Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    user.answer_file_dialog(path)
    user.wait(begun.is_set)
    user.window.close()
    user.wait(lambda: not user.window.isVisible())
    assert path.exists()


_PROGRAM = """
import sys
from PySide6.QtCore import QSettings, QTimer
QSettings.setDefaultFormat(QSettings.Format.IniFormat)
QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, sys.argv[2])
from app.ui import main_window
from core.study import MOST_ITERATIONS
shown = main_window.MainWindow.show

def show(window):
    shown(window)
    session = window.session

    def start():
        study = session.study
        for choice in study.methods:
            update = {"enabled": True, "iterations": MOST_ITERATIONS}
            study = study.with_choice(choice.model_copy(update=update))
        session.apply(study, "All")
        session.run_changed.connect(close)

    def close(_):
        session.run_changed.disconnect(close)
        assert len([s for s in session.tasks.states() if s.share is not None]) == 6
        window.files.discard_changes()
        QTimer.singleShot(0, window.close)
        print("closing", flush=True)

    session.meshes_changed.connect(lambda: QTimer.singleShot(0, start))

main_window.MainWindow.show = show
from app.ui.application import start
sys.exit(start(sys.argv[1]))
"""


def test_a_process_with_six_methods_at_work_ends_cleanly(qtbot, tmp_path):
    path = tmp_path / "large.ply"
    save_mesh(primitives.sphere(5), path)
    state = tmp_path / "state"
    environment = {**os.environ, "XDG_STATE_HOME": str(state),
                   "XDG_CACHE_HOME": str(tmp_path / "cache")}  # fmt: skip
    words = [sys.executable, "-c", _PROGRAM, str(path), str(tmp_path / "settings")]
    program = subprocess.Popen(words, env=environment, stdout=subprocess.PIPE, text=True)
    try:
        assert program.stdout.readline() == "closing\n"
        started = time.monotonic()
        # It takes half a second by itself; the rest is room for a busy machine.
        assert program.wait(timeout=20) == 0
        assert time.monotonic() - started < 10
        assert not list(state.rglob("study.json"))  # nothing is left to recover
    finally:
        program.kill()
        program.stdout.close()
        program.wait()
