"""The Skeleton tab as the commands see it."""

from collections.abc import Iterator, Mapping
from typing import ClassVar

from PySide6.QtCore import QPointF

from app.export.pictures import Picture
from app.export.skeleton_montage import SkeletonSource, figure_panes
from app.export.skeleton_pictures import skeleton_pieces
from app.scene.layout import Viewport
from app.scene.skeleton_probe import SurfaceProbe, node_line, sight_line, surface_text
from app.ui.desk import IS_ON, STATISTICS_ONLY, Desk, NamedMesh, PictureSubject
from app.ui.screenshot_dialog import Request
from app.ui.stage import share_of

_ONE_VIEW = "Check “Compare two views” first."
_WHOLE = Viewport(0.0, 0.0, 1.0, 1.0)


class SkeletonDesk(Desk):
    """Two views that flicker, are parted, pictured and saved."""

    lacks: ClassVar[Mapping[str, str]] = {
        "smooth_shading": "Surfaces of skeletal graphs are always smooth.",
        "edges": "Level curves stand in place of edges here.",
        "link": "The views of this tab always move together.",
        "enlarge": "Uncheck “Compare two views” to see one of them larger.",
        "difference": IS_ON["Denoise"],
        "colour_bar": IS_ON["Denoise"],
        "colour": "The field colours the surfaces of this tab.",
        "compare": "The views of this tab are compared with each other.",
        "save_plot": "This is on the Denoise and the Statistics tab.",
        "save_table": "This is on the Denoise and the Statistics tab.",
        "copy_table": IS_ON["Denoise"],
        **dict.fromkeys(STATISTICS_ONLY, IS_ON["Statistics"]),
    }

    def __init__(self, tab: object, stage: object) -> None:
        super().__init__(tab, stage)
        self._probe = SurfaceProbe()
        self.tab.views.changed.connect(lambda _: self.changed.emit())

    def obstacle(self, command: str) -> str:
        views = self.tab.views
        if command in {"flicker", "swipe"} and len(views.shown) < 2:
            return _ONE_VIEW
        if command in {"save_graph", "save_mesh"} and views.skeleton(self.tab.selected) is None:
            return "The selected view has no graph yet."
        if command in {"figure", "save_film"} and not any(map(views.skeleton, views.shown)):
            return "There is no graph yet."
        return super().obstacle(command)

    @property
    def flickers(self) -> bool:
        return self.tab.flickers

    def set_flicker(self, on: bool) -> None:
        self.tab.set_flicker(on)

    @property
    def swipe_line(self) -> tuple[Viewport, float] | None:
        share = self.stage.grid.share
        return None if share is None else (_WHOLE, share)

    def set_swipe(self, on: bool) -> None:
        before = self.stage.grid.share
        self.stage.part((before or 0.5) if on and len(self.tab.views.shown) > 1 else None)

    def move_swipe(self, share: float) -> None:
        self.stage.part(share)

    def describe(self, place: QPointF) -> str:
        grid = self.stage.grid
        x, y = share_of(self.stage, place)
        number = grid.pane_at(x, y)
        if number is None or number >= len(self.stage.panes):
            return ""
        pane = self.stage.panes[number]
        node = grid.node_at(number, x, y, self.stage.pixel_size())
        if node is not None:
            return node_line(pane, node)
        if pane.skeleton is None or not self.session.study.skeleton.opacity:
            return ""
        found = self._probe.find(pane.skeleton.mesh, *self._sight(number, x, y, pane.centre))
        return surface_text(pane.skeleton, found) if found else ""

    def mesh(self) -> NamedMesh:
        skeleton = self.tab.views.skeleton(self.tab.selected)
        return NamedMesh(skeleton.mesh, skeleton.view.source)

    def montage(self) -> SkeletonSource:
        panes, look = self.tab.panes(1.0)
        width, height = self.stage.pixel_size()
        views = 1 if self.stage.grid.share is not None else max(len(panes), 1)
        aspect = width / views / max(height, 1)
        return SkeletonSource(figure_panes(panes, look), look.theme, self.stage.pose, aspect)

    def subjects(self) -> dict[str, PictureSubject]:
        width, height = size = self.stage.pixel_size()
        if len(self.tab.views.shown) < 2:
            return {"grid": PictureSubject("The view", size)}
        return {
            "grid": PictureSubject("Both views", size),
            "pane": PictureSubject("The selected view", (width // 2, height)),
        }

    def picture(self, request: Request, size: tuple[int, int]) -> Iterator[Picture | None]:
        panes, look = self.tab.panes(request.scale * self.tab.devicePixelRatioF())
        if request.subject == "pane" and len(panes) > 1:
            panes = [panes[self.tab.views.shown.index(self.tab.selected)]]
        pixels = (size[0] * request.scale, size[1] * request.scale)
        return skeleton_pieces(
            panes, self.tab.without_frame(look), self.stage.pose, pixels,
            transparent=request.transparent,
            share=self.stage.grid.share if len(panes) > 1 else None,
        )  # fmt: skip

    def _sight(self, number: int, x: float, y: float, centre: object) -> list[object]:
        """Ends of what is seen at a point, in the coordinates of the mesh."""
        port = self.stage.grid.viewports[number]
        width, height = port.pixels(*self.stage.pixel_size())[2:]
        across = 2 * (x - port.left) / (port.right - port.left) - 1
        up = 2 * (y - port.bottom) / (port.top - port.bottom) - 1
        camera = self.stage.grid.renderer(number).GetActiveCamera()
        return [end + centre for end in sight_line(camera, across, up, width / max(height, 1))]
