"""Pictures and films of skeletal graphs without a window."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace

import pyvista as pv

from app.export.pictures import Picture, prefer_headless_graphics, unmix
from app.scene.camera import CameraPose
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
    with studio(size) as grid:
        grid.part(share)
        grid.show(panes, look, size)
        _aim(grid, pose, size)
        if not transparent:
            return skeleton_shot(grid, look.theme.ground, look.theme.ground_top)
        return unmix(skeleton_shot(grid, "black", None), skeleton_shot(grid, "white", None))


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
            yield skeleton_shot(grid, look.theme.ground, look.theme.ground_top)
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
            yield skeleton_shot(grid, look.theme.ground, look.theme.ground_top)


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
        grid.look_from("Oblique", size)
    else:
        grid.set_pose(pose)


def skeleton_shot(grid: SkeletonGrid, bottom: str, top: str | None) -> Picture:
    """Picture a grid on a ground."""
    grid.set_ground(bottom, top)
    grid.fit_clipping()
    grid.plotter.render()
    picture: Picture = grid.plotter.screenshot(return_img=True)
    return picture[..., :3]
