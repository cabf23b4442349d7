"""One plot of the statistics: canvas, title, buttons, and a line that says how to read it."""

from collections.abc import Sequence
from typing import Any

from matplotlib.artist import Artist
from matplotlib.backend_bases import DrawEvent, MouseEvent
from matplotlib.figure import Figure
from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from app.export.statistics_axes import say_pending
from app.export.statistics_plots import PlotSpec
from app.export.statistics_selection import Selection, Spot
from app.export.statistics_series import Series
from app.export.statistics_words import plot_words
from app.scene.colours import LIGHT, Theme
from app.ui.controls import Coalesced, FaintLabel, IconButton
from app.ui.figure_canvas import FigureCanvas
from app.ui.help import HelpButton

_REDRAW_MS = 60
_LINES = 3


class Cell(QWidget):
    """A titled box with a canvas, buttons to enlarge, save and copy, and a line of words."""

    enlarge_asked = Signal(str)
    save_asked = Signal(str)
    copy_asked = Signal(str)

    def __init__(self, id_: str, title: str) -> None:
        super().__init__()
        self.id = id_
        self.canvas = FigureCanvas(Figure(layout="constrained"))
        self.canvas.setMinimumSize(120, 90)
        self.canvas.installEventFilter(self)
        self.words = FaintLabel()
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.words.setFixedHeight(_LINES * self.words.fontMetrics().lineSpacing() + 2)
        self.enlarge = IconButton("mdi6.arrow-expand", "Enlarge the plot, or bring all back")
        self.save = IconButton("mdi6.content-save-outline", "Save the plot as SVG, PDF or PNG")
        self.copy = IconButton("mdi6.content-copy", "Copy the numbers")
        self._title = QLabel(f"<b>{title}</b>")
        self._lay_out()
        for button, signal in (
            (self.enlarge, self.enlarge_asked),
            (self.save, self.save_asked),
            (self.copy, self.copy_asked),
        ):
            button.clicked.connect(lambda *_, signal=signal: signal.emit(self.id))

    def sizeHint(self) -> QSize:
        return QSize(320, 270)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.MouseButtonDblClick:
            self.enlarge_asked.emit(self.id)
        return False

    def _lay_out(self) -> None:
        self.head = QHBoxLayout()
        self.head.setContentsMargins(8, 0, 2, 0)
        self.head.setSpacing(0)
        self.head.addWidget(self._title)
        self.head.addStretch()
        for button in (self.enlarge, self.save, self.copy):
            self.head.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2, 2, 2, 2)
        layout.setSpacing(2)
        layout.addLayout(self.head)
        layout.addWidget(self.canvas, 1)
        row = QHBoxLayout()
        row.setContentsMargins(8, 0, 6, 2)
        row.addWidget(self.words)
        layout.addLayout(row)

    def _say(self, text: str) -> None:
        self.words.setText(text)
        self.words.setToolTip(text)


class StatisticsPlot(Cell):
    """Shows a plot of one model or two; what the pointer is over is marked, drawn without delay."""

    pointed = Signal(object)

    def __init__(self, spec: PlotSpec) -> None:
        super().__init__(spec.id, spec.title)
        self.spec = spec
        self.head.insertWidget(1, HelpButton(lambda: spec.id, f"Reference: {spec.title}"))
        self.series: list[Series] = []
        self._theme = LIGHT
        self._is_made = False
        self._axes: Any = None
        self._background: Any = None
        self._mark: Artist | None = None
        self._redraw_soon = Coalesced(self._redraw, _REDRAW_MS, self)
        self.canvas.mpl_connect("draw_event", self._on_draw)
        self.canvas.mpl_connect("motion_notify_event", self._on_motion)

    def show_series(self, series: Sequence[Series], theme: Theme) -> None:
        """Draw models in a theme's colours."""
        same = theme is self._theme and self._shown(self.series) == self._shown(series)
        self.series, self._theme = list(series), theme
        if not (same and self._is_made):
            self._say(plot_words(self.id, self.series))
            self._redraw_soon.request()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self.pointed.emit(None)
        return super().eventFilter(watched, event)

    def mark(self, selection: Selection, *, beside: bool) -> None:
        """Mark what is selected, and say what it is."""
        self._say(selection.words or plot_words(self.id, self.series))
        if self._mark is not None:
            self._mark.remove()
            self._mark = None
        if selection.span and self._axes is not None:
            style = {"color": self._theme.ink, "alpha": 0.18, "lw": 0, "animated": True}
            if beside and self._axes.child_axes:
                self._mark = self._axes.child_axes[0].axhspan(*selection.span, **style)
            else:
                self._mark = self._axes.axvspan(*selection.span, **style)
        self._draw_mark()

    def _shown(self, series: Sequence[Series]) -> list[Any]:
        """Objects that the plot is made of: equal ones make the same plot."""
        names = [(one.name, one.colour, one.relative, one.refusals.get(self.id)) for one in series]
        return [*names, *(id(self._part(one)) for one in series)]

    def _part(self, one: Series) -> Any:
        """What of a model the plot is made of; None while it is being computed, or was refused."""
        parts = {"spectrum": one.spectrum, "geodesic": one.geodesic}
        return parts.get(self.id, one.connectivity)

    def _redraw(self) -> None:
        self._mark, self._is_made = None, True
        with self.canvas.making():
            if any(self._part(one) or self.id in one.refusals for one in self.series):
                self._axes = self.spec.draw(self.canvas.figure, self.series, self._theme)
            else:
                self._axes = None
                say_pending(self.canvas.figure, self._theme)
        self.canvas.draw_idle()

    def _on_draw(self, _: DrawEvent) -> None:
        self._background = self.canvas.copy_from_bbox(self.canvas.figure.bbox)
        if self._mark is not None:
            self._mark.axes.draw_artist(self._mark)

    def _draw_mark(self) -> None:
        if self._background is None:
            return
        self.canvas.restore_region(self._background)
        if self._mark is not None:
            self._mark.axes.draw_artist(self._mark)
        self.canvas.update()

    def _on_motion(self, event: MouseEvent) -> None:
        self.pointed.emit(self._spot(event.x, event.y) if self._axes and self.series else None)

    def _spot(self, x: float, y: float) -> Spot | None:
        """Place on the scales of the axes that hold a point; matplotlib passes inner ones over."""
        for axes in (*self._axes.child_axes, self._axes):
            if axes.bbox.contains(x, y):
                place = axes.transData.inverted().transform((x, y))
                return Spot(self.id, float(place[0]), float(place[1]), axes is not self._axes)
        return None
