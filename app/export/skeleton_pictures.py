"""Pictures and films of skeletal graphs without a window."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace

import pyvista as pv

from app.export.pictures import (
    Picture,
    composed,
    prefer_headless_graphics,
    scene_pieces,
    shot,
)
from app.scene.camera import OBLIQUE, CameraPose
from app.scene.skeleton_grid import SHAPE, SkeletonGrid
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane


def skeleton_picture(
    panes: Sequence[SkeletonPane],
    look: SkeletonLook,
    pose: CameraPose | None,
    size: tuple[int, int],
    *,
    transparent: bool = False,
    share: float | None = None,
) -> Picture:
    """Draw panes into a picture.

    Parameters
    ----------
    panes : sequence of SkeletonPane
        One or two.
    look : SkeletonLook
        How; `text_scale` is the size of text and lines.
    pose : CameraPose or None
        Where the camera stands; None shows the whole model.
    size : (int, int)
        Width and height in pixels.
    transparent : bool
        Leave out the background; the picture composes correctly over any other.
    share : float or None
        Parts two panes, shown as one, at this share of the width.

    Returns
    -------
    (height, width, 3 or 4) uint8 ndarray
        RGB, or RGBA with straight alpha where `transparent`.
    """
    return composed(skeleton_pieces(panes, look, pose, size, transparent=transparent, share=share))


def skeleton_pieces(
    panes: Sequence[SkeletonPane],
    look: SkeletonLook,
    pose: CameraPose | None,
    size: tuple[int, int],
    *,
    transparent: bool = False,
    share: float | None = None,
) -> Iterator[Picture | None]:
    """Draw what :func:`skeleton_picture` composes, one pane a step."""
    with studio(size) as grid:
        grid.part(share)
        grid.show(panes, look, size)
        _aim(grid, pose, size)
        yield from scene_pieces(grid, look.theme, transparent=transparent)


def turn_frames(
    panes: Sequence[SkeletonPane],
    look: SkeletonLook,
    pose: CameraPose | None,
    size: tuple[int, int],
    count: int,
) -> Iterator[Picture]:
    """Yield `count` pictures of one full turn about the direction that is up."""
    with studio(size) as grid:
        grid.set_precise(False, coarse=False)
        grid.show(panes, look, size)
        _aim(grid, pose, size)
        for _ in range(count):
            yield shot(grid, look.theme.ground, look.theme.ground_top)
            grid.camera.Azimuth(360 / count)


def growth_frames(
    panes: Sequence[SkeletonPane],
    look: SkeletonLook,
    pose: CameraPose | None,
    size: tuple[int, int],
) -> Iterator[Picture]:
    """Yield one picture for each band that the graphs grow, figure 5.4."""
    last = max(pane.skeleton.view.resolution for pane in panes if pane.skeleton)
    with studio(size) as grid:
        grid.set_precise(False, coarse=False)
        for step in range(last + 1):
            grown = [replace(pane, step=step, picked=None, note="") for pane in panes]
            grid.show(grown, look, size)
            if step == 0:
                _aim(grid, pose, size)
            yield shot(grid, look.theme.ground, look.theme.ground_top)


@contextmanager
def studio(size: tuple[int, int]) -> Iterator[SkeletonGrid]:
    """A grid to draw pictures of `size` pixels in."""
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=SHAPE, border=False, off_screen=True, window_size=list(size))
    try:
        yield SkeletonGrid(plotter)
    finally:
        plotter.close()


def _aim(grid: SkeletonGrid, pose: CameraPose | None, size: tuple[int, int]) -> None:
    if pose is None:
        grid.look_from(OBLIQUE, size)
    else:
        grid.set_pose(pose)
