"""The display goes away while a window is open."""

import subprocess
import sys

from app.ui.autosave import leftovers

_PROGRAM = """
import sys
from PySide6.QtCore import QSettings, QTimer
QSettings.setDefaultFormat(QSettings.Format.IniFormat)
from app.ui import main_window
shown = main_window.MainWindow.show

def show(window):
    shown(window)
    def change():
        session = window.session
        if session.meshes is None or session.activity is not None:
            return QTimer.singleShot(50, change)
        choice = session.study.choice("mean").model_copy(update={"iterations": 23})
        session.apply(session.study.with_choice(choice), "Iterations")
        print("changed", flush=True)
    QTimer.singleShot(50, change)

main_window.MainWindow.show = show
from app.cli import main
main([sys.argv[1]])
"""


def test_a_lost_display_ends_the_program_and_keeps_the_study(
    display, environment, ball_file, tmp_path
):
    """It is lost before the study would have been kept by itself, two seconds after a change."""
    words = [sys.executable, "-c", _PROGRAM, str(ball_file)]
    program = subprocess.Popen(
        words, env={**environment, "DISPLAY": display.name}, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    try:
        assert program.stdout.readline() == "changed\n"
        display.end()
        _, stderr = program.communicate(timeout=30)
    finally:
        program.kill()
    assert program.returncode == 1
    lines = [line for line in stderr.splitlines() if line.startswith("burnish: ")]
    assert lines == [
        "burnish: The display is lost. What was not saved is kept; the next start offers it."
    ]
    kept = list((tmp_path / "state").rglob("study.json"))
    assert len(kept) == 1
    found = leftovers(kept[0].parents[1])
    assert [left.title for left in found] == ["ball.ply"]
    assert found[0].study.study.choice("mean").iterations == 23
    found[0].lock.unlock()
