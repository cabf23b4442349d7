"""The Statistics tab as the commands see it."""

from collections.abc import Iterator, Mapping
from typing import ClassVar

from PySide6.QtCore import QPointF

from app.export.pictures import Picture
from app.export.statistics_montage import StatisticsSource
from app.export.statistics_pictures import models_pieces
from app.export.statistics_words import vertex_words
from app.scene.layout import Viewport
from app.ui.desk import IS_ON, STATISTICS_ONLY, Desk, NamedMesh, PictureSubject
from app.ui.screenshot_dialog import Request
from app.ui.stage import share_of
from app.ui.value_probe import point_under

_ONE_MODEL = "Choose a second model first."


class StatisticsDesk(Desk):
    """One model or two with their plots."""

    lacks: ClassVar[Mapping[str, str]] = {
        "link": "The models of this tab always move together.",
        "difference": IS_ON["Denoise"],
        "colour_bar": IS_ON["Denoise"],
        "colour": "“Colour the model by” in the panel of this tab has its own choices.",
        "compare": IS_ON["Denoise"],
        "copy_table": "Each plot of this tab has a button that copies its numbers.",
        "save_graph": IS_ON["Skeleton"],
        "save_film": IS_ON["Skeleton"],
    }

    def __init__(self, tab: object, stage: object) -> None:
        super().__init__(tab, stage)
        self.tab.work.changed.connect(self.changed.emit)

    def obstacle(self, command: str) -> str:
        work = self.tab.work
        if command in {"flicker", "swipe"} and len(work.models) < 2:
            return _ONE_MODEL
        saves = {"save_plot", "save_table", "figure", "screenshot", "save_mesh", *STATISTICS_ONLY}
        if command in saves and not work.summaries():
            return "There are no numbers yet."
        return super().obstacle(command)

    @property
    def flickers(self) -> bool:
        return self.stage.flickers

    def set_flicker(self, on: bool) -> None:
        self.stage.set_flicker(on and len(self.tab.work.models) > 1)

    @property
    def swipe_line(self) -> tuple[Viewport, float] | None:
        scene = self.stage.scene
        if scene.share is None:
            return None
        return Viewport(0.0, 0.0, scene.viewports[-1].right, 1.0), scene.share

    def set_swipe(self, on: bool) -> None:
        before = self.stage.scene.share
        self.stage.part((before or 0.5) if on and len(self.stage.panes) > 1 else None)

    def move_swipe(self, share: float) -> None:
        self.stage.part(share)

    def describe(self, place: QPointF) -> str:
        model = self.stage.scene.model_at(*share_of(self.stage, place))
        series = self.tab.work.series()
        point = point_under(self.stage, place)
        if model is None or point is None:
            return ""
        vertex = self.stage.scene.nearest_vertex(model, point)
        number = 1 - model if self.flickers else model
        if number >= len(series):
            return ""
        return vertex_words(series[number], vertex, self.tab.work.distances(number))

    def enlarge(self) -> None:
        under = (id_ for id_, cell in self.tab.cells.items() if cell.underMouse())
        self.tab.enlarge(self.tab.enlarged or next(under, next(iter(self.tab.plots))))

    def mesh(self) -> NamedMesh:
        return NamedMesh(self.tab.work.models[0].mesh, "model")

    def montage(self) -> StatisticsSource:
        return StatisticsSource(
            tuple(self.stage.panes), self.stage.look, tuple(self.tab.work.series()),
            self.stage.scene.pose,
        )  # fmt: skip

    def subjects(self) -> dict[str, PictureSubject]:
        name = "Both models" if len(self.stage.panes) > 1 else "The model"
        return {"grid": PictureSubject(name, self.stage.interactor.pixel_size())}

    def picture(self, request: Request, size: tuple[int, int]) -> Iterator[Picture | None]:
        pixels = (size[0] * request.scale, size[1] * request.scale)
        scene = self.stage.scene
        return models_pieces(
            tuple(self.stage.shown), self.stage.look, scene.pose, pixels, scale=request.scale,
            transparent=request.transparent, share=scene.share,
        )  # fmt: skip
