"""Hands to act with, and a session on a small model to act upon."""

import gc

import pytest
from PySide6.QtCore import QPoint, Qt

from app.session import Session
from app.ui.tasks import Poster
from core.io import save_mesh
from core.mesh import primitives
from core.noise import NoiseParams
from core.study import Study


class Hands:
    """What a person does with mouse and keys, beyond what qtbot knows."""

    def __init__(self, qtbot):
        self._qtbot = qtbot

    def type_into(self, box, text):
        """Replace the number in a spin box."""
        box.setFocus()
        box.selectAll()
        self._qtbot.keyClicks(box, text)
        self._qtbot.keyClick(box, Qt.Key.Key_Return)

    def click_check(self, box):
        """Click the square of a check box, not the empty space beside it."""
        place = QPoint(9, box.height() // 2)
        self.click(box, place)

    def click(self, widget, place=None):
        """Click a place of a widget, its middle unless another is given."""
        place = place or widget.rect().center()
        self._qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=place)

    def choose(self, box, key):
        """Choose an entry of a combo box as the mouse does."""
        box.setCurrentIndex(box.findData(key))
        box.activated.emit(box.currentIndex())


@pytest.fixture(scope="session", autouse=True)
def _modules_are_not_collected():
    """Keep what the modules hold out of every garbage collection: of a window it is most."""
    import app.ui.main_window  # noqa: F401

    gc.collect()
    gc.freeze()


@pytest.fixture
def hands(qtbot):
    return Hands(qtbot)


@pytest.fixture
def shown(qtbot):
    """Show a widget in a size and return it."""

    def show(widget, width, height):
        qtbot.addWidget(widget)
        widget.resize(width, height)
        widget.show()
        widget.activateWindow()
        with qtbot.waitActive(widget):
            return widget

    return show


@pytest.fixture
def ball_file(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(2), path)
    return path


@pytest.fixture
def session(qtbot, ball_file):
    """A session with the five methods at six iterations, all computed."""
    session = Session(Poster())
    session.apply(Study(model=str(ball_file), noise=NoiseParams(sigma=0.1)), "Open")
    qtbot.waitUntil(lambda: session.meshes is not None and session.activity is None, timeout=30_000)
    yield session
    session.close()


@pytest.fixture
def change(session):
    """Change a method's choice as another widget would."""

    def change(method, **update):
        choice = session.study.choice(method).model_copy(update=update)
        session.apply(session.study.with_choice(choice), "Test")

    return change


@pytest.fixture
def diverging():
    """Parameters with which the diffusion diverges."""
    return {"form": "printed", "gradient_scale": 0.01}
