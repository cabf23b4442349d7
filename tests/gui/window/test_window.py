"""The Denoise tab from opening a model to taking pictures away."""

import csv

import numpy as np
import pytest
from matplotlib.image import imread
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QMessageBox

from app.scene.camera import CameraPose
from app.ui.screenshot_dialog import ScreenshotDialog
from core.io import load_mesh, save_mesh
from core.mesh import primitives
from core.noise import add_noise

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton


def shown_message(user):
    boxes = lambda: [b for b in user.window.findChildren(QMessageBox) if b.isVisible()]  # noqa: E731
    user.wait(boxes)
    text = boxes()[0].text()
    boxes()[0].close()
    return text


def test_the_whole_way_from_the_cow_to_a_picture(user, shared_models, tmp_path, qtbot):
    user.open(shared_models / "cow_92864.ply")
    assert user.captions()["original"] == "92,864 faces"
    assert user.captions()["noisy"].endswith("D = 0.00216")

    # Six iterations were computed on opening; the slider of one method goes on to eighteen.
    user.type_iterations("diffusion", 18)
    user.rest()
    assert user.captions()["diffusion"] == "k = 18   D = 0.00207"

    # A method less leaves the other panes more room.
    before = user.denoise.viewport.grid.viewports["mean"]
    check = user.denoise.methods.blocks["bilateral"].check
    qtbot.mouseClick(check, LEFT, pos=QPoint(8, check.height() // 2))
    user.rest()
    assert "bilateral" not in user.captions()
    after = user.denoise.viewport.grid.viewports["mean"]
    assert after.right - after.left > before.right - before.left

    # A click selects; the selected pane is what E enlarges and brings back.
    user.click_pane("diffusion")
    assert user.denoise.table.model is not None
    user.press(Qt.Key.Key_E)
    assert list(user.denoise.viewport.grid.viewports) == ["diffusion"]
    user.press(Qt.Key.Key_E)
    assert len(user.denoise.viewport.grid.viewports) == 6

    user.press(Qt.Key.Key_P, CONTROL)
    dialog = user.window.findChild(ScreenshotDialog)
    dialog.scale.setValue(1)
    qtbot.mouseClick(dialog.transparent, LEFT, pos=QPoint(8, dialog.transparent.height() // 2))
    qtbot.keyClick(dialog, Qt.Key.Key_Return)
    picture = tmp_path / "panes.png"
    user.answer_file_dialog(picture)
    user.wait(picture.exists)
    pixels = imread(picture)
    width, height = user.denoise.viewport.pixel_size()
    assert pixels.shape == (height, width, 4)
    assert 0.05 < (pixels[..., 3] > 0.5).mean() < 0.6


def test_printed_diffusion_diverges_in_pane_plot_table_and_panel(user, shared_models):
    user.open(shared_models / "cow_92864.ply")
    form = user.denoise.methods.blocks["diffusion"].form
    form.changed.emit({"form": "printed", "raw_units": True})
    user.rest()
    caption = user.captions()["diffusion"]
    assert caption.startswith("diverged at iteration ")
    iteration = int(caption.split()[3])
    block = user.denoise.methods.blocks["diffusion"]
    user.wait(lambda: f"diverged at iteration {iteration}" in block.state.text())
    user.wait(lambda: f"diverged at iteration {iteration}" in table_text(user))
    user.wait(lambda: any("diverged" in text for text in plot_texts(user)))
    assert user.captions()["median"].startswith("k = 6 ")


def plot_texts(user):
    artists = user.denoise.plot.figure.findobj()
    return {artist.get_text() for artist in artists if hasattr(artist, "get_text")}


def table_text(user):
    from PySide6.QtWidgets import QApplication

    user.press(Qt.Key.Key_C, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    return QApplication.clipboard().text()


def test_a_model_can_be_dropped_on_the_window(user, ball_file, qtbot):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(ball_file))])
    event = QDropEvent(
        QPointF(100, 100), Qt.DropAction.CopyAction, data, LEFT, Qt.KeyboardModifier.NoModifier
    )
    user.window.dropEvent(event)
    user.wait(lambda: user.window.windowTitle() == "ball.ply – Burnish")


def test_a_bad_file_is_one_sentence_and_the_model_stays(user, ball_file, tmp_path):
    user.open(ball_file)
    bad = tmp_path / "bad.ply"
    bad.write_text("ply\nthis is no mesh")
    user.press(Qt.Key.Key_O, CONTROL)
    user.answer_file_dialog(bad)
    message = shown_message(user)
    assert "bad.ply" in message
    assert "Traceback" not in message
    assert user.window.windowTitle() == "ball.ply – Burnish"
    assert user.captions()["original"] == "1,280 faces"


def test_a_separate_noisy_file_replaces_the_noise(user, ball_file, tmp_path, qtbot):
    user.open(ball_file)
    noisy = tmp_path / "noisy.obj"
    save_mesh(add_noise(primitives.sphere(3), 0.3), noisy)
    user.press(Qt.Key.Key_O, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    user.answer_file_dialog(noisy)
    user.wait(lambda: "from file" in user.captions().get("noisy", ""))
    user.rest()
    user.press(Qt.Key.Key_Z, CONTROL)
    user.wait(lambda: user.captions()["noisy"].startswith("σ = 0.02"))


def test_a_noisy_file_of_another_model_is_refused(user, ball_file, tmp_path):
    user.open(ball_file)
    other = tmp_path / "other.ply"
    save_mesh(primitives.torus(), other)
    user.press(Qt.Key.Key_O, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    user.answer_file_dialog(other)
    assert "288 vertices and the original 642" in shown_message(user)
    assert user.window.session.study.noisy is None


def test_undo_and_redo_name_their_step(user, ball_file):
    user.open(ball_file)
    user.type_iterations("mean", 9)
    user.rest()
    undo, redo = user.window.actions_["undo"], user.window.actions_["redo"]
    assert undo.isEnabled()
    assert not redo.isEnabled()
    name = undo.text().removeprefix("&Undo ")
    user.press(Qt.Key.Key_Z, CONTROL)
    assert user.captions()["mean"].startswith("k = 6 ")
    assert redo.text() == f"&Redo {name}"
    user.press(Qt.Key.Key_Z, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    assert user.captions()["mean"].startswith("k = 9 ")


def test_cancel_stops_a_long_run_and_moves_the_slider_back(user, ball_file):
    user.open(ball_file)
    user.type_iterations("median", 1000)
    user.wait(lambda: user.window.session.run("median").computed >= 10)
    user.press(Qt.Key.Key_Escape)
    user.rest()
    box = user.denoise.methods.blocks["median"].iterations.box
    assert 10 <= box.value() < 1000
    user.wait(lambda: not user.window.actions_["cancel"].isEnabled())


def test_unlinked_cameras_do_not_jump_and_move_alone(user, ball_file):
    user.open(ball_file)
    grid = user.denoise.viewport.grid
    before = grid.poses()
    user.press(Qt.Key.Key_L)
    user.rest()
    assert grid.poses() == before
    camera = grid.renderer("mean").GetActiveCamera()
    camera.Azimuth(30)
    assert CameraPose.of(grid.renderer("median").GetActiveCamera()) == before[0]
    user.click_pane("mean")
    user.press(Qt.Key.Key_L)
    user.wait(lambda: grid.linked)
    assert CameraPose.of(grid.renderer("median").GetActiveCamera()) == CameraPose.of(camera)


def drag(qtbot, area, start, end):
    qtbot.mousePress(area, LEFT, pos=start)
    qtbot.mouseMove(area, (start + end) / 2)
    qtbot.mouseMove(area, end)
    qtbot.mouseRelease(area, LEFT, pos=end)


def test_box_zoom_comes_closer_in_all_panes(user, ball_file, qtbot):
    user.open(ball_file)
    grid, area = user.denoise.viewport.grid, user.denoise.viewport.interactor
    before = grid.renderer("mean").GetActiveCamera().GetDistance()
    middle = user.middle_of("noisy")
    user.press(Qt.Key.Key_B)
    drag(qtbot, area, middle - QPoint(20, 20), middle + QPoint(20, 20))
    distances = {grid.renderer(p).GetActiveCamera().GetDistance() for p in grid.ids}
    assert len(distances) == 1
    assert distances.pop() < before / 2
    assert not user.window.actions_["box_zoom"].isChecked()
    user.press(Qt.Key.Key_R)
    assert grid.renderer("mean").GetActiveCamera().GetDistance() == pytest.approx(before)


def test_fly_goes_to_the_point_under_the_cursor(user, ball_file, qtbot):
    user.open(ball_file)
    grid, area = user.denoise.viewport.grid, user.denoise.viewport.interactor
    target = area.mapToGlobal(user.middle_of("median") + QPoint(15, -10))
    area.cursor().setPos(target)
    camera = grid.renderer("median").GetActiveCamera()
    before = camera.GetDistance()
    user.press(Qt.Key.Key_F)
    user.wait(lambda: camera.GetDistance() < before / 1.5)
    focal = np.array(grid.renderer("mean").GetActiveCamera().GetFocalPoint())
    assert np.linalg.norm(focal) > 0.05  # no longer the centre of the ball


def test_colouring_shows_one_bar_for_all_panes(user, ball_file):
    user.open(ball_file)
    user.window.actions_["colour_normal_angle"].trigger()
    user.rest()
    panes, look = user.denoise.panes()
    assert look.colour_title.startswith("Normal angle")
    assert panes[0].values is None
    assert all(pane.values is not None for pane in panes[1:])
    right_edges = [port.right for port in user.denoise.viewport.grid.viewports.values()]
    assert max(right_edges) < 0.95


def test_saved_mesh_plot_and_table_hold_what_was_shown(user, ball_file, tmp_path):
    user.open(ball_file)
    user.click_pane("mean")
    user.press(Qt.Key.Key_M, CONTROL)
    user.answer_file_dialog(tmp_path / "mean.ply")
    run = user.window.session.run("mean")
    user.wait((tmp_path / "mean.ply").exists)
    assert load_mesh(tmp_path / "mean.ply").vertices == pytest.approx(run.vertices(6))

    user.window.actions_["save_plot"].trigger()
    user.answer_file_dialog(tmp_path / "plot.svg")
    user.wait((tmp_path / "plot.svg").exists)
    assert "Mean filter" in (tmp_path / "plot.svg").read_text()

    user.window.actions_["save_table"].trigger()
    user.answer_file_dialog(tmp_path / "table.csv")
    user.wait((tmp_path / "table.csv").exists)
    rows = list(csv.reader((tmp_path / "table.csv").read_text().splitlines()))
    assert rows[1][0] == "noisy_input"
    assert float(rows[3][2]) == pytest.approx(run.errors[6]["visual_error"], rel=1e-3)


def test_a_file_that_cannot_be_written_is_one_sentence(user, ball_file, tmp_path):
    user.open(ball_file)
    user.click_pane("mean")
    folder = tmp_path / "gone"
    folder.mkdir()
    user.press(Qt.Key.Key_M, CONTROL)
    user.wait(user.file_dialogs)
    dialog = user.file_dialogs()[0]
    folder.rmdir()
    dialog.fileSelected.emit(str(folder / "x.ply"))
    assert "x.ply" in shown_message(user)


def test_dark_and_light_change_panes_and_plot(user, ball_file):
    user.open(ball_file)
    user.window.theme.choose("dark")
    user.rest()
    dark = user.denoise.panes()[1].theme
    user.window.theme.choose("light")
    user.rest()
    light = user.denoise.panes()[1].theme
    assert dark.dark
    assert not light.dark


def test_the_window_picture_has_the_panes_drawn_at_full_size(user, ball_file):
    from app.ui import saving

    user.open(ball_file)
    picture = saving.WindowPicture(user.window, 2)
    image = picture.image(picture.pieces)
    assert image.width() == 2 * user.window.width()
    viewport = user.denoise.viewport
    place = viewport.mapTo(user.window, user.middle_of("original")) * 2
    ground = viewport.mapTo(user.window, QPoint(8, viewport.height() // 2 - 8)) * 2
    assert image.pixelColor(place) != image.pixelColor(ground)


def test_nothing_runs_and_nothing_is_left_after_closing(user, ball_file):
    import threading

    user.open(ball_file)
    user.type_iterations("median", 1000)
    user.window.files.discard_changes()
    user.window.close()
    assert not [t for t in threading.enumerate() if t.name == "burnish-jobs" and t.is_alive()]
