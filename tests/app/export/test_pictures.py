"""Pictures without a window: what is on them, at any size, on any ground."""

from dataclasses import replace

import numpy as np
import pytest
import pyvista as pv

from app.export.pictures import (
    PictureError,
    composed,
    grid_picture,
    grid_pieces,
    save_picture,
    scaled,
    shot,
    unmix,
)
from app.scene.camera import OBLIQUE, CameraPose
from app.scene.colours import DARK
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane, shared_range
from core.mesh import primitives

BALL = primitives.sphere(3)
POINTS = BALL.vertices.astype(np.float32)
SIZE = (400, 300)


def pane(id_="mean", values=None, title=""):
    return Pane(id_, title, "", "#009e73", POINTS, values)


def test_unmix_recovers_colour_and_alpha():
    colour = np.array([200, 100, 50])
    alpha = np.array([[0.0, 0.25, 0.5, 1.0]])
    black = (alpha[..., None] * colour).round().astype(np.uint8)
    white = (alpha[..., None] * colour + 255 * (1 - alpha[..., None])).round().astype(np.uint8)
    mixed = unmix(black, white)
    assert mixed[0, :, 3] == pytest.approx(alpha[0] * 255, abs=2)
    assert mixed[0, 1:, :3] == pytest.approx(np.tile(colour, (3, 1)), abs=4)


def test_a_picture_shows_the_model_on_its_ground():
    picture = grid_picture([pane()], Look(BALL.topology, DARK), None, SIZE)
    assert picture.shape == (300, 400, 3)
    centre, corner = picture[150, 200].astype(int), picture[295, 5].astype(int)
    assert centre.mean() > corner.mean() + 40


def test_a_transparent_picture_composes_over_any_ground():
    look = Look(BALL.topology)
    clear = grid_picture([pane()], look, None, SIZE, transparent=True).astype(float)
    solid = grid_picture([pane()], look, None, SIZE)
    assert clear[5, 390, 3] == 0
    assert clear[150, 200, 3] == 255
    assert clear[150, 200, :3] == pytest.approx(solid[150, 200].astype(float), abs=2)


def test_twice_the_size_is_the_same_picture_twice_as_large():
    look, poses = Look(BALL.topology), [CameraPose((0, 0, 6), (0, 0, 0), (0, 1, 0))]
    small = grid_picture([pane()], look, poses, SIZE)
    large = grid_picture([pane()], scaled(look, 2), poses, (800, 600))
    shrunk = large.reshape(300, 2, 400, 2, 3).mean(axis=(1, 3))
    assert np.abs(shrunk - small).mean() < 2


def test_panes_share_one_colour_range_that_one_wild_pane_cannot_spoil():
    calm = [pane(str(i), np.linspace(0, 1, 100)) for i in range(2)]
    wild = pane("wild", np.linspace(0, 1000, 100))
    assert shared_range([*calm, wild])[1] == pytest.approx(0.98)


def test_values_colour_the_mesh_and_add_a_bar():
    look = Look(BALL.topology, colour_title="Error", colour_range=(0, 1))
    ones = np.ones(len(POINTS))
    low = grid_picture([pane(values=0 * ones)], look, None, SIZE)
    high = grid_picture([pane(values=ones)], look, None, SIZE)
    dark, bright = low[150, 150].astype(int), high[150, 150].astype(int)
    assert dark[2] > dark[1]  # the lower end of the map is violet
    assert bright[1] > bright[2] + 60  # the upper end is yellow
    bar = high[60:270, 310:].reshape(-1, 3).astype(int)
    assert np.ptp(bar[:, 1]) > 150


def test_a_picture_that_cannot_be_written_is_one_sentence(tmp_path):
    with pytest.raises(PictureError, match=r"picture\.png cannot be written: No such file"):
        save_picture(np.zeros((2, 2, 3), np.uint8), tmp_path / "no" / "picture.png")


@pytest.mark.parametrize("transparent", [False, True])
def test_panes_drawn_one_a_step_are_the_panes_drawn_at_once(transparent):
    panes = [pane(id_, title=id_.title()) for id_ in ("mean", "median", "laplacian")]
    look = replace(Look(BALL.topology, DARK), selected="median")
    pieces = list(grid_pieces(panes, look, None, SIZE, transparent=transparent))
    assert len(pieces) >= 5
    plotter = pv.Plotter(shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(SIZE))
    grid = PaneGrid(plotter)
    grid.show(panes, look, SIZE)
    grid.look_from(OBLIQUE)
    opaque = (DARK.ground, DARK.ground_top)
    grounds = [("black", None), ("white", None)] if transparent else [opaque]
    at_once = composed([shot(grid, *ground) for ground in grounds])
    plotter.close()
    assert np.array_equal(composed(pieces), at_once)
