"""The preview of a figure: composed beside the window, which stays awake."""

import threading

import numpy as np
import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from app.export.pictures import PictureError
from app.ui import montage_preview
from app.ui.montage_dialog import MontageDialog

_RGB = QImage.Format.Format_RGB888


class Composer:
    """Composes figures as ever, but one that is held up only when its gate is opened."""

    def __init__(self, monkeypatch, gate):
        self.begun, self.threads, self.holds = [], set(), False
        self._gate, self._compose = gate, montage_preview.montage_figure
        monkeypatch.setattr(montage_preview, "montage_figure", self)

    def __call__(self, montage, source, pictures):
        pictures = list(pictures)
        self.threads.add(threading.current_thread())
        self.begun.append(montage)
        if self.holds:
            assert threading.current_thread() is not threading.main_thread()
            assert self._gate.wait(60)
        return self._compose(montage, source, pictures)


@pytest.fixture
def composer(monkeypatch, gate):
    return Composer(monkeypatch, gate)


@pytest.fixture
def dialog(user, ball_file, composer):
    user.open(ball_file)
    dialog = MontageDialog.open_for(user.window)
    user.wait(lambda: dialog.preview.image is not None)
    user.qtbot.wait(300)  # whatever the first layout asks for
    user.wait(lambda: not dialog.preview._jobs.tasks.states())
    yield dialog
    composer.holds = False
    for left in user.window.findChildren(MontageDialog):
        left.close()


def hold_up(user, dialog, composer):
    """Change an option and wait until its figure is being composed."""
    composer.holds, before = True, len(composer.begun)
    dialog.letters.click()
    user.wait(lambda: len(composer.begun) > before)


def size_of(dialog):
    return dialog.size_label.text()


def test_until_there_is_a_figure_the_preview_says_that_it_is_drawn(user, ball_file, composer, gate):
    user.open(ball_file)
    composer.holds = True
    dialog = MontageDialog.open_for(user.window)
    user.wait(lambda: composer.begun)
    written = len(np.unique(_pixels(dialog), axis=0))
    composer.holds = False
    gate.set()
    user.wait(lambda: dialog.preview.image is not None)
    dialog.close()
    assert written > 1  # letters on the ground


def test_while_a_figure_is_composed_the_window_takes_clicks_and_paints(user, dialog, composer):
    hold_up(user, dialog, composer)
    old, ticks, columns = dialog.preview.image, [], dialog.columns.value()
    timer = QTimer(interval=0)
    timer.timeout.connect(lambda: ticks.append(1))
    timer.start()
    user.wait(lambda: len(ticks) > 20)
    QTest.keyClick(dialog.columns, Qt.Key.Key_Down)
    assert dialog.columns.value() == columns - 1
    assert len(np.unique(_pixels(dialog), axis=0)) > 50  # it paints the figure
    assert dialog.preview.image is old  # until the next is there
    assert threading.main_thread() not in composer.threads


def test_only_the_figure_of_the_last_options_is_shown(user, dialog, composer, gate):
    hold_up(user, dialog, composer)
    told = []
    dialog.preview.told.connect(lambda text, _: told.append(text))
    for width in (10, 12, 14):
        dialog.width_box.setValue(width)
        user.qtbot.wait(200)
    assert len({montage.width for montage in composer.begun}) == 1
    composer.holds = False
    gate.set()
    user.wait(lambda: told)
    assert size_of(dialog).startswith("14.0 ×")
    assert [montage.width for montage in composer.begun][-1] == 14
    assert not {10.0, 12.0} & {montage.width for montage in composer.begun}
    assert len(told) == 1


def test_a_dialog_that_is_closed_waits_for_nothing_and_hears_nothing(
    user, dialog, composer, gate, monkeypatch
):
    hold_up(user, dialog, composer)
    shown, jobs = [], dialog.preview._jobs
    monkeypatch.setattr(montage_preview, "_image", lambda *_: shown.append(1))
    dialog.reject()
    assert not dialog.isVisible()
    assert jobs._unfinished
    gate.set()
    user.wait(lambda: not jobs._unfinished)
    assert not shown


def test_the_window_closes_while_a_figure_is_composed(user, dialog, composer, gate):
    hold_up(user, dialog, composer)
    thread = dialog.preview._jobs._thread
    user.window.files.discard_changes()
    user.window.close()
    assert not user.window.isVisible()
    assert thread.is_alive()
    gate.set()
    thread.join(60)
    assert not thread.is_alive()


def test_pictures_are_drawn_by_the_window_and_kept(user, dialog, composer, monkeypatch):
    drawn, pictures = [], type(dialog.source).pictures

    def watched(*arguments, **options):
        for picture in pictures(*arguments, **options):
            drawn.append(threading.current_thread())
            yield picture

    monkeypatch.setattr(type(dialog.source), "pictures", watched)
    old = dialog.preview.image
    dialog.ground.setCurrentIndex(dialog.ground.findData("transparent"))
    user.wait(lambda: dialog.preview.image is not old)
    assert drawn == [threading.main_thread()] * len(dialog.montage().cells)
    old = dialog.preview.image
    dialog.letters.click()
    user.wait(lambda: dialog.preview.image is not old)
    assert len(drawn) == len(dialog.montage().cells)


def test_what_cannot_be_composed_is_told_and_mended_by_another_option(
    user, dialog, composer, monkeypatch
):
    def fail(*_):
        raise PictureError("The figure is too small for its plots.")

    composed = montage_preview.montage_figure
    monkeypatch.setattr(montage_preview, "montage_figure", fail)
    dialog.letters.click()
    user.wait(lambda: size_of(dialog) == "The figure is too small for its plots.")
    assert not dialog.save_button.isEnabled()
    assert dialog.preview.image is None
    monkeypatch.setattr(montage_preview, "montage_figure", composed)
    dialog.letters.click()
    user.wait(dialog.save_button.isEnabled)
    assert size_of(dialog).startswith("16.0 ×")


def test_a_fault_is_reported_and_the_last_figure_stays(user, dialog, monkeypatch):
    faults, old = [], dialog.preview.image
    user.window.session.broken.disconnect()
    user.window.session.broken.connect(faults.append)
    monkeypatch.setattr(montage_preview, "montage_figure", lambda *_: 1 / 0)
    dialog.letters.click()
    user.wait(lambda: faults)
    assert isinstance(faults[0], ZeroDivisionError)
    assert dialog.preview.image is old


def test_the_checks_behind_a_clear_figure_come_with_it(user, dialog, composer, gate):
    composer.holds = True
    dialog.ground.setCurrentIndex(dialog.ground.findData("transparent"))
    user.wait(lambda: any(montage.ground == "transparent" for montage in composer.begun))
    before = np.unique(_pixels(dialog), axis=0)
    composer.holds = False
    gate.set()
    user.wait(lambda: dialog.preview._ground == "transparent")
    after = np.unique(_pixels(dialog), axis=0)
    check = [0xD8, 0xDD, 0xE3]
    assert check not in before.tolist()
    assert check in after.tolist()


def _pixels(dialog):
    image = dialog.preview.grab().toImage().convertToFormat(_RGB)
    rows = np.array(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : 3 * image.width()].reshape(-1, 3)
