"""The plot of the error against the iteration."""

import os

from matplotlib.artist import Artist
from matplotlib.backend_bases import MouseEvent
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QVBoxLayout, QWidget

from app.export.outcomes import session_outcomes
from app.export.plots import draw_errors, error_curves, method_of, save_error_plot
from app.scene.colours import LIGHT, Theme
from app.session import Session
from app.ui.controls import Coalesced
from core.metrics import METRICS

_REDRAW_MS = 60


class ErrorPlot(QWidget):
    """Errors of all methods, with a click on a line to select its method.

    Parameters
    ----------
    session : Session
        The state; the plot listens and pushes studies.
    """

    selected = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._theme = LIGHT
        self._selected: str | None = None
        self._axes = Figure().add_subplot()
        self.canvas = FigureCanvasQTAgg(self._axes.figure)
        self.metric_box = QComboBox()
        self.log_box = QCheckBox("Log scale")
        self._lay_out()
        self._redraw_soon = Coalesced(self._redraw, _REDRAW_MS, self)
        self._connect()
        self._refresh()

    def set_selected(self, method: str | None) -> None:
        """Draw a method's line heavy."""
        self._selected = method
        self._redraw_soon.request()

    def set_theme(self, theme: Theme) -> None:
        """Draw in a theme's colours."""
        self._theme = theme
        self._redraw_soon.request()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Save the plot as PNG, SVG or PDF, dark on white as papers want it.

        Raises
        ------
        SaveError
            If the suffix is another.
        """
        log = self.log_box.isChecked()
        save_error_plot(path, *self._content(), LIGHT, log=log, selected=self._selected)

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
        self.log_box.setToolTip("Logarithmic errors: tells small errors apart beside large ones.")
        row = QHBoxLayout()
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(12)
        row.addWidget(self.metric_box)
        row.addWidget(self.log_box)
        row.addStretch()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(row)
        layout.addWidget(self.canvas, 1)

    def _connect(self) -> None:
        self.metric_box.activated.connect(self._choose_metric)
        self.log_box.toggled.connect(self._redraw_soon.request)
        self.canvas.mpl_connect("button_press_event", self._on_press)
        self.canvas.mpl_connect("motion_notify_event", self._on_motion)
        self._session.study_changed.connect(self._refresh)
        self._session.meshes_changed.connect(self._redraw_soon.request)
        self._session.run_changed.connect(self._redraw_soon.request)

    def _choose_metric(self, index: int) -> None:
        study = self._session.study.model_copy(update={"metric": self.metric_box.itemData(index)})
        self._session.apply(study, "Metric of the plot")

    def _refresh(self, *_: object) -> None:
        metric = METRICS[self._session.study.metric]
        with QSignalBlocker(self.metric_box):
            self.metric_box.setCurrentIndex(self.metric_box.findData(metric.id))
        self.metric_box.setToolTip(metric.summary)
        self._redraw_soon.request()

    def _content(self) -> tuple:
        """Return curves, error of the noisy input and metric."""
        metric = METRICS[self._session.study.metric]
        meshes = self._session.meshes
        noisy = meshes.comparison.noisy_errors[metric.id] if meshes else None
        return error_curves(session_outcomes(self._session), metric.id), noisy, metric

    def _redraw(self) -> None:
        if not self.isVisible():
            return
        log = self.log_box.isChecked()
        draw_errors(self._axes, *self._content(), self._theme, log=log, selected=self._selected)
        self.canvas.draw_idle()

    def _on_press(self, event: MouseEvent) -> None:
        method = self._method_at(event)
        if method:
            self.selected.emit(method)

    def _on_motion(self, event: MouseEvent) -> None:
        over = self._method_at(event) is not None
        shape = Qt.CursorShape.PointingHandCursor if over else Qt.CursorShape.ArrowCursor
        self.canvas.setCursor(shape)

    def _method_at(self, event: MouseEvent) -> str | None:
        """Return the method of the topmost artist under the pointer."""
        artists = [*self._axes.lines, *self._axes.texts]
        hit = [artist for artist in artists if method_of(artist) and artist.contains(event)[0]]
        return method_of(max(hit, key=Artist.get_zorder)) if hit else None
