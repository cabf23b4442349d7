"""The same work over and over: ``python soak.py --minutes 10``.

Prints one JSON object: what the process held after every round, and what went wrong.
"""

import argparse
import json
import os
import time

import hands
import world
from house import House, inhabit
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.ui.montage_dialog import MontageDialog

_ITERATIONS = {"mean": 5, "median": 4, "weighted_laplacian": 3, "diffusion": 6}
_STEPS = 4


class Worker:
    """Someone who does a whole piece of work with every feature, and then the same again."""

    def __init__(self, folder, log):
        self.house, self._log = House(), log
        models, _ = world.make_models(folder)
        self._ball, self._torus = models[:2]
        self._folder = folder

    def work(self, minutes, rounds):
        """Work for a number of minutes, but for so many rounds at least."""
        self.house.open_window()
        end, done = time.monotonic() + 60 * minutes, 0
        while not self.house.faults.found and (done < rounds or time.monotonic() < end):
            self._one_round(done)
            done += 1
            self.house.come_home(self._ball)
            self.house.measure()
            print(json.dumps(self.house.measured[-1]), file=self._log, flush=True)
        self.house.close_window()

    def _one_round(self, number):
        self._open(self._torus)
        self._compare(number)
        self._undo_and_redo()
        self._look_at_the_skeleton()
        self._look_at_the_statistics()
        self._export()
        self._save_and_reopen()

    def _compare(self, number):
        noise = self._denoise.model.noise
        _type(noise.seed, str(number % 7 + 1))
        _type(noise.sigma, "0.2")
        for method, count in _ITERATIONS.items():
            _type(self._denoise.methods.blocks[method].iterations.box, str(count))
        form = self._denoise.methods.blocks["laplacian"].form
        self._denoise.methods.blocks["laplacian"].check.setChecked(True)
        _type(form.fields["step"].editor, "0.5")
        self._rest()

    def _undo_and_redo(self):
        for command in ("undo", "redo"):
            for _ in range(_STEPS):
                self._do(command)
                self._rest()

    def _look_at_the_skeleton(self):
        tab = self._turn_to(1)
        self.house.wait(lambda: tab.views.is_settled and tab.views.skeleton(1), "the graph")
        slider = tab.centre.resolutions[1].slider
        for key in [Qt.Key.Key_Left] * _STEPS + [Qt.Key.Key_Right] * _STEPS:
            QTest.keyClick(slider, key)
            hands.rest(5)
        self.house.wait(lambda: tab.views.is_settled, "the graph")

    def _look_at_the_statistics(self):
        tab = self._turn_to(2)
        self.house.wait(lambda: tab.work.series() and tab.work.activity is None, "the statistics")
        self._rest()
        self._turn_to(0)

    def _export(self):
        dialog = MontageDialog.open_for(self.house.window)
        self.house.wait(lambda: dialog.preview.image is not None, "the preview")
        dialog.dpi.setValue(100)
        dialog.save(self._folder / "figure.png")
        for command, name in (("save_table", "table.csv"), ("save_plot", "plot.svg")):
            self._write(command, name)

    def _save_and_reopen(self):
        study = self._write("save_study_as", "work.burnish")
        self._rest()
        self._open(self._ball)
        self._open(study)

    def _write(self, command, name):
        file = self._folder / name
        file.unlink(missing_ok=True)
        self._do(command)
        self.house.answer_file_dialog(file)
        self.house.wait(file.exists, name)
        return file

    def _open(self, file):
        window = self.house.window
        window.open_model(str(file))
        self.house.wait(lambda: window.windowTitle().startswith(file.name), file.name)
        self._rest()

    def _rest(self):
        self.house.wait(self.house.rests, "rest")

    def _do(self, command):
        self.house.window.actions_[command].trigger()

    def _turn_to(self, tab):
        self.house.window.tabs.setCurrentIndex(tab)
        return self.house.window.tabs.currentWidget()

    @property
    def _denoise(self):
        return self.house.window.denoise


def _type(box, text):
    box.selectAll()
    QTest.keyClicks(box, text)
    QTest.keyClick(box, Qt.Key.Key_Return)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=0)
    parser.add_argument("--rounds", type=int, default=3, help="the least number of rounds")
    parser.add_argument("--log", default=os.devnull, help="gets a line for each round")
    words = parser.parse_args()
    log = open(words.log, "w", encoding="utf-8")  # noqa: SIM115 - until the process ends

    def live(folder):
        worker = Worker(folder, log)
        worker.work(words.minutes, words.rounds)
        found = worker.house.faults.found
        print(json.dumps({"measured": worker.house.measured, "faults": found}))  # noqa: T201
        return bool(found)

    inhabit(live)


if __name__ == "__main__":
    main()
