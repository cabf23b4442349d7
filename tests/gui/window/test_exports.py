"""Exports: the window stays awake, they stand in the list of what runs, and end whole or not."""

import json
import threading
import time

import pytest
from matplotlib.image import imread
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtWidgets import QMessageBox

from app.export.statistics_bundle import write_statistics
from app.ui.exporting import export, in_one_step
from app.ui.montage_dialog import MontageDialog
from app.ui.screenshot_dialog import ScreenshotDialog
from app.ui.statistics_saving import bundle
from core import whole_files
from core.statistics import finished, statistics_steps
from core.whole_files import whole_file, write_atomically

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def statistics(user, ball_file):
    user.open(ball_file)
    tab = user.window.statistics
    user.window.tabs.setCurrentWidget(tab)
    user.wait(lambda: tab.work.summaries() and tab.work.activity is None)
    return tab


def titles(user):
    return [state.task.title for state in user.window.session.tasks.states()]


def said(user):
    return user.window.statusBar().currentMessage()


def start(user, path, steps):
    return export(user.window.session, path, steps)


def test_the_window_turns_while_a_file_is_written(user, ball_file, folder, gate):
    user.open(ball_file)
    ticks = []
    timer = QTimer(interval=1)
    timer.timeout.connect(lambda: ticks.append(threading.current_thread().name))
    timer.start()

    def steps(path, _):
        yield 0.5
        gate.wait(60)
        write_atomically(path, b"whole")
        yield 1.0

    start(user, folder / "a.txt", steps)
    status = user.window.statusBar()
    user.wait(lambda: status.is_busy and status.summary.text.startswith("Writing a.txt: 50 %"))
    ticks.clear()
    user.wait(lambda: len(ticks) > 20)
    gate.set()
    user.wait(lambda: said(user) == "Saved a.txt.")
    assert (folder / "a.txt").read_bytes() == b"whole"
    user.wait(lambda: not titles(user))


def test_one_that_is_cancelled_while_it_writes_leaves_the_old_file(user, folder, gate):
    path, begun = folder / "a.txt", threading.Event()
    path.write_bytes(b"old")

    def steps(path, _):
        begun.set()
        gate.wait(60)
        write_atomically(path, b"new")
        yield 1.0

    start(user, path, steps)
    user.wait(begun.is_set)
    user.window.session.cancel()
    gate.set()
    user.wait(lambda: not titles(user))
    assert path.read_bytes() == b"old"
    assert list(folder.iterdir()) == [path]
    assert not said(user)


def test_pieces_are_drawn_by_the_window_one_a_turn(user, folder):
    turns, drawn = [0], []
    timer = QTimer(interval=0)
    timer.timeout.connect(lambda: turns.append(turns[-1] + 1))
    timer.start()

    def pieces():
        for _ in range(3):
            drawn.append((threading.current_thread() is threading.main_thread(), turns[-1]))
            yield len(drawn)

    def steps(path, drawer):
        for piece in drawer(pieces()):
            assert threading.current_thread() is not threading.main_thread()
            yield piece / 4
        write_atomically(path, b"drawn")

    listeners = len(user.window.session.closing)
    start(user, folder / "a.txt", steps)
    user.wait((folder / "a.txt").exists)
    assert [here for here, _ in drawn] == [True] * 3
    user.wait(lambda: len(user.window.session.closing) == listeners)  # nothing stays behind


@pytest.mark.parametrize("fails", ["piece", "writing"])
def test_a_failure_is_one_sentence_and_what_was_drawn_is_closed(user, folder, fails):
    closed = []

    def pieces():
        try:
            yield 1
            if fails == "piece":
                raise ValueError("The piece cannot be drawn.")
            yield 2
        finally:
            closed.append(threading.current_thread() is threading.main_thread())

    def steps(path, drawer):
        for _ in drawer(pieces()):
            write_atomically(path.with_name(f"{time.monotonic_ns()}"), b"")
            yield 0.5
        write_atomically(path / "nowhere", b"")

    start(user, folder / "a.txt", steps)
    user.wait(lambda: user.window.findChildren(QMessageBox))
    text = user.window.findChildren(QMessageBox)[0].text()
    expected = {
        "piece": "The piece cannot be drawn.",
        "writing": f"{folder / 'a.txt'} cannot be written: No such file or directory.",
    }
    assert text == expected[fails]
    user.wait(lambda: closed)
    assert closed == [True]
    assert not list(folder.iterdir())
    user.window.findChildren(QMessageBox)[0].close()


def test_closing_gives_up_what_is_drawn_and_finishes_what_is_written(user, ball_file, folder):
    user.open(ball_file)
    closed = []

    def endless():
        try:
            while True:
                yield 1
        finally:
            closed.append(1)

    def film(path, drawer):
        for _ in drawer(endless()):
            write_atomically(path, b"half")
            yield 0.1

    reached = threading.Event()

    def slowly():
        reached.set()
        time.sleep(0.1)
        write_atomically(folder / "whole", b"whole")

    user.window.files.discard_changes()
    job = start(user, folder / "film", film)
    user.wait(lambda: job.share() is not None)
    start(user, folder / "whole", lambda path, _: in_one_step(slowly))
    user.wait(reached.is_set)
    user.window.close()
    assert not user.window.isVisible()
    assert [file.name for file in folder.iterdir()] == ["whole"]
    assert closed


