"""A place to play in: folders, settings and models of its own, nothing of the user's."""

import os
import time
from pathlib import Path

# pyvistaqt asks qtpy for a binding; say which before either is imported.
os.environ.setdefault("QT_API", "pyside6")

_FOLDERS = ("STATE", "CACHE", "CONFIG", "DATA")


def move_in(folder: Path) -> None:
    """Make a folder the home of this process."""
    import matplotlib.font_manager  # noqa: F401 - keeps the place of its cache of fonts

    for kind in _FOLDERS:
        os.environ[f"XDG_{kind}_HOME"] = str(folder / kind.lower())
    os.environ["HOME"] = str(folder)
    os.chdir(folder)


def set_up(folder: Path):
    """Start Qt with settings below a folder, without other programs and without a network."""
    from PySide6.QtCore import QCoreApplication, QSettings
    from PySide6.QtWidgets import QApplication

    QCoreApplication.setOrganizationName("BurnishTests")
    QCoreApplication.setApplicationName("BurnishTests")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    QSettings.setPath(
        QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder / "settings")
    )
    application = QApplication(["burnish"])
    # A window that closes is followed by another one.
    application.setQuitOnLastWindowClosed(False)
    _stay_inside(folder)
    return application


def _stay_inside(folder: Path) -> None:
    from PySide6.QtGui import QDesktopServices

    from app.ui import downloads

    def download(example: str, _: downloads.Meter) -> str:
        time.sleep(0.2)
        if len(example) % 2:
            raise downloads.DownloadError(f"{example} cannot be downloaded: there is no network.")
        return str(folder / "ball.ply")

    downloads.download = download
    QDesktopServices.openUrl = staticmethod(lambda _: True)


def make_models(folder: Path) -> tuple[list[Path], list[Path]]:
    """Write files that open and files that do not."""
    from core.io import save_mesh
    from core.mesh import TriangleMesh, primitives

    good = {
        "ball.ply": primitives.sphere(2),
        "torus.obj": primitives.torus(16, 8),
        "sheet.off": primitives.grid(5, 4),
        "tetrahedron.stl": primitives.tetrahedron(),
        "one triangle – ünï & co.ply": TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
        "two parts.ply": _two_balls(),
    }
    for name, mesh in good.items():
        save_mesh(mesh, folder / name)
    content = (folder / "ball.ply").read_bytes()
    bad = {
        "cut.ply": content[: len(content) // 2],
        "empty.obj": b"",
        "lying.off": b"OFF\n4000000000 2 0\n0 0 0\n",
        "points.obj": b"v 0 0 0\nv 1 0 0\n",
        "noise.stl": bytes(range(256)) * 4,
        "no study.burnish": b'{"model": 7}',
    }
    for name, data in bad.items():
        (folder / name).write_bytes(data)
    return [folder / name for name in good], [*(folder / n for n in bad), folder / "gone.ply"]


def _two_balls():
    import numpy as np

    from core.mesh import TriangleMesh, primitives

    ball = primitives.icosahedron()
    vertices = np.vstack([ball.vertices, ball.vertices + 5])
    return TriangleMesh(vertices, np.vstack([ball.faces, ball.faces + len(ball.vertices)]))
