"""Pictures of panes without a window: any size, opaque or transparent."""

import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyvista as pv
from matplotlib.image import imsave
from numpy.typing import NDArray

from app.scene.camera import CameraPose
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from core.whole_files import whole_file

Picture = NDArray[np.uint8]


class PictureError(ValueError):
    """Raised when a picture cannot be made or written; one sentence says why."""


def grid_picture(
    panes: Sequence[Pane],
    look: Look,
    poses: Sequence[CameraPose] | None,
    size: tuple[int, int],
    *,
    transparent: bool = False,
) -> Picture:
    """Draw panes into a picture.

    Parameters
    ----------
    panes : sequence of Pane
        What to draw, in reading order.
    look : Look
        How; `text_scale` is the size of text and lines.
    poses : sequence of CameraPose or None
        One pose for all panes or one for each of the grid's renderers; None shows the whole model.
    size : (int, int)
        Width and height in pixels.
    transparent : bool
        Leave out the background; the picture composes correctly over any other.

    Returns
    -------
    (height, width, 3 or 4) uint8 ndarray
        RGB, or RGBA with straight alpha where `transparent`.
    """
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(size))
    try:
        grid = PaneGrid(plotter)
        grid.show(panes, look, size)
        if poses is None:
            grid.look_from("Oblique")
        else:
            grid.set_poses(poses)
        if not transparent:
            return _shot(plotter, grid, look.theme.ground, look.theme.ground_top)
        return unmix(_shot(plotter, grid, "black", None), _shot(plotter, grid, "white", None))
    finally:
        plotter.close()


def prefer_headless_graphics() -> None:
    """Without a display, let VTK draw without asking an X server first."""
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")


def unmix(over_black: Picture, over_white: Picture) -> Picture:
    """Recover colour and alpha of a picture from how it looks over black and over white.

    C_black = αC and C_white = αC + (1 − α), so α = 1 − (C_white − C_black) and C = C_black/α.
    """
    black, white = over_black.astype(np.float64) / 255, over_white.astype(np.float64) / 255
    alpha = np.clip(1 - (white - black).mean(axis=2), 0, 1)
    colour = np.divide(
        black, alpha[..., None], out=np.zeros_like(black), where=alpha[..., None] > 0
    )
    rgba = np.dstack([np.clip(colour, 0, 1), alpha])
    return np.round(rgba * 255).astype(np.uint8)


def scaled(look: Look, factor: float) -> Look:
    """Return a look whose text and lines are larger by a factor."""
    return replace(look, text_scale=look.text_scale * factor)


def save_picture(picture: Picture, path: Path) -> None:
    """Write a picture as PNG.

    Raises
    ------
    PictureError
        If the file cannot be written.
    """
    try:
        with whole_file(path) as stream:
            imsave(stream, np.ascontiguousarray(picture), format="png")
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise PictureError(f"{path} cannot be written: {reason}.") from error


def _shot(plotter: pv.Plotter, grid: PaneGrid, bottom: str, top: str | None) -> Picture:
    grid.set_ground(bottom, top)
    grid.fit_clipping()
    plotter.render()
    picture: Picture = plotter.screenshot(return_img=True)
    return picture[..., :3]
