"""Pictures and films of the Skeleton tab."""

import pytest
from PySide6.QtWidgets import QDialog

from app.export.pictures import composed
from app.scene.colours import DARK
from app.ui.screenshot_dialog import Request, ScreenshotDialog
from app.ui.skeleton_export import film
from app.ui.skeleton_film_dialog import FilmDialog, FilmRequest

pytestmark = pytest.mark.gui

LONG = 60_000


def test_a_dark_theme_changes_the_ground(tab, settle):
    size = tab.viewport.pixel_size()
    light = composed(tab.desk.picture(Request("grid", 1, transparent=False), size))
    tab.set_theme(DARK)
    settle()
    dark = composed(tab.desk.picture(Request("grid", 1, transparent=False), size))
    assert dark[-4, 4].mean() < light[-4, 4].mean() - 80


def test_pictures_have_the_size_that_the_dialog_says(tab):
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


def test_a_film_is_among_what_runs_and_can_be_cancelled(qtbot, tab, tmp_path):
    path, tasks = tmp_path / "film.gif", tab.session.tasks
    film(tab, FilmRequest("turn", ".gif", 50, 5.0), path)
    qtbot.waitUntil(lambda: tasks.states()[-1].share, timeout=LONG)
    assert tasks.states()[-1].title == "Writing film.gif"
    tasks.cancel_all()
    qtbot.waitUntil(lambda: not tasks.states(), timeout=LONG)
    assert not list(tmp_path.glob("*film*"))
