"""A random user of the real window: ``python play.py --seed 3 --actions 100``.

Prints one JSON object: what was measured at rest and, where something broke, what was done last.
The same seed does the same again, as far as threads allow.
"""

import argparse
import faulthandler
import json
import os
import random
import time
from collections import deque
from pathlib import Path

import hands
import world
from habits import Habits
from house import House, inhabit
from PySide6.QtWidgets import QApplication

_PIECE = 100
_LAST = 30
_HANG = 120


class Player:
    """Plays with a window; when that closes, with the next one.

    Parameters
    ----------
    folder : Path
        Where the files are.
    seed : int
        Decides what is done.
    log : file
        Gets a line for each action, at once: a process that crashes cannot tell any more.
    """

    def __init__(self, folder, seed, log):
        self._random = random.Random(seed)
        self._seed, self._log = seed, log
        self._rescuer = hands.Rescuer(self._random)
        good, bad = world.make_models(folder)
        self._home, self._habits = good[0], Habits(self._random, good, bad, self._say)
        self.house, self.done = House(), 0
        self.last, self.slowest = deque(maxlen=_LAST), (0, "")

    def play(self, actions):
        """Do a number of things, and come to rest after every piece."""
        self._open_window()
        self._come_home()
        for number in range(1, actions + 1):
            self._do(number)
            if number % _PIECE == 0 or number == actions:
                self._come_home()
            if self.house.faults.found:
                return
        self.house.close_window()

    def report(self):
        """Return what happened, for whoever started this."""
        faults = self.house.faults.found
        return {
            "seed": self._seed, "done": self.done, "slowest": self.slowest,
            "measured": self.house.measured, "faults": faults,
            "last": list(self.last) if faults else [],
        }  # fmt: skip

    def _open_window(self):
        self.house.open_window()
        self._habits.window = self.house.window

    def _come_home(self):
        self.house.come_home(self._home)
        self.house.measure()

    def _do(self, number):
        faulthandler.dump_traceback_later(_HANG, exit=True)
        # Each action by itself: one that went otherwise does not change all that follow.
        self._random.seed(f"{self._seed}:{number}")
        started = time.monotonic()
        self._rescuer.begin()
        said = self._habits.act()
        self._rescuer.end()
        hands.rest(1)
        self._note(number, said, time.monotonic() - started)
        if not self.house.window.isVisible():
            self._habits.window = None
            self.house.close_window()
            self._open_window()
        elif QApplication.activeWindow() is None:  # a window manager would choose one
            self.house.window.activateWindow()

    def _note(self, number, said, seconds):
        self.done, line = number, f"{number}: {said} ({seconds:.2f} s)"
        self.last.append(line)
        self.slowest = max(self.slowest, (round(seconds, 2), said))
        self._say(line)

    def _say(self, line):
        print(line, file=self._log, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--actions", type=int, default=100)
    parser.add_argument("--log", default=os.devnull, help="gets a line for each action")
    words = parser.parse_args()

    def live(folder: Path) -> int:
        with open(words.log, "w", encoding="utf-8") as log:
            player = Player(folder, words.seed, log)
            player.play(words.actions)
        print(json.dumps(player.report()))  # noqa: T201
        return bool(player.house.faults.found)

    words.log = os.path.abspath(words.log)
    inhabit(live)


if __name__ == "__main__":
    main()
