"""The model beside the statistics plots."""

import numpy as np
import pytest
import pyvista as pv

from app.export.pictures import prefer_headless_graphics
from app.scene.caption import parted
from app.scene.colours import LIGHT
from app.scene.panes import Look
from app.scene.statistics_panes import PaneMaker, ShownModel
from app.scene.statistics_scene import SCENE_SHAPE, StatisticsScene
from core.mesh import primitives

SIZE = (200, 150)
GROUND = "#ff0000"
BALL = ShownModel("ball", "#009e73", primitives.sphere(2))


@pytest.fixture
def scene():
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=SCENE_SHAPE, border=False, off_screen=True, window_size=list(SIZE))
    scene = StatisticsScene(plotter)
    scene.set_ground(GROUND, None)
    yield scene
    plotter.close()


def drawn(scene):
    scene.plotter.render()
    return {tuple(each) for each in scene.plotter.screenshot().reshape(-1, 3)}


def test_without_a_model_there_is_the_ground_alone(scene):
    assert drawn(scene) == {(255, 0, 0)}
    look = Look(BALL.mesh.topology, LIGHT)
    scene.show(PaneMaker().panes([BALL]), look, SIZE)
    assert len(drawn(scene)) > 10
    scene.show([], look, SIZE)
    assert drawn(scene) == {(255, 0, 0)}
    assert scene.model_at(0.5, 0.5) is None


@pytest.mark.parametrize("count", [1, 2])
def test_models_lie_side_by_side(scene, count):
    scene.show(PaneMaker().panes([BALL] * count), Look(BALL.mesh.topology, LIGHT), SIZE)
    assert [scene.model_at(x, 0.5) for x in (0.25, 0.75)] == [0, count - 1]
    assert np.isclose(sum(port.right - port.left for port in scene.viewports), 1)


def test_a_narrow_caption_gets_a_second_line():
    (shown,) = PaneMaker().panes([BALL])
    assert parted(shown.pane.caption, 12, room=120) == "162 vertices\n320 faces"


def test_numbers_of_two_models_cover_neither():
    assert [shown.pane.caption for shown in PaneMaker().panes([BALL, BALL])] == ["", ""]
