"""What a start of the window does without."""

import subprocess
import sys

import pytest

from app.ui.actions import COMMANDS
from app.ui.icons import font_icon


def test_the_window_is_imported_without_kernels_and_sparse_matrices():
    code = (
        "import app.ui.main_window, sys;"
        "late = {'numba', 'scipy.sparse', 'networkx', 'trimesh', 'potpourri3d'};"
        "sys.exit(str(late & set(sys.modules)) if late & set(sys.modules) else 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", sorted({command.icon for command in COMMANDS if command.icon}))
def test_the_one_font_has_the_icons_of_the_commands(qapp, name):
    drawn = font_icon(name, color="#000000").pixmap(16, 16).toImage()
    ink = [drawn.pixelColor(x, y).alpha() for x in range(16) for y in range(16)]
    assert 0 < sum(map(bool, ink)) < 256


def test_another_fonts_icon_is_refused(qapp):
    with pytest.raises(Exception, match="fa5"):
        font_icon("fa5.bell")