def test_closing_leaves_undone_what_takes_long_and_nothing_of_it_stays(
    user, ball_file, folder, gate
):
    user.open(ball_file)
    old, reached, ended = folder / "b.txt", threading.Event(), threading.Event()
    old.write_bytes(b"old")

    def steps(path, _):
        try:
            write_atomically(folder / "a.txt", b"new")
            write_atomically(old, b"new")
            yield 0.5
            with whole_file(path) as stream:
                reached.set()
                gate.wait(60)
                stream.write(b"late")
                ended.set()
        finally:
            reached.set()

    user.window.files.discard_changes()
    start(user, folder / "c.txt", steps)
    user.wait(reached.is_set)
    user.window.close()
    assert not user.window.isVisible()
    assert not gate.is_set()  # nobody waited for it
    assert [file.name for file in folder.iterdir()] == ["b.txt"]
    gate.set()
    user.window.session.exports._thread.join(60)
    assert not ended.is_set()
    assert [file.read_bytes() for file in folder.iterdir()] == [b"old"]


@pytest.mark.parametrize("suffix", [".png", ".pdf"])
def test_a_figure_that_is_cancelled_while_it_is_written_stops_there(
    user, ball_file, folder, suffix, monkeypatch
):
    user.open(ball_file)
    dialog = MontageDialog(user.window)
    dialog.dpi.setValue(60)
    session, writes, cancelled = user.window.session, [], threading.Event()
    take = whole_files._Stream.write

    def cancel():
        session.cancel()
        cancelled.set()

    def write(stream, content, /):
        if whole_files._STAGING.get():  # it belongs to an export, not to a small picture
            writes.append(len(content))
            if len(writes) == 1:
                session.post(cancel)
                cancelled.wait(60)
        return take(stream, content)

    monkeypatch.setattr(whole_files._Stream, "write", write)
    dialog.save(folder / f"figure{suffix}")
    user.wait(cancelled.is_set)
    user.wait(lambda: not titles(user))
    assert not list(folder.iterdir())
    assert len(writes) == 1


def test_the_bundle_is_that_of_the_command_line(user, statistics, tmp_path, folder):
    model = statistics.work.models[0]
    bundle(statistics, model, folder)
    user.wait(lambda: said(user) == "Saved the statistics into out.")
    numbers = finished(statistics_steps(model.mesh, statistics.work.geodesic))
    write_statistics(model.name, model.mesh, numbers, tmp_path / "there")
    names = {file.name for file in folder.iterdir()}
    assert names == {file.name for file in (tmp_path / "there").iterdir()}
    for name in names - {"figure.png", "statistics.json"}:
        assert (folder / name).read_bytes() == (tmp_path / "there" / name).read_bytes(), name
    here, there = (imread(place / "figure.png") for place in (folder, tmp_path / "there"))
    assert abs(here - there).max() < 0.02
    assert json.loads((folder / "statistics.json").read_text())["vertices"] == 642


def test_a_bundle_that_is_cancelled_on_the_way_leaves_nothing(user, statistics, folder):
    tasks = user.window.session.tasks
    bundle(statistics, statistics.work.models[0], folder)

    def writing():
        found = [state for state in tasks.states() if state.title == "Writing out"]
        return found and found[0].share

    user.wait(writing)
    user.window.session.cancel()
    user.wait(lambda: not tasks.states())
    assert not list(folder.iterdir())


def test_a_figure_is_of_the_moment_in_which_it_was_asked_for(user, ball_file, folder):
    user.open(ball_file)
    user.press(Qt.Key.Key_F, CONTROL | SHIFT)
    dialog = user.window.findChild(MontageDialog)
    dialog.dpi.setValue(60)
    source, montage = dialog.source, dialog.montage()
    before = [pane.points.copy() for pane in source.panes]
    dialog.save(folder / "figure.png")
    user.type_iterations("mean", 40)
    user.wait((folder / "figure.png").exists)
    assert all((pane.points == old).all() for pane, old in zip(source.panes, before, strict=True))
    assert imread(folder / "figure.png").shape[1] == round(montage.width / 2.54 * 60)


def test_the_whole_window_is_pictured(user, ball_file, folder):
    user.open(ball_file)
    user.press(Qt.Key.Key_P, CONTROL)
    dialog = user.window.findChild(ScreenshotDialog)
    dialog.subject.setCurrentIndex(dialog.subject.findData("window"))
    dialog.scale.setValue(1)
    dialog._accept()
    user.answer_file_dialog(folder / "window.png")
    user.wait((folder / "window.png").exists)
    picture = imread(folder / "window.png")
    assert picture.shape[:2] == (user.window.height(), user.window.width())
    area, middle = user.denoise.viewport.interactor, user.middle_of("original")
    place = area.mapTo(user.window, middle)
    ground = area.mapTo(user.window, area.rect().topLeft() + QPoint(6, 60))
    assert abs(picture[place.y(), place.x()] - picture[ground.y(), ground.x()]).max() > 0.05
