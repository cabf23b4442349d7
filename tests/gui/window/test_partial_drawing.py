"""Panes that are drawn one by one and only where they changed give the picture of them all."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QGuiApplication

from app.scene.due import Due
from core.smoothing import METHODS


def rows(picture):
    image = picture.convertToFormat(picture.Format.Format_RGB888)
    bits = np.array(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return bits[:, : 3 * image.width()].copy()


def on_screen(user):
    """Pixels of the drawing area as the screen shows them, without any drawing."""
    area = user.denoise.viewport.interactor
    place, size = area.mapToGlobal(QPoint(0, 0)), area.size()
    screen = QGuiApplication.primaryScreen()
    shot = screen.grabWindow(0, place.x(), place.y(), size.width(), size.height())
    return rows(shot.toImage())


def is_whole(user):
    """Whether the screen shows what it shows once everything has been drawn anew."""
    user.rest()
    area, due = user.denoise.viewport.interactor, user.denoise.viewport._due
    shown = on_screen(user)
    due.forget()
    area.repaint()
    return np.array_equal(shown, on_screen(user)) and shown.std() > 10


@pytest.fixture
def drawn(monkeypatch, user):
    """What each drawing draws: ids of panes."""
    plain, drawn = Due.end, []

    def end(due):
        plain(due)
        grid = user.denoise.viewport.grid
        names = {grid.renderer(id_): id_ for id_ in grid.ids}
        drawn.append([names.get(view.renderers[0], "bar") for view in due._now])

    monkeypatch.setattr(Due, "end", end)
    return drawn


def run_all(user):
    study = user.window.session.study
    for choice in study.methods:
        wanted = {"enabled": choice.method in METHODS, "iterations": 8}
        study = study.with_choice(choice.model_copy(update=wanted))
    user.window.session.apply(study, "Run")


def test_the_picture_after_a_run_and_a_slider(user, ball_file, drawn):
    user.open(ball_file)
    run_all(user)
    assert is_whole(user)
    drawn.clear()
    user.type_iterations("mean", 3)
    user.rest()
    assert [panes for panes in drawn if panes] == [["mean"]]
    assert is_whole(user)


def test_no_drawing_takes_more_than_a_pane_while_methods_run(user, ball_file, drawn):
    user.open(ball_file)
    study = user.window.session.study
    view = study.view.model_copy(update={"colour": "vertex_rms", "histogram": True})
    user.window.session.apply(study.model_copy(update={"view": view}), "Colour")
    user.rest()
    drawn.clear()
    run_all(user)
    user.rest()
    assert max(map(len, drawn)) == 1
    assert {"bar", "mean", "median"} <= {pane for panes in drawn for pane in panes}
    assert is_whole(user)


def test_panes_never_contradict_each_other(user, ball_file, monkeypatch):
    """With other colours all panes change: the screen shows the old ones or the new ones."""
    user.open(ball_file)
    old, meanwhile, plain = on_screen(user), [], Due.draw_one

    def draw_one(due):
        answer = plain(due)
        meanwhile.append(on_screen(user))
        return answer

    with monkeypatch.context() as patch:
        patch.setattr(Due, "draw_one", draw_one)
        study = user.window.session.study
        view = study.view.model_copy(update={"colour": "vertex_rms"})
        user.window.session.apply(study.model_copy(update={"view": view}), "Colour")
        user.rest()
    assert len(meanwhile) >= len(user.denoise.viewport.grid.ids)
    assert all(np.array_equal(shown, old) for shown in meanwhile)
    assert not np.array_equal(on_screen(user), old)


def test_the_picture_after_another_size_theme_and_a_change_behind_another_tab(user, ball_file):
    user.open(ball_file)
    viewport = user.denoise.viewport
    user.window.resize(1180, 760)
    user.wait(lambda: viewport.interactor.render_window.GetSize() == viewport.pixel_size())
    viewport.interactor.repaint()
    assert is_whole(user)
    user.window.tabs.setCurrentIndex(1)
    user.type_iterations("median", 2)
    user.window.tabs.setCurrentIndex(0)
    user.wait(viewport.interactor.isVisible)
    viewport.interactor.repaint()
    assert is_whole(user)
    ground = on_screen(user)[-1, 0]
    user.window.actions_["theme_dark"].trigger()
    user.wait(lambda: user.denoise.viewport.grid.look.theme.dark)
    assert is_whole(user)
    assert on_screen(user)[-1, 0] < ground
    user.window.actions_["theme_light"].trigger()
