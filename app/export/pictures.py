"""Pictures of panes without a window: any size, opaque or transparent."""

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import pyvista as pv
from matplotlib.image import imsave
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

from app.scene.camera import OBLIQUE, CameraPose
from app.scene.colours import Theme
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from core.whole_files import whole_file

Picture = NDArray[np.uint8]


class PictureError(ValueError):
    """Raised when a picture cannot be made or written; one sentence says why."""


class Scene(Protocol):
    """What is drawn in a plotter."""

    plotter: Any

    def set_ground(self, bottom: str, top: str | None) -> None:
        """Colour the background, with a gradient if `top` is given."""

    def fit_clipping(self) -> None:
        """Set the clipping ranges."""


def composed(pieces: Iterable[Picture | None]) -> Picture:
    """Return the picture of its pieces: the only one, or that over black and that over white."""
    drawn = [piece for piece in pieces if piece is not None]
    return drawn[0] if len(drawn) == 1 else unmix(*drawn)


def scene_pieces(scene: Scene, theme: Theme, *, transparent: bool) -> Iterator[Picture | None]:
    """Draw a scene one viewport a step, so that whoever iterates has turns between them.

    Yields None after every viewport, and each picture that :func:`composed` needs when it is there.
    """
    opaque = (theme.ground, theme.ground_top)
    for bottom, top in (("black", None), ("white", None)) if transparent else (opaque,):
        scene.set_ground(bottom, top)
        scene.fit_clipping()
        yield from _draw(scene.plotter.render_window)
        yield _pixels(scene.plotter.render_window)


def shot(scene: Scene, bottom: str, top: str | None) -> Picture:
    """Picture a scene on a ground, at once."""
    scene.set_ground(bottom, top)
    scene.fit_clipping()
    scene.plotter.render()
    picture: Picture = scene.plotter.screenshot(return_img=True)
    return picture[..., :3]


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
    return composed(grid_pieces(panes, look, poses, size, transparent=transparent))


def grid_pieces(
    panes: Sequence[Pane],
    look: Look,
    poses: Sequence[CameraPose] | None,
    size: tuple[int, int],
    *,
    transparent: bool = False,
) -> Iterator[Picture | None]:
    """Draw what :func:`grid_picture` composes, one pane a step."""
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(size))
    try:
        grid = PaneGrid(plotter)
        yield None
        grid.show(panes, look, size)
        if poses is None:
            grid.look_from(OBLIQUE)
        else:
            grid.set_poses(poses)
        yield from scene_pieces(grid, look.theme, transparent=transparent)
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


def _draw(window: Any) -> Iterator[None]:
    """Draw the viewports of a window one after another; the pixels of the others stay."""
    renderers = [renderer for renderer in window.GetRenderers() if renderer.GetDraw()]
    for port in dict.fromkeys(renderer.GetViewport() for renderer in renderers):
        for renderer in renderers:
            renderer.SetDraw(renderer.GetViewport() == port)
        window.Render()
        yield
    for renderer in renderers:
        renderer.SetDraw(True)


def _pixels(window: Any) -> Picture:
    """Return what a window shows without drawing it again."""
    width, height = window.GetSize()
    data = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, True, data, 0)
    return np.array(vtk_to_numpy(data).reshape(height, width, 3)[::-1])
