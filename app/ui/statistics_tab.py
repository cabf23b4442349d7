"""The Statistics tab: the model and the five plots of thesis figures 3.2–3.7."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QWidget

from app.export.statistics_plots import PLOTS
from app.export.statistics_series import SERIES_COLOURS, Series
from app.scene.colours import Theme
from app.scene.statistics_panes import PaneMaker, ShownModel, colour_look
from app.session import Session
from app.ui.controls import Coalesced
from app.ui.dialogs import ask_for_file
from app.ui.statistics_desk import StatisticsDesk
from app.ui.statistics_lights import StatisticsLights
from app.ui.statistics_matrix import MatrixCell
from app.ui.statistics_plot import Cell, StatisticsPlot
from app.ui.statistics_saving import ask_for_cell, copy_numbers
from app.ui.statistics_second import OPEN, SecondModel
from app.ui.statistics_side import WIDTH, StatisticsSide
from app.ui.statistics_tools import TOOLS, remesh
from app.ui.statistics_view import StatisticsView
from app.ui.statistics_work import Model, StatisticsWork
from core.arrays import FloatArray
from core.study import Study

_REDRAW_MS = 80
_REFRESH_MS = 250
_COLOUR_TITLES = {
    "degree": "degree",
    "assortativity": "K_nn",
    "clustering": "clustering",
    "distance": "distance\n(ℓ̄)",
}


class StatisticsTab(QWidget):
    """Chapter 3 of the thesis on one screen, for one model or two.

    Nothing is computed before the tab is shown.

    Parameters
    ----------
    session : Session
        The state; the tab listens to its meshes and runs.
    theme : Theme
        Colours to begin with.
    """

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self.session = session
        self.enlarged: str | None = None
        self._theme = theme
        self._pane_maker = PaneMaker()
        self.work = StatisticsWork(session.jobs, session.report)
        self.second = SecondModel(session, self)
        self.side = StatisticsSide()
        self.view = StatisticsView()
        self.plots = {spec.id: StatisticsPlot(spec) for spec in PLOTS.values()}
        self.matrix = MatrixCell()
        self.cells: dict[str, Cell] = {**self.plots, "matrix": self.matrix}
        self.lights = StatisticsLights(self.work, self.view, self.plots)
        self.desk = StatisticsDesk(self, self.view)
        self._redraw_soon = Coalesced(self._redraw, _REDRAW_MS, self)
        self._refresh_soon = Coalesced(self._refresh, _REFRESH_MS, self)
        self._fill_tools()
        self._lay_out()
        self._connect()
        self.set_theme(theme)

    @property
    def theme(self) -> Theme:
        """Colours of the plots."""
        return self._theme

    def set_theme(self, theme: Theme) -> None:
        """Draw everything in a theme's colours."""
        self._theme = theme
        self.view.set_ground(theme)
        self._redraw_soon.request()

    def save_layout(self) -> None:
        """Nothing to remember: the places are fixed."""

    def close_graphics(self) -> None:
        """Release the graphics before the window goes."""
        self._redraw_soon.stop()
        self._refresh_soon.stop()
        self.desk.gestures.stop()
        self.view.close_interactor()

    def enlarge(self, cell: str) -> None:
        """Give a plot all the room beside the model, or bring all back."""
        self.enlarged = None if self.enlarged == cell else cell
        self._place_cells()
        self._redraw_soon.request()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        settings = self.session.study.statistics
        self.work.set_params(settings.geodesic_params, settings.spectrum_params)
        self._refresh_soon.request()
        self._redraw_soon.request()

    def _fill_tools(self) -> None:
        menu = self.side.tools.menu()
        menu.addAction("Matrix beside the model").triggered.connect(lambda: self.enlarge("matrix"))
        menu.addSeparator()
        for tool, (title, _) in TOOLS.items():
            menu.addAction(title).triggered.connect(
                lambda *_, tool=tool: remesh(self.session, tool)
            )

    def _lay_out(self) -> None:
        self.side.setFixedWidth(WIDTH)
        self._grid = QGridLayout()
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setSpacing(4)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 4, 0)
        layout.setSpacing(4)
        layout.addWidget(self.side)
        layout.addLayout(self._grid, 1)
        # In no layout until it is enlarged: without a parent it would open as a window.
        self.matrix.setParent(self)
        self._place_cells()

    def _place_cells(self) -> None:
        """Put model and plots into two rows of three, or an enlarged cell beside the model."""
        for widget in (self.view, *self.cells.values()):
            self._grid.removeWidget(widget)
        big = self.cells.get(self.enlarged or "")
        for cell in self.cells.values():
            cell.setVisible(cell is big if big else cell is not self.matrix)
        for i in range(3):
            self._grid.setColumnStretch(i, 1)
        self._grid.setRowStretch(0, 1)
        self._grid.setRowStretch(1, 1)
        if big:
            self._grid.addWidget(self.view, 0, 0, 2, 1)
            self._grid.addWidget(big, 0, 1, 2, 2)
            return
        for place, widget in enumerate((self.view, *self.plots.values())):
            self._grid.addWidget(widget, *divmod(place, 3))

    def _connect(self) -> None:
        session, side = self.session, self.side
        session.meshes_changed.connect(self._refresh_soon.request)
        session.run_changed.connect(self._on_run_changed)
        session.study_changed.connect(self._on_study_changed)
        self.work.changed.connect(self._redraw_soon.request)
        self.work.activity_changed.connect(self._show_activity)
        self.second.changed.connect(self._refresh)
        side.second_chosen.connect(self._choose_second)
        side.changed.connect(self._on_side_changed)
        side.resumed.connect(lambda: self.work.start(again=True))
        self.view.picked.connect(self._pick)
        for cell in self.cells.values():
            cell.enlarge_asked.connect(self.enlarge)
            cell.save_asked.connect(lambda cell: ask_for_cell(self, cell))
            cell.copy_asked.connect(lambda plot: copy_numbers(self, plot))
        for plot in self.plots.values():
            plot.pointed.connect(self.lights.point)

    # -- what is on show

    def _refresh(self) -> None:
        """Take the meshes of the session and of the second model; only while they are seen."""
        if not self.isVisible() or self.session.meshes is None:
            return
        meshes = self.session.meshes
        models = [Model(Path(meshes.name).stem, meshes.comparison.original)]
        second = self.second.model()
        models += [second] if second else []
        self.side.offer_second(self.second.choices(), self.second.chosen)
        self.work.show(tuple(models))

    def _redraw(self) -> None:
        if not self.isVisible():
            return
        series = self.work.series()
        for plot in self.plots.values():
            plot.show_series(series, self._theme)
        self.side.show_summaries(self.work.summaries())
        self._draw_models(series)
        if self.enlarged == "matrix" and self.work.models:
            self.matrix.show_mesh(self.work.models[0].mesh, self._theme)

    def _draw_models(self, series: list[Series]) -> None:
        colour = self.side.colour.currentData()
        models = [
            ShownModel(model.name, SERIES_COLOURS[place], model.mesh, self._values(place, series))
            for place, model in enumerate(self.work.models)
        ]
        title = _COLOUR_TITLES.get(colour, "")
        look = colour_look(models, title, self._theme, self.devicePixelRatioF())
        seen = self.session.study.view
        look = replace(look, smooth=seen.smooth_shading, edges=seen.edges)
        self.view.show_models(self._pane_maker.panes(models), look)
        self.lights.show()

    def _values(self, place: int, series: list[Series]) -> FloatArray | None:
        """What colours the vertices of a model."""
        colour = self.side.colour.currentData()
        if colour == "distance":
            return self.work.distances(place)
        return series[place].vertex_values(colour) if place < len(series) else None

    def _show_activity(self) -> None:
        self.side.show_activity(self.work.activity, cancelled=self.work.cancelled)

    # -- what the user does

    def _choose_second(self, id_: str) -> None:
        if id_ == OPEN:
            self.side.offer_second(self.second.choices(), self.second.chosen)
            ask_for_file(self, "Open a second model", lambda path: self.second.choose(str(path)))
        else:
            self.second.choose(id_)

    def _on_side_changed(self, step: str) -> None:
        study = self.session.study
        settings = study.statistics.model_copy(update=self.side.settings())
        self.session.apply(study.model_copy(update={"statistics": settings}), step)

    def _on_study_changed(self, study: Study, before: Study) -> None:
        self._refresh_soon.request()
        if study.view != before.view:
            self._redraw_soon.request()
        if study.statistics == before.statistics:
            return
        settings = study.statistics
        self.side.show_settings(settings)
        self.work.relative = settings.relative
        if self.isVisible():
            self.work.set_params(settings.geodesic_params, settings.spectrum_params)
        self._redraw_soon.request()

    def _on_run_changed(self, method: str) -> None:
        if self.second.chosen.endswith(method):
            self._refresh_soon.request()

    def _pick(self, model: int, vertex: int) -> None:
        """Measure from a vertex, and show it where the model has no other colours."""
        # What was clicked may have been drawn before the models changed, or flicker in its place.
        meshes = [one.mesh for one in self.work.models]
        if model >= len(meshes) or self.view.shown[model].topology is not meshes[model].topology:
            return
        self.work.pick(model, vertex)
        if self.side.colour.currentData() == "none":
            self.side.colour.setCurrentIndex(self.side.colour.findData("distance"))
