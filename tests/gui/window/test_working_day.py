"""A whole working day in the window, by mouse and keys; its numbers are those of ``compare``."""

import csv
import json

import pytest
from matplotlib.image import imread
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLabel, QMessageBox

from app.cli import main
from app.ui.montage_dialog import MontageDialog
from core.io import save_mesh
from core.mesh import primitives

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
LEFT = Qt.MouseButton.LeftButton
STEPS = 10


@pytest.fixture
def day(user, hands, qtbot, tmp_path):
    return Day(user, hands, qtbot, tmp_path)


class Day:
    """The parts of the day, in the order in which they are done."""

    def __init__(self, user, hands, qtbot, folder):
        self.user, self.hands, self.qtbot, self.folder = user, hands, qtbot, folder
        self.session = user.window.session
        self.model, self.study = folder / "torus.ply", folder / "day.burnish"
        save_mesh(primitives.torus(40, 24), self.model)

    def add_noise(self):
        noise = self.user.denoise.model.noise
        self.hands.type_into(noise.seed, "7")
        self.settle(lambda: self.session.study.noise.seed == 7)
        self.hands.type_into(noise.sigma, "0.2")
        self.settle(lambda: self.session.study.noise.sigma == 0.2)

    def compare(self):
        for method, count in (
            ("mean", 9),
            ("median", 4),
            ("weighted_laplacian", 2),
            ("diffusion", 12),
        ):
            self.user.type_iterations(method, count)
        self.click_check(self.block("bilateral").check)
        self.click_check(self.block("laplacian").check)
        self.settle(lambda: self.session.study.choice("laplacian").enabled)

    def change_parameters(self):
        self.set_parameter("diffusion", "gradient_scale", "12")
        self.set_parameter("laplacian", "step", "0.5")
        self.settle(lambda: self.session.study.choice("laplacian").params == {"step": 0.5})

    def undo_and_redo(self):
        """Go ten steps back and the same ten forward; nothing is lost."""
        studies = [self.session.study]
        for _ in range(STEPS):
            self.user.press(Qt.Key.Key_Z, CONTROL)
            self.settle(lambda: self.session.study != studies[-1])
            studies.append(self.session.study)
        assert len({study.model_dump_json() for study in studies}) == STEPS + 1
        for study in reversed(studies[:-1]):
            self.user.press(Qt.Key.Key_Z, CONTROL | SHIFT)
            self.settle(lambda study=study: self.session.study == study)

    def save(self):
        self.user.press(Qt.Key.Key_S, CONTROL | SHIFT)
        self.user.answer_file_dialog(self.study)
        self.user.wait(lambda: self.title().startswith(f"{self.study.name} "))

    def reopen(self):
        """Open another model, then the study of before; the saved one is not asked about."""
        other = self.folder / "ball.ply"
        save_mesh(primitives.sphere(2), other)
        self.user.open(other)
        self.user.press(Qt.Key.Key_O, CONTROL)
        self.user.answer_file_dialog(self.study)
        self.user.wait(lambda: self.title().startswith(f"{self.study.name} "))
        self.user.rest()

    def export_figure(self):
        file = self.folder / "figure.png"
        self.user.press(Qt.Key.Key_F, CONTROL | SHIFT)
        dialog = self.user.window.findChild(MontageDialog)
        self.user.wait(lambda: dialog.preview.image is not None)
        self.qtbot.mouseClick(dialog.save_button, LEFT)
        self.user.answer_file_dialog(file)
        self.user.wait(file.exists)
        self.come_back()
        return imread(file)

    def export_table(self):
        file = self.folder / "table.csv"
        self.user.press(Qt.Key.Key_E, CONTROL | SHIFT)
        self.user.answer_file_dialog(file)
        self.user.wait(file.exists)
        return list(csv.reader(file.read_text(encoding="utf-8").splitlines()))

    def look_at_the_skeleton(self):
        tab = self.open_tab(1)
        self.user.wait(lambda: tab.views.is_settled and tab.views.skeleton(1))
        slider = tab.centre.resolutions[1].slider
        slider.setFocus()
        for _ in range(4):
            self.qtbot.keyClick(slider, Qt.Key.Key_Left)
        self.user.wait(lambda: tab.views.skeleton(1).graph.resolution == 18)
        return tab.views.skeleton(1).graph

    def look_at_the_statistics(self):
        tab = self.open_tab(2)
        self.user.wait(lambda: "1,920" in [label.text() for label in tab.side.findChildren(QLabel)])

    def compare_without_a_window(self, capsys):
        capsys.readouterr()
        with pytest.raises(SystemExit) as stop:
            main(["compare", "--study", str(self.study), "--json"])
        assert stop.value.code == 0
        return json.loads(capsys.readouterr().out)

    def set_parameter(self, method, name, text):
        block = self.block(method)
        if not block.form.isVisible():
            self.qtbot.mouseClick(block.gear, LEFT)
        self.hands.type_into(block.form.fields[name].editor, text)

    def block(self, method):
        return self.user.denoise.methods.blocks[method]

    def click_check(self, check):
        self.qtbot.mouseClick(check, LEFT, pos=QPoint(9, check.height() // 2))

    def open_tab(self, index):
        bar = self.user.window.tabs.tabBar()
        self.qtbot.mouseClick(bar, LEFT, pos=bar.tabRect(index).center())
        return self.user.window.tabs.currentWidget()

    def come_back(self):
        """Have the keys act on the window again, after a dialog."""
        self.user.window.activateWindow()
        self.user.wait(self.user.window.isActiveWindow)

    def settle(self, done):
        self.user.wait(done)
        self.user.rest()

    def title(self):
        return self.user.window.windowTitle()

    def questions(self):
        return [box for box in self.user.window.findChildren(QMessageBox) if box.isVisible()]


def test_a_working_day_ends_with_the_numbers_of_the_command_line(day, capsys):
    day.user.open(day.model)
    day.add_noise()
    day.compare()
    day.change_parameters()
    day.undo_and_redo()
    day.save()
    day.reopen()
    assert not day.questions()
    shown = {
        choice.method: day.session.run(choice.method).errors[choice.iterations]
        for choice in day.session.study.methods
        if choice.enabled
    }
    assert set(shown) == {"weighted_laplacian", "mean", "median", "diffusion", "laplacian"}

    figure = day.export_figure()
    assert figure.shape[0] > 100
    assert figure.std() > 0.05
    table = day.export_table()
    assert {row[0] for row in table} >= {"noisy_input", *shown}

    assert day.look_at_the_skeleton().loops == 1
    day.look_at_the_statistics()

    day.open_tab(0)
    day.user.press(Qt.Key.Key_S, CONTROL)
    day.user.wait(lambda: "*" not in day.title())
    for method in day.compare_without_a_window(capsys)["methods"]:
        errors = shown[method["id"]]
        assert method["visual_error"][-1] == errors["visual_error"]
        assert method["normal_angle"][-1] == errors["normal_angle"]
