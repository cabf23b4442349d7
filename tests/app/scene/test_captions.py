"""Text over meshes can be read, whatever colour lies below it."""

import numpy as np
import pytest
import pyvista as pv
from matplotlib.colors import to_rgb

from app.export.pictures import prefer_headless_graphics
from app.scene.colours import DARK, LIGHT
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from app.scene.skeleton_grid import SHAPE, SkeletonGrid
from app.scene.skeleton_panes import SkeletonLook, build_pane, missing_pane
from app.session.skeleton_maker import SkeletonMaker, SkeletonSource
from core.mesh import primitives
from core.study import SkeletonSettings, SkeletonView

BALL = primitives.sphere(3)
SIZE = (300, 220)
LEAST_RATIO = 4.5  # WCAG 2.1, level AA
SECOND_LINE = np.s_[30:40, 10:90]
"""Rows and columns of a picture in which the second line of a caption stands."""


@pytest.fixture
def plotter():
    """Makes plotters of a shape, and closes them."""
    prefer_headless_graphics()
    made = []

    def make(shape):
        made.append(pv.Plotter(shape=shape, border=False, off_screen=True, window_size=list(SIZE)))
        return made[-1]

    yield make
    for each in made:
        each.close()


def luminance(colour):
    colour = np.asarray(colour)
    linear = np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
    return linear @ (0.2126, 0.7152, 0.0722)


def contrast(picture, place, ink):
    """Contrast of an ink with what most of a place shows, which is the ground between letters."""
    ground = np.median(picture[place].reshape(-1, 3), axis=0) / 255
    low, high = sorted((luminance(ground), luminance(to_rgb(ink))))
    return (high + 0.05) / (low + 0.05)


def picture_of(grid, theme):
    grid.set_ground(theme.ground, theme.ground_top)
    grid.plotter.render()
    return grid.plotter.screenshot(return_img=True)[..., :3]


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize("value", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("warning", [False, True])
def test_a_caption_can_be_read_over_every_colour_of_a_heat_map(plotter, theme, value, warning):
    grid = PaneGrid(plotter(GRID_SHAPE))
    points = BALL.vertices.astype(np.float32)
    values = np.full(len(points), value)
    pane = Pane("p", "Title", "k = 18   D = 0.00243", "#009e73", points, values, warning)
    grid.show([pane], Look(BALL.topology, theme, colour_title="Distance", bar=False), SIZE)
    grid.look_from("Front (+Z)")
    grid.renderer("p").GetActiveCamera().Zoom(5)  # now the mesh lies below all of the text
    picture = picture_of(grid, theme)
    ink = grid._slots[0].caption._caption.prop.color.hex_rgb
    assert contrast(picture, SECOND_LINE, ink) >= LEAST_RATIO


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
def test_the_words_of_a_skeleton_can_be_read_over_bands_and_graph(plotter, theme):
    skeleton = SkeletonMaker().make(SkeletonSource("ball", lambda: BALL), SkeletonView())
    settings = SkeletonSettings(opacity=1.0, node_size=2.0)
    grid = SkeletonGrid(plotter(SHAPE))
    grid.show([build_pane(skeleton, np.zeros(3))], SkeletonLook(settings, theme), SIZE)
    grid.look_from("Front (+Z)", SIZE)
    grid.camera.Zoom(8)
    picture = picture_of(grid, theme)
    legend = np.s_[150:200, 290:298]
    for place in (SECOND_LINE, legend):
        assert contrast(picture, place, theme.ink) >= LEAST_RATIO


def test_only_what_failed_is_a_warning(plotter):
    grid = SkeletonGrid(plotter(SHAPE))
    look, view = SkeletonLook(SkeletonSettings()), SkeletonView()
    captions = []
    for reason, warning in (("Drawing …", False), ("R is too large.", True)):
        grid.show([missing_pane(view, np.zeros(3), reason, warning=warning)], look, SIZE)
        captions.append(grid._slots[0].caption._lines[1].prop.color.hex_rgb)
    assert captions[0] == LIGHT.ink != captions[1]
