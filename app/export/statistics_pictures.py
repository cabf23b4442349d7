"""Pictures of the models beside the statistics plots, without a window."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace

import pyvista as pv

from app.export.pictures import Picture, prefer_headless_graphics, scene_pieces
from app.scene.camera import CameraPose
from app.scene.panes import Look
from app.scene.statistics_scene import SCENE_SHAPE, ModelPane, StatisticsScene


def models_pieces(
    panes: Sequence[ModelPane],
    look: Look,
    pose: CameraPose,
    size: tuple[int, int],
    *,
    scale: float = 1.0,
    transparent: bool = False,
    share: float | None = None,
) -> Iterator[Picture | None]:
    """Draw one model or two into a picture, one a step; :func:`composed` puts it together.

    Parameters
    ----------
    panes : sequence of ModelPane
        The models.
    look : Look
        How they are drawn.
    pose : CameraPose
        Where the camera stands, beside models in the unit ball.
    size : (int, int)
        Width and height in pixels.
    scale : float
        Size of text and lines against those of `look`.
    transparent : bool
        Leave out the background; the picture composes correctly over any other.
    share : float or None
        Parts two models, shown as one, at this share of the width.
    """
    look = replace(look, text_scale=look.text_scale * scale)
    with models_studio(size) as scene:
        scene.part(share)
        scene.show(panes, look, size)
        scene.set_pose(pose)
        yield from scene_pieces(scene, look.theme, transparent=transparent)


@contextmanager
def models_studio(size: tuple[int, int]) -> Iterator[StatisticsScene]:
    """A scene to draw pictures of `size` pixels in."""
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=SCENE_SHAPE, border=False, off_screen=True, window_size=list(size))
    try:
        yield StatisticsScene(plotter)
    finally:
        plotter.close()
