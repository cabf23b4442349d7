"""Panes of meshes in a figure, as in figure 2.10 of the thesis."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import pyvista as pv

from app.export.montage_plan import Entry
from app.export.montage_source import SCREEN_DPI
from app.export.pictures import Picture, prefer_headless_graphics, shot, unmix
from app.scene.camera import CameraPose
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane


@dataclass(frozen=True, eq=False)
class Source:
    """The panes a montage takes its pictures from.

    Attributes
    ----------
    panes : tuple of Pane
        All panes there are.
    look : Look
        How they are drawn.
    poses : dict of str to CameraPose, or None
        The camera of each pane by its id; None shows the whole models.
    aspect : float
        Width over height of the view the poses were set in; as much is seen in every picture.
    """

    panes: tuple[Pane, ...]
    look: Look
    poses: dict[str, CameraPose] | None = None
    aspect: float = 1.0

    def entries(self) -> tuple[Entry, ...]:
        """Return what a figure can show."""
        return tuple(Entry(pane.id, pane.title) for pane in self.panes)

    def pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Iterator[Picture]:  # fmt: skip
        """Draw panes, each alone and without its text, into pictures of one size."""
        prefer_headless_graphics()
        panes = {pane.id: pane for pane in self.panes}
        plotter = pv.Plotter(
            shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(size)
        )
        try:
            grid = PaneGrid(plotter)
            look = replace(look, text_scale=dpi / SCREEN_DPI)
            for id_ in chosen:
                yield self._picture(grid, panes[id_], look, size, transparent=transparent)
        finally:
            plotter.close()

    def _picture(
        self, grid: PaneGrid, pane: Pane, look: Look, size: tuple[int, int], *, transparent: bool
    ) -> Picture:
        grid.show([replace(pane, title="", caption="")], look, size)
        self._aim(grid, pane.id, size[0] / size[1])
        if not transparent:
            return shot(grid, look.theme.ground, None)
        return unmix(shot(grid, "black", None), shot(grid, "white", None))

    def _aim(self, grid: PaneGrid, pane: str, aspect: float) -> None:
        """Show as much as the window does, also where the picture is narrower than the pane."""
        camera = grid.renderer(pane).GetActiveCamera()
        camera.SetViewAngle(30.0)
        if self.poses is None:
            grid.look_from("Oblique")
            return
        grid.set_poses([self.poses[pane]])
        if aspect < self.aspect:
            half = np.tan(np.radians(15.0)) * self.aspect / aspect
            camera.SetViewAngle(2 * np.degrees(np.arctan(half)))
