"""The dialog of a figure: its preview is what comes out."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.image import imread
from PySide6.QtCore import Qt

from app.export.montage import montage_figure
from app.export.montage_files import montage_pixels
from app.ui.montage_dialog import MontageDialog

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def dialog(user, ball_file):
    user.open(ball_file)
    user.press(Qt.Key.Key_F, CONTROL | SHIFT)
    dialog = user.window.findChild(MontageDialog)
    user.wait(lambda: dialog.preview.image is not None)
    yield dialog
    for left in user.window.findChildren(MontageDialog):
        left.close()


def pixels(image):
    array = np.array(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4)
    return array.astype(int)


def test_the_panes_their_order_and_captions_are_chosen(user, dialog):
    cells = dialog.cells
    assert [cell.pane for cell in dialog.montage().cells][:3] == [
        "original", "noisy", "weighted_laplacian",
    ]  # fmt: skip
    cells.item(0).setCheckState(Qt.CheckState.Unchecked)
    cells.insertItem(0, cells.takeItem(3))
    cells.item(0).setText("mean filter, 6 iterations")
    montage = dialog.montage()
    assert montage.cells[0].pane == "mean"
    assert montage.caption(0) == "(a) mean filter, 6 iterations"
    assert "original" not in [cell.pane for cell in montage.cells]


def test_the_preview_is_the_figure(user, dialog):
    shown = pixels(dialog.preview.image)
    dpi = shown.shape[1] / (dialog.width_box.value() / 2.54)
    figure = montage_figure(replace(dialog.montage(), dpi=dpi), dialog.source)
    drawn = montage_pixels(figure).astype(int)
    height, width = (min(a, b) for a, b in zip(shown.shape[:2], drawn.shape[:2], strict=True))
    assert abs(shown.shape[0] - drawn.shape[0]) <= 1
    assert np.abs(shown[:height, :width] - drawn[:height, :width]).mean() < 2


def test_the_file_has_the_size_that_is_told(user, dialog, tmp_path):
    dialog.width_box.setValue(8)
    dialog.height_box.setValue(6)
    dialog.dpi.setValue(100)
    user.wait(lambda: dialog.size_label.text().startswith("8.0 × 6.0 cm, 315 × 236"))
    dialog.save_button.click()
    user.answer_file_dialog(tmp_path / "figure.png")
    user.wait((tmp_path / "figure.png").exists)
    assert imread(tmp_path / "figure.png").shape[:2] == (236, 315)


def test_without_panes_nothing_is_saved_and_it_says_why(user, dialog):
    for row in range(dialog.cells.count()):
        dialog.cells.item(row).setCheckState(Qt.CheckState.Unchecked)
    user.wait(lambda: "no panes" in dialog.size_label.text())
    assert not dialog.save_button.isEnabled()


def test_the_settings_are_kept_for_the_next_figure(user, dialog):
    dialog.columns.setValue(2)
    dialog.letters.click()
    dialog.ground.setCurrentIndex(1)
    dialog.reject()
    again = MontageDialog(user.window)
    assert again.montage().columns == 2
    assert not again.montage().letters
    assert again.montage().bar
    assert again.montage().ground == "transparent"
    again.close()
