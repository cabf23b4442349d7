"""A random user of the real window: ``python play.py --seed 3 --actions 100``.

Prints one JSON object: what was measured at rest and, where something broke, what was done last.
The same seed does the same again, as far as threads allow.
"""

import argparse
import faulthandler
import gc
import json
import os
import random
import shutil
import sys
import tempfile
import threading
import time
from collections import deque
from pathlib import Path

import world

_PIECE = 100
_LAST = 30
_HANG = 60
_SETTLE = 60
_BUDGET = 64_000_000


class Player:
    """Plays with a window; when that closes, with the next one."""

    def __init__(self, folder, seed, log):
        from hands import Rescuer
        from habits import Habits
        from watch import Faults

        self.random = random.Random(seed)
        self.faults, self._seed, self._log = Faults(), seed, log
        self._rescuer = Rescuer(self.random)
        self.home, *_ = good, bad = world.make_models(folder)
        self.habits = Habits(self.random, good, bad)
        self.window, self.windows = None, 0
        self.last, self.measured, self.slowest = deque(maxlen=_LAST), [], (0, "")
        self.faults.install()

    def play(self, actions):
        """Do a number of things and come to rest after every piece."""
        self.open_window()
        self.come_home()
        for number in range(1, actions + 1):
            self._do(number)
            if self.faults.found:
                return
            if number % _PIECE == 0 or number == actions:
                self.come_home()
        self.close_window()

    def open_window(self):
        from app.ui.main_window import MainWindow

        self.window = self.habits.window = MainWindow()
        self.windows += 1
        self.faults.watch(self.window)
        self.window.resize(1280, 800)
        self.window.show()
        self.window.activateWindow()
        self._wait(self.window.isActiveWindow)

    def close_window(self):
        """Close the window, unless that has been done, and see that nothing of it is left."""
        from PySide6.QtCore import QCoreApplication, QEvent

        window, self.window, self.habits.window = self.window, None, None
        window.files.discard_changes()
        window.close()
        window.deleteLater()
        self._wait(lambda: not window.isVisible())
        del window
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        gc.collect()
        self._wait(lambda: not burnish_threads(), "threads of Burnish to end")

    def come_home(self):
        """Close all dialogs, open the same small study and measure when everything rests."""
        from app.session.documents import Document
        from core.study import Study

        self._close_dialogs()
        session = self.window.session
        session.cancel()
        study = Study(model=str(self.home[0]))
        self.window.files.documents.open(study, Document(saved=study), "Home")
        self.window.showNormal()
        self.window.resize(1280, 800)
        self.window.tabs.setCurrentIndex(0)
        session.set_budget(_BUDGET)
        self._wait(lambda: session.study.model == study.model and self._rests())
        self._close_dialogs()
        self._measure()

    def _rests(self):
        session = self.window.session
        return session.meshes and session.activity is None and not session.tasks.states()

    def _measure(self):
        from watch import measure

        self.measured.append({"windows": self.windows, **measure(self.window)})

    def _close_dialogs(self):
        from PySide6.QtWidgets import QApplication

        import hands

        for _ in range(20):
            known = {w for w in QApplication.topLevelWidgets() if w.isVisible()} - {self.window}
            top = hands.scope() or next(iter(known), None)
            if top is None or top is self.window:
                return
            top.close()
            self._wait_a_little()

    def _do(self, number):
        from PySide6.QtWidgets import QApplication

        faulthandler.dump_traceback_later(_HANG, exit=True)
        started = time.monotonic()
        # Each action by itself: one that went otherwise does not change all that follow.
        self.random.seed(f"{self._seed}:{number}")
        self._rescuer.begin()
        said = self.habits.act()
        self._rescuer.end()
        self._wait_a_little()
        if QApplication.activeWindow() is None:  # a window manager would choose one
            self.window.activateWindow()
        seconds = time.monotonic() - started
        self._note(f"{number}: {said} ({seconds:.2f} s)")
        self.slowest = max(self.slowest, (round(seconds, 2), said))
        if not self.window.isVisible():
            self.close_window()
            self.open_window()

    def _note(self, line):
        self.last.append(line)
        self._log.write(f"{line}\n")
        self._log.flush()

    def _wait_a_little(self):
        from PySide6.QtTest import QTest

        QTest.qWait(1)

    def _wait(self, condition, what="rest"):
        from PySide6.QtTest import QTest

        faulthandler.dump_traceback_later(_SETTLE + _HANG, exit=True)
        end = time.monotonic() + _SETTLE
        while not condition():
            if time.monotonic() > end:
                self.faults.found.append(f"Waited in vain for {what}.")
                return
            QTest.qWait(10)

    def report(self):
        """What happened, for whoever started this."""
        return {
            "seed": self._seed, "done": len(self.last) and int(self.last[-1].split(":")[0]),
            "slowest": self.slowest, "measured": self.measured, "faults": self.faults.found,
            "last": list(self.last) if self.faults.found else [],
        }  # fmt: skip


def burnish_threads():
    """Return the threads that belong to a window."""
    return [t.name for t in threading.enumerate() if t.name.startswith("burnish")]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--actions", type=int, default=100)
    parser.add_argument("--log", type=Path, default=os.devnull, help="gets a line for each action")
    words = parser.parse_args()
    faulthandler.enable()
    log = words.log.open("w", encoding="utf-8")
    folder = Path(tempfile.mkdtemp(prefix="burnish-monkey-"))
    world.move_in(folder)
    application = world.set_up(folder)
    player = Player(folder, words.seed, log)
    player.play(words.actions)
    print(json.dumps(player.report()), flush=True)  # noqa: T201
    del application
    shutil.rmtree(folder, ignore_errors=True)
    os._exit(bool(player.faults.found))


if __name__ == "__main__":
    sys.exit(main())
