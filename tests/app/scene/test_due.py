"""Drawing only what is due gives the picture that drawing everything gives."""

import numpy as np
import pytest
import pyvista as pv

from app.export.pictures import _pixels, prefer_headless_graphics
from app.scene import parts
from app.scene.colours import DARK
from app.scene.due import Due
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from app.scene.swipe import Swipe
from core.mesh import primitives

BALL = primitives.sphere(3)
POINTS = BALL.vertices.astype(np.float32)
SIZE = (420, 300)
NAMES = ("a", "b", "c")


class Board:
    """A grid without a window that draws what is due, and notes what that was."""

    def __init__(self):
        prefer_headless_graphics()
        self.plotter = pv.Plotter(
            shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(SIZE)
        )
        self.grid = PaneGrid(self.plotter)
        self.window = self.plotter.render_window
        self.window.SetMultiSamples(0)  # as on the screen; else frames reach beyond their views
        self.due = Due(self.window, self.grid.seen)
        self.drawn = []
        self.window.AddObserver("StartEvent", self._begin)
        self.window.AddObserver("EndEvent", lambda *_: self.due.end())
        self.panes = {name: Pane(name, name, "", "#009e73", POINTS) for name in NAMES}
        self.look = Look(BALL.topology)
        self.show()
        self.grid.look_from("Oblique")
        self.window.Render()

    def _begin(self, *_):
        self.grid.fit_clipping()
        self.due.begin()
        names = dict(
            zip(self.grid.plotter.renderers, (*self.grid.ids, *6 * "-", "bar"), strict=True)
        )
        self.drawn.append([names[r] for r in self.plotter.renderers if r.GetDraw()])

    def show(self, **changes):
        """Show panes of which some have other points."""
        for name, points in changes.items():
            self.panes[name] = Pane(name, name, "", "#009e73", points)
        self.grid.show(list(self.panes.values()), self.look, SIZE)

    def draw(self):
        """Draw what is due and return which views that were."""
        self.drawn.clear()
        self.window.Render()
        return self.drawn[-1]

    def draw_singly(self):
        """Draw what is due one by one, then show it."""
        while self.due.draw_one() and not self.due.is_complete:
            pass
        steps = list(self.drawn)
        assert self.draw() == []
        self.drawn = steps

    def is_whole(self):
        """Whether the picture is the one that drawing everything gives."""
        shown = _pixels(self.window)
        self.due.forget()
        self.window.Render()
        return np.array_equal(shown, _pixels(self.window)) and shown.std() > 10


@pytest.fixture(params=[1, 3], ids=["whole", "in parts"])
def board(request, monkeypatch):
    monkeypatch.setattr(parts, "_FACES", -(-len(BALL.faces) // request.param))
    board = Board()
    board.parts = request.param
    yield board
    board.plotter.close()


def test_only_the_pane_that_changed_is_drawn(board):
    board.show(b=POINTS * np.float32([1, 0.6, 1]))
    assert board.draw() == ["b"]
    assert board.draw() == []
    assert board.is_whole()


def test_a_mesh_beyond_the_clipping_range_is_seen_whole(board):
    board.show(c=POINTS * np.float32(1.4))
    assert board.draw() == ["a", "b", "c"]
    assert board.is_whole()


def test_a_camera_that_moves_draws_every_pane_that_it_shows(board):
    board.grid.renderer("a").GetActiveCamera().Azimuth(20)
    assert board.draw() == list(NAMES)
    board.grid.link(False)
    board.grid.renderer("b").GetActiveCamera().Azimuth(20)
    assert board.draw() == ["b"]
    assert board.is_whole()


def test_what_was_hidden_behind_an_enlarged_pane_is_drawn_again(board):
    board.grid.enlarged = "b"
    board.show()
    assert board.draw() == ["b"]
    board.grid.enlarged = None
    board.show()
    assert board.draw() == list(NAMES)
    assert board.is_whole()


def test_the_line_of_a_swipe_is_drawn_where_it_is(board):
    for share in (0.5, 0.3):
        board.grid.swipe = Swipe("a", "c", share)
        board.show()
        assert board.draw() == ["a"]
    board.show(c=POINTS * np.float32([1, 1, 0.5]))
    assert board.draw() == ["a"]
    assert board.is_whole()
    board.grid.swipe = None
    board.show()
    assert board.draw() == list(NAMES)
    assert board.is_whole()


def test_a_new_range_of_colours_draws_panes_and_bar(board):
    values = np.linspace(0, 1, len(POINTS))
    for name in NAMES:
        board.panes[name] = Pane(name, name, "", "#009e73", POINTS, values)
    for end in (1.0, 0.5):
        board.look = Look(BALL.topology, colour_title="Distance", colour_range=(0.0, end))
        board.show()
        assert board.draw() == [*NAMES, "bar"]
    board.look = Look(BALL.topology, colour_title="Distance", colour_range=(0.0, 0.5), selected="b")
    board.show()
    assert board.draw() == ["b"]
    assert board.is_whole()


def test_another_theme_or_size_draws_everything(board):
    board.look = Look(BALL.topology, DARK)
    board.grid.set_ground(DARK.ground, DARK.ground_top)
    board.show()
    assert board.draw() == list(NAMES)
    board.window.SetSize(500, 300)
    assert board.draw() == list(NAMES)
    assert board.is_whole()


def test_one_pane_at_a_time_is_drawn_behind_what_is_shown(board):
    board.show(**{name: POINTS * np.float32([1, 0.5, 1]) for name in NAMES})
    board.drawn.clear()
    shown = []
    board.window.AddObserver("EndEvent", lambda *_: shown.append(board.window.GetSwapBuffers()))
    while board.due.draw_one() and not board.due.is_complete:
        pass
    assert board.drawn == [[name] for name in NAMES for _ in range(board.parts)]
    assert not any(shown)
    assert not board.due.draw_one()
    assert board.draw() == []
    assert shown[-1]
    assert board.is_whole()


def test_a_mesh_that_changes_meanwhile_is_drawn_from_its_first_part_on(board):
    board.show(b=POINTS * np.float32([1, 0.5, 1]))
    assert board.due.draw_one()
    board.show(b=POINTS * np.float32([0.5, 1, 1]))
    board.drawn.clear()
    board.draw_singly()
    assert board.drawn == [["b"]] * board.parts
    assert board.is_whole()


def test_parts_of_both_meshes_beside_a_line_are_drawn(board):
    board.grid.swipe = Swipe("a", "c", 0.4)
    board.show(c=POINTS * np.float32([1, 1, 0.5]))
    board.drawn.clear()
    board.draw_singly()
    assert board.drawn == [["a"]] * 2 * board.parts
    assert board.is_whole()


def test_pixels_lost_between_parts_are_drawn_again(board):
    board.show(b=POINTS * np.float32([1, 0.5, 1]))
    assert board.due.draw_one()
    board.due.forget()
    board.draw_singly()
    assert board.is_whole()


def test_a_camera_that_moves_meanwhile_leaves_no_pane_behind(board):
    board.show(**{name: POINTS * np.float32([1, 0.5, 1]) for name in NAMES})
    assert board.due.draw_one()
    board.grid.renderer("a").GetActiveCamera().Azimuth(20)
    assert board.draw() == list(NAMES)
    assert board.due.is_complete
    assert board.is_whole()
