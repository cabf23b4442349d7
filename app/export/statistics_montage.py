"""Models and plots of the statistics in a figure, as in figures 3.2–3.7 of the thesis."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

from matplotlib.figure import FigureBase

from app.export.montage_plan import Entry
from app.export.montage_source import SCREEN_DPI, Drawn
from app.export.pictures import Picture, shot, unmix
from app.export.statistics_pictures import models_studio
from app.export.statistics_plots import PLOTS
from app.export.statistics_series import Series
from app.scene.camera import CameraPose
from app.scene.colours import Theme
from app.scene.panes import Look
from app.scene.statistics_scene import ModelPane, StatisticsScene


@dataclass(frozen=True, eq=False)
class StatisticsSource:
    """The pictures that a montage can take from the Statistics tab.

    Attributes
    ----------
    models : tuple of ModelPane
        One model or two.
    look : Look
        How they are drawn.
    series : tuple of Series
        Their statistics.
    pose : CameraPose
        Where the camera stands, beside models in the unit ball.
    """

    models: tuple[ModelPane, ...]
    look: Look
    series: tuple[Series, ...]
    pose: CameraPose

    def entries(self) -> tuple[Entry, ...]:
        """Return what a figure can show."""
        models = [Entry(shown.pane.id, shown.pane.title) for shown in self.models]
        return (*models, *(Entry(spec.id, spec.title) for spec in PLOTS.values()))

    def pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Iterator[Drawn]:  # fmt: skip
        """Draw some of the entries: models into pictures of `size` pixels, plots as they are."""
        models = {shown.pane.id: shown for shown in self.models}
        look = replace(look, text_scale=dpi / SCREEN_DPI)
        with models_studio(size) as scene:
            for id_ in chosen:
                if id_ in models:
                    yield self._model(scene, models[id_], look, size, transparent=transparent)
                else:
                    yield partial(self._plot, id_, look.theme, transparent=transparent)

    def _model(
        self, scene: StatisticsScene, shown: ModelPane, look: Look, size: tuple[int, int],
        *, transparent: bool,
    ) -> Picture:  # fmt: skip
        bare = replace(shown, pane=replace(shown.pane, title="", caption=""))
        scene.show([bare], look, size)
        scene.set_pose(self.pose)
        if not transparent:
            return shot(scene, look.theme.ground, None)
        return unmix(shot(scene, "black", None), shot(scene, "white", None))

    def _plot(self, plot: str, theme: Theme, cell: FigureBase, *, transparent: bool) -> None:
        axes = PLOTS[plot].draw(cell, self.series, replace(theme, panel=theme.ground))
        if transparent:
            cell.set_facecolor("none")
            for each in (axes, *axes.child_axes):
                each.set_facecolor("none")
