"""A matplotlib canvas that draws only the curves anew while their frame stays the same."""

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from matplotlib.artist import Artist
from matplotlib.backend_bases import DrawEvent, MouseEvent
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.figure import Figure
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent

from app.export.chart import ErrorChart, draw_curves, method_of
from app.export.frame import Frame, draw_frame
from app.ui.figure_canvas import FigureCanvas


class PlotCanvas(FigureCanvas):
    """Shows an error chart; `pressed` carries the method of the line or label under the pointer."""

    pressed = Signal(str)

    def __init__(self) -> None:
        self._frame: Frame | None = None
        self.axes = Figure().add_subplot()
        super().__init__(self.axes.figure)
        self._curves: list[Artist] = []
        self._background: Any = None
        self.mpl_connect("draw_event", self._on_draw)
        self.mpl_connect("button_press_event", self._on_press)
        self.mpl_connect("motion_notify_event", self._on_motion)

    def show_chart(self, chart: ErrorChart) -> Iterator[None]:
        """Draw a chart in steps: all of it, or where the frame is as before only the curves."""
        if self.words:  # what was half drawn is no ground to draw on
            self._frame = None
        redraws_all = chart.frame != self._frame or self._background is None
        with self.making():
            self._change(chart, redraws_all=redraws_all)
        if redraws_all and not self.words:
            yield from self._draw_frame()
        if self.words or self._background is None:
            self.draw_idle()  # at once: it failed, or the size is another by now
        else:
            self._draw_curves()
            self.update()

    def _change(self, chart: ErrorChart, *, redraws_all: bool) -> None:
        """Exchange the artists for those of a chart."""
        if redraws_all:
            draw_frame(self.axes, chart.frame)
        else:
            for artist in self._curves:
                artist.remove()
        self._frame = chart.frame
        self._curves = draw_curves(self.axes, chart)
        for artist in self._curves:
            artist.set_animated(True)

    def draw(self) -> None:
        """Draw the chart; an empty canvas is not worth the time that the window opens later."""
        if self._frame is not None:
            super().draw()

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._frame is None:  # Qt leaves the ground of a canvas black
            painter = QPainter(self)
            painter.fillRect(self.rect(), self.palette().window())
            painter.end()
        super().paintEvent(event)

    def _on_draw(self, _: DrawEvent) -> None:
        """Keep the frame, which has just been drawn without the curves, and add them."""
        self._background = self.copy_from_bbox(self.figure.bbox)
        self._draw_curves()

    def _draw_frame(self) -> Iterator[None]:
        """Draw the frame beside what is shown, one artist a step, and keep it."""
        self._background = None
        size = self.figure.bbox.size.tolist()
        renderer = RendererAgg(*size, self.figure.dpi)
        yield
        with suppress(Exception):  # then it is drawn at once, which tells why it cannot be
            self.axes.apply_aspect(self.axes.get_axes_locator()(self.axes, renderer))
            grounds = [self.figure.patch, self.axes.patch]
            others = [a for a in self.axes.get_children() if a not in (*grounds, *self._curves)]
            for artist in [*grounds, *sorted(others, key=Artist.get_zorder)]:
                artist.draw(renderer)
                yield
            if self.figure.bbox.size.tolist() == size:
                self._background = renderer.copy_from_bbox(self.figure.bbox)

    def _draw_curves(self) -> None:
        self.restore_region(self._background)
        for artist in self._curves:
            self.axes.draw_artist(artist)

    def _on_press(self, event: MouseEvent) -> None:
        if method := self._method_at(event):
            self.pressed.emit(method)

    def _on_motion(self, event: MouseEvent) -> None:
        over = self._method_at(event) is not None
        self.setCursor(Qt.CursorShape.PointingHandCursor if over else Qt.CursorShape.ArrowCursor)

    def _method_at(self, event: MouseEvent) -> str | None:
        """Return the method of the topmost artist under the pointer."""
        artists = [*self.axes.lines, *self.axes.texts]
        hit = [artist for artist in artists if method_of(artist) and artist.contains(event)[0]]
        return method_of(max(hit, key=Artist.get_zorder)) if hit else None
