"""A display of its own, which a test may take away, and a place for what the program keeps."""

import os
import shutil
import subprocess
from dataclasses import dataclass

import pytest

from core.io import save_mesh
from core.mesh import primitives


@dataclass
class Display:
    """A virtual X server."""

    name: str
    server: subprocess.Popen

    def end(self):
        self.server.kill()
        self.server.wait()


@pytest.fixture
def display():
    program = shutil.which("Xvfb")
    if program is None:
        pytest.skip("Xvfb is not installed")
    read, write = os.pipe()
    server = subprocess.Popen(
        [program, "-displayfd", str(write), "-screen", "0", "1280x800x24"],
        pass_fds=[write], stderr=subprocess.DEVNULL,
    )  # fmt: skip
    os.close(write)
    with os.fdopen(read) as pipe:
        number = pipe.readline().strip()
    yield Display(f":{number}", server)
    server.kill()
    server.wait()


@pytest.fixture
def environment(tmp_path):
    """The environment of a program without a display, that keeps its files in the test's folder."""
    kept = {name: value for name, value in os.environ.items() if name not in WINDOWS}
    kinds = ("STATE", "CACHE", "CONFIG")
    return kept | {f"XDG_{kind}_HOME": str(tmp_path / kind.lower()) for kind in kinds}


WINDOWS = {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "PYVISTA_OFF_SCREEN"}


@pytest.fixture
def ball_file(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(2), path)
    return path
