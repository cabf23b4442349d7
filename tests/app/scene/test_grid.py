"""The grid of panes, drawn again and again."""

import gc
from collections import Counter

import numpy as np
import pytest
import pyvista as pv

from app.export.pictures import prefer_headless_graphics
from app.scene.caption import parted, text_width
from app.scene.grid import CAPACITY, GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from core.mesh import primitives

BALL = primitives.sphere(3)
POINTS = BALL.vertices.astype(np.float32)
SIZE = (400, 300)


@pytest.fixture
def grid():
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(SIZE))
    yield PaneGrid(plotter)
    plotter.close()


def panes(step, count=3):
    values = np.full(len(POINTS), 0.01 * step)
    return [
        Pane(f"p{i}", "", "", "#009e73", POINTS * (1 + 0.001 * step), values) for i in range(count)
    ]


def census():
    gc.collect()
    return Counter(type(thing).__name__ for thing in gc.get_objects())


def test_drawing_a_hundred_times_leaves_nothing_behind(grid):
    def draw(step):
        grid.show(panes(step), Look(BALL.topology, colour_title="x"), SIZE)
        grid.plotter.render()

    draw(0)
    draw(1)
    before = census()
    for step in range(100):
        draw(step)
    grown = {name: n for name, n in (census() - before).items() if n >= 100}
    assert not grown


def test_more_panes_than_there_is_room_for_are_left_out(grid):
    grid.show(panes(0, CAPACITY + 2), Look(BALL.topology), SIZE)
    assert len(grid.viewports) == CAPACITY


def test_other_faces_are_drawn_where_the_model_changes(grid):
    grid.show(panes(0), Look(BALL.topology), SIZE)
    torus = primitives.torus()
    pane = Pane("p0", "", "", "#009e73", torus.vertices.astype(np.float32))
    grid.show([pane], Look(torus.topology), SIZE)
    grid.look_from("Top (+Y)")
    grid.plotter.render()
    assert list(grid.viewports) == ["p0"]


def test_linking_takes_the_leaders_view(grid):
    grid.show(panes(0), Look(BALL.topology), SIZE)
    grid.look_from("Oblique")
    before = grid.poses()[0]
    grid.link(False)
    assert set(grid.poses()) == {before}
    grid.renderer("p1").GetActiveCamera().Azimuth(40)
    leader = grid.poses()[1]
    assert grid.poses()[0] == before
    grid.link(True, "p1")
    assert set(grid.poses()) == {leader}


def test_a_caption_takes_a_second_line_before_its_letters_shrink():
    text = "σ = 0.02 ℓ̄   D = 0.000609"
    wide, narrow = text_width(text, 12) + 1, text_width(text, 12) - 1
    assert parted(text, 12, wide) == text
    assert parted(text, 12, narrow) == "σ = 0.02 ℓ̄\nD = 0.000609"
    longest = "diverged at iteration 12   k = 11   D = 3.1"
    assert parted(longest, 12, text_width("diverged at iteration 12", 12) + 1) == (
        "diverged at iteration 12\nk = 11   D = 3.1"
    )


def test_the_noisy_caption_keeps_its_size_beside_the_colour_bar(grid):
    caption = "σ = 0.02 ℓ̄   D = 0.000609"
    shown = [Pane(f"p{i}", "Noisy input", caption, "#009e73", POINTS) for i in range(8)]
    grid.show(shown, Look(BALL.topology, colour_title="Distance"), (720, 440))
    assert {slot.caption._caption.prop.font_size for slot in grid._slots[:8]} == {12}


def widest(grid, pane):
    """Largest |x| of a pane's points in its view, where 1 is at the edge."""
    grid.plotter.render()
    renderer = grid.renderer(pane)

    def x_of(point):
        renderer.SetWorldPoint(*map(float, point), 1.0)
        renderer.WorldToView()
        return abs(renderer.GetViewPoint()[0])

    return max(map(x_of, grid.panes[grid.ids.index(pane)].points))


@pytest.mark.parametrize("linked", [True, False])
def test_models_stay_in_view_where_panes_become_narrower(grid, linked):
    one, look = panes(0, 1), Look(BALL.topology)
    grid.show(one, look, SIZE)
    grid.look_from("Front (+Z)")
    grid.link(linked)
    before = grid.poses()
    assert 0.7 < widest(grid, "p0") < 0.8
    grid.plotter.render_window.SetSize(300, 300)
    grid.show(one, Look(BALL.topology, colour_title="Error"), (300, 300))
    assert 0.9 < widest(grid, "p0") < 1.05
    grid.plotter.render_window.SetSize(*SIZE)
    grid.show(one, look, SIZE)
    for pose, now in zip(before, grid.poses(), strict=True):
        assert now.position == pytest.approx(pose.position)


def test_an_enlarged_model_fills_its_pane_and_is_as_before_afterwards(grid):
    five, look = panes(0, 5), Look(BALL.topology)
    grid.show(five, look, SIZE)
    grid.look_from("Front (+Z)")
    before = grid.poses()
    for enlarged in ("p1", None):
        grid.enlarged = enlarged
        grid.show(five, look, SIZE)
        if enlarged:
            assert 0.7 < widest(grid, enlarged) < 0.8
    for pose, now in zip(before, grid.poses(), strict=True):
        assert now.position == pytest.approx(pose.position)
