"""The plot of the error against the iteration."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from matplotlib.figure import Figure
from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QVBoxLayout, QWidget

from app.export.chart import ErrorChart
from app.export.outcomes import session_outcomes
from app.export.plots import error_curves, save_error_plot
from app.scene.colours import LIGHT, Theme
from app.session import Session
from app.ui.controls import Coalesced
from app.ui.help import HelpButton
from app.ui.plot_canvas import PlotCanvas
from app.ui.turns import Turns, Work
from core.metrics import METRICS
from core.study import Study

_REDRAW_MS = 60


class ErrorPlot(QWidget):
    """Errors of all methods, with a click on a line to select its method.

    Parameters
    ----------
    session : Session
        The state; the plot listens and pushes studies.
    turns : Turns or None
        In which it draws; None for turns of its own.
    """

    selected = Signal(str)

    def __init__(self, session: Session, turns: Turns | None = None) -> None:
        super().__init__()
        self._session = session
        self._theme = LIGHT
        self._selected: str | None = None
        self.canvas = PlotCanvas()
        self.metric_box = QComboBox()
        self.help = HelpButton(self.metric_box.currentData, "Reference of this metric")
        # The methods' errors often lie decades apart, and the smallest matter most.
        self.log_box = QCheckBox("Log scale", checked=True)
        self.units_box = QCheckBox("Model units")
        self._lay_out()
        self._redrawing = Work(turns or Turns(self), self._redraw)
        self._redraw_soon = Coalesced(self._redrawing.request, _REDRAW_MS, self)
        self._connect()
        self._refresh()

    @property
    def figure(self) -> Figure:
        """Figure that the window shows."""
        return self.canvas.figure

    def set_selected(self, method: str | None) -> None:
        """Draw a method's line heavy."""
        self._selected = method
        self._redraw_soon.request()

    def set_theme(self, theme: Theme) -> None:
        """Draw in a theme's colours."""
        self._theme = theme
        self._redraw_soon.request()

    def writer(self) -> Callable[[Path], None]:
        """Return what saves the plot of now as PNG, SVG or PDF, dark on white as papers want it."""
        c = self._chart(LIGHT)
        return partial(
            save_error_plot, curves=c.curves, noisy_value=c.noisy_value, metric=c.metric,
            theme=c.theme, log=c.log, selected=c.selected,
        )  # fmt: skip

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._redraw_soon.request()

    def sizeHint(self) -> QSize:
        return QSize(640, 220)

    def minimumSizeHint(self) -> QSize:
        return QSize(340, 160)

    def _lay_out(self) -> None:
        for id_, spec in METRICS.items():
            self.metric_box.addItem(spec.title, id_)
            tip = f"{spec.summary}\n{spec.formula}\n{spec.reference}"
            self.metric_box.setItemData(
                self.metric_box.count() - 1, tip, Qt.ItemDataRole.ToolTipRole
            )
        self.metric_box.setAccessibleName("Metric of the plot")
        self.units_box.setToolTip(
            "Errors in the file's own units and origin, as printed, instead of mean edge lengths."
        )
        self.log_box.setToolTip("Logarithmic errors: tells small errors apart beside large ones.")
        row = QHBoxLayout()
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(12)
        row.addWidget(self.metric_box)
        row.addWidget(self.help)
        row.addWidget(self.log_box)
        row.addWidget(self.units_box)
        row.addStretch()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(row)
        layout.addWidget(self.canvas, 1)

    def _connect(self) -> None:
        self.metric_box.activated.connect(self._choose_metric)
        self.log_box.toggled.connect(self._redraw_soon.request)
        self.units_box.toggled.connect(self._choose_units)
        self.canvas.pressed.connect(self.selected)
        self._session.study_changed.connect(self._on_study_changed)
        self._session.meshes_changed.connect(self._redraw_soon.request)
        self._session.run_changed.connect(self._redraw_soon.request)

    def _choose_metric(self, index: int) -> None:
        study = self._session.study.model_copy(update={"metric": self.metric_box.itemData(index)})
        self._session.apply(study, "Metric of the plot")

    def _choose_units(self, model_units: bool) -> None:
        study = self._session.study.model_copy(update={"model_units": model_units})
        self._session.apply(study, "Units of the errors")

    def _on_study_changed(self, study: Study, before: Study) -> None:
        if not study.compares_like(before):
            self._refresh()

    def _refresh(self) -> None:
        metric = self._session.study.metrics[self._session.study.metric]
        with QSignalBlocker(self.metric_box):
            self.metric_box.setCurrentIndex(self.metric_box.findData(metric.id))
        self.metric_box.setToolTip(metric.summary)
        with QSignalBlocker(self.units_box):
            self.units_box.setChecked(self._session.study.model_units)
        self._redraw_soon.request()

    def _chart(self, theme: Theme) -> ErrorChart:
        """Gather what the study and its results say."""
        metric = self._session.study.metrics[self._session.study.metric]
        meshes = self._session.meshes
        return ErrorChart(
            curves=error_curves(session_outcomes(self._session), metric.id),
            noisy_value=meshes.comparison.noisy_errors[metric.id] if meshes else None,
            metric=metric,
            theme=theme,
            log=self.log_box.isChecked(),
            selected=self._selected,
            reach=self._reach(),
        )

    def _reach(self) -> int:
        """Last iteration that is asked for and will come."""
        wanted = [choice for choice in self._session.study.methods if choice.enabled]
        runs = [(choice.iterations, self._session.run(choice.method)) for choice in wanted]
        return max((count for count, run in runs if not (run and run.diverged)), default=1)

    def _redraw(self) -> Iterator[None]:
        if self.isVisible() and self._session.meshes:
            yield from self.canvas.show_chart(self._chart(self._theme))
