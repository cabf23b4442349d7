"""No display, no OpenGL: one sentence instead of a crash, and the command line goes on."""

import json
import subprocess
import sys

import pytest

WITHOUT_OPENGL = {
    "too old": {"MESA_GL_VERSION_OVERRIDE": "1.1"},
    "no driver": {"LIBGL_DRIVERS_PATH": "/nonexistent"},
    "no GLX": {"QT_XCB_GL_INTEGRATION": "none"},
}
# Closes whatever dialog appears, and says what it read there.
_PERSON = """
import sys
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QMessageBox
application = QApplication([])

def close():
    for box in QApplication.topLevelWidgets():
        if isinstance(box, QMessageBox) and box.isVisible():
            print(box.text())
            box.close()

timer = QTimer()
timer.timeout.connect(close)
timer.start(100)
from app.cli import main
main(sys.argv[1:])
"""
_PLAIN = "import sys; from app.cli import main; main(sys.argv[1:])"


def call(program, environment, *words):
    command = [sys.executable, "-c", program, *map(str, words)]
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=100, check=False
    )


def said(result):
    """Lines on standard error but those of the graphics libraries."""
    return [line for line in result.stderr.splitlines() if line.startswith("burnish: ")]


def test_a_display_that_is_not_there_is_one_sentence(environment, ball_file):
    result = call(_PLAIN, {**environment, "DISPLAY": ":987"}, ball_file)
    assert result.returncode == 1
    assert result.stderr == (
        "burnish: The window cannot open: could not connect to display :987. The command line "
        "needs none of this: burnish compare MODEL -o FOLDER.\n"
    )


@pytest.mark.parametrize("fault", WITHOUT_OPENGL)
def test_without_opengl_the_window_says_so(fault, display, environment, ball_file):
    given = {**environment, "DISPLAY": display.name, **WITHOUT_OPENGL[fault]}
    result = call(_PERSON, given, ball_file)
    assert result.returncode == 1
    sentence = "Burnish needs a graphics driver with OpenGL 3.2 or newer; this one has "
    assert result.stdout.startswith(sentence)
    assert len(said(result)) == 1
    assert sentence in said(result)[0]
    assert "Traceback" not in result.stderr


def test_without_opengl_the_command_line_gives_its_numbers(environment, ball_file):
    given = {**environment, **WITHOUT_OPENGL["no driver"]}
    words = ("compare", ball_file, "--methods", "mean", "--iterations", 1, "--json")
    result = call(_PLAIN, given, *words)
    assert (result.returncode, result.stderr) == (0, "")
    assert json.loads(result.stdout)["methods"][0]["id"] == "mean"


@pytest.mark.parametrize(
    ("fault", "words", "written"),
    [
        ("too old", ("compare", "--iterations", "1"), {"table.csv", "mean.ply"}),
        ("no driver", ("stats", "--sources", "9", "--matrices"), {"statistics.json", "edge.mtx"}),
    ],
)
def test_without_opengl_only_the_pictures_are_missing(
    fault, words, written, display, environment, ball_file, tmp_path
):
    given = {**environment, "DISPLAY": display.name, **WITHOUT_OPENGL[fault]}
    command, *options = words
    result = call(_PLAIN, given, command, ball_file, *options, "-o", tmp_path / "out")
    assert result.returncode == 2
    assert len(said(result)) == 1
    assert "Pictures cannot be drawn here" in said(result)[0]
    assert written <= {path.name for path in (tmp_path / "out").iterdir()}


def test_with_opengl_the_pictures_are_there(environment, ball_file, tmp_path):
    result = call(_PLAIN, environment, "skeleton", ball_file, "-o", tmp_path / "graph.png")
    assert result.returncode == 0
    assert (tmp_path / "graph.png").stat().st_size > 1000
