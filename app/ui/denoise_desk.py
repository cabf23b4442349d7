"""The Denoise tab as the commands see it."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import ClassVar

from PySide6.QtCore import QPointF

from app.export.montage_panes import Source
from app.export.pictures import Picture, grid_pieces, scaled
from app.scene.comparing import pair
from app.scene.layout import Viewport
from app.scene.swipe import Swipe
from app.ui.desk import IS_ON, STATISTICS_ONLY, Desk, NamedMesh, PictureSubject
from app.ui.screenshot_dialog import Request
from app.ui.value_probe import text_at


class DenoiseDesk(Desk):
    """Panes that flicker, are parted, pictured and saved."""

    lacks: ClassVar[Mapping[str, str]] = {
        "save_graph": IS_ON["Skeleton"],
        "save_film": IS_ON["Skeleton"],
        **dict.fromkeys(STATISTICS_ONLY, IS_ON["Statistics"]),
    }

    @property
    def flickers(self) -> bool:
        return self.tab.flicker is not None

    def set_flicker(self, on: bool) -> None:
        self.tab.set_flicker(on)

    @property
    def swipe_line(self) -> tuple[Viewport, float] | None:
        grid = self.stage.grid
        return (grid.viewports[grid.swipe.left], grid.swipe.share) if grid.swipe else None

    def set_swipe(self, on: bool) -> None:
        grid, view = self.stage.grid, self.session.study.view
        chosen = pair(grid.ids, self.tab.selected, view.compare_with) if on else None
        share = grid.swipe.share if grid.swipe else 0.5
        grid.swipe = Swipe(chosen[1], chosen[0], share) if chosen else None
        self.stage.redraw()

    def move_swipe(self, share: float) -> None:
        grid = self.stage.grid
        grid.swipe = replace(grid.swipe, share=share)
        self.stage.redraw()

    def describe(self, place: QPointF) -> str:
        return text_at(self.stage, place)

    def enlarge(self) -> None:
        self.stage.toggle_enlarged(self.tab.selected or "noisy")

    def mesh(self) -> NamedMesh:
        pane = self.tab.selected or "noisy"
        comparison = self.session.meshes.comparison
        if pane in {"original", "noisy"}:
            return NamedMesh(getattr(comparison, pane), pane)
        run, shown = self.session.run(pane), self.session.shown_iteration(pane)
        return NamedMesh(comparison.noisy.with_vertices(run.vertices(shown)), pane)

    def montage(self) -> Source:
        panes, look = self.tab.panes()
        grid = self.stage.grid
        poses = dict(zip(grid.ids, grid.poses(), strict=False))
        width, height = grid.pane_size(self.stage.pixel_size())
        return Source(tuple(panes), replace(look, text_scale=1.0), poses, width / max(height, 1))

    def subjects(self) -> dict[str, PictureSubject]:
        grid, size = self.stage.grid, self.stage.pixel_size()
        shown = self._pictured_pane()
        port = grid.viewports.get(shown, next(iter(grid.viewports.values())))
        _, _, width, height = port.pixels(*size)
        title = next(pane.title for pane in self.tab.panes()[0] if pane.id == shown)
        return {
            "grid": PictureSubject("All panes", size),
            "pane": PictureSubject(f"Pane: {title}", (round(width), round(height))),
        }

    def picture(self, request: Request, size: tuple[int, int]) -> Iterator[Picture | None]:
        panes, look = self.tab.panes()
        grid = self.stage.grid
        poses, chosen = grid.poses(), grid.enlarged
        if request.subject == "pane":
            chosen = self._pictured_pane()
        if chosen:
            poses = [poses[grid.ids.index(chosen)]]
            panes = [pane for pane in panes if pane.id == chosen]
        pixels = (size[0] * request.scale, size[1] * request.scale)
        look = scaled(look, request.scale)
        return grid_pieces(panes, look, poses, pixels, transparent=request.transparent)

    def _pictured_pane(self) -> str:
        return self.stage.grid.enlarged or self.tab.selected or "noisy"
