"""The viewport: the grid of panes on the screen, with mouse and camera."""

import time
from collections.abc import Iterator

from PySide6.QtCore import QEvent, QPoint, QPointF, QSize, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.scene.camera import CameraPose
from app.scene.due import Due
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from app.ui.interactor import Interactor
from app.ui.stage import View, share_of
from app.ui.turns import Turns, Work

_CLICK_PIXELS = 4


class Viewport(QWidget):
    """Shows panes; a click selects one, a double click enlarges it and brings it back.

    Parameters
    ----------
    turns : Turns
        In which it draws: a part of a pane a turn.

    Attributes
    ----------
    draw_seconds, drawn_at : float
        How long the latest drawing of what had changed took, and when it ended.

    Signals
    -------
    selected(str) : the pane that was clicked.
    bar_opened() : the colour bar was double-clicked.
    """

    selected = Signal(str)
    bar_opened = Signal()

    def __init__(self, turns: Turns) -> None:
        super().__init__()
        self.interactor = Interactor(self, GRID_SHAPE)
        self.interactor.installEventFilter(self)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.interactor)
        self.grid = PaneGrid(self.interactor)
        self._panes: list[Pane] = []
        self._look: Look | None = None
        self._size = (0, 0)
        self._pressed: QPoint | None = None
        window = self.interactor.render_window
        self._due = Due(window, self.grid.seen)
        self._drawing = Work(turns, self._draw)
        self.draw_seconds = self.drawn_at = 0.0
        self.interactor.pixels_lost.connect(self._due.forget)
        window.AddObserver("StartEvent", self._before_drawing)
        window.AddObserver("EndEvent", self._after_drawing)

    def minimumSizeHint(self) -> QSize:
        return QSize(320, 240)

    def show_panes(self, panes: list[Pane], look: Look) -> None:
        """Draw panes; the cameras stay where they are."""
        self._panes, self._look = panes, look
        self._size = self.pixel_size()
        self.grid.set_ground(look.theme.ground, look.theme.ground_top)
        self.grid.show(panes, look, self._size)
        self._drawing.request()

    @property
    def is_drawing(self) -> bool:
        """Whether some of the panes still have to be drawn."""
        return self._drawing.is_active

    def redraw(self) -> None:
        """Draw what is shown once more, after the grid was told to arrange it otherwise."""
        if self._look is not None:
            self.show_panes(self._panes, self._look)

    def pixel_size(self) -> tuple[int, int]:
        """Size of the drawing area in device pixels."""
        return self.interactor.pixel_size()

    def look_from(self, preset: str) -> None:
        """Show the whole model from a preset direction."""
        self.grid.look_from(preset)
        self._drawing.request()

    @property
    def pose(self) -> CameraPose:
        """Where the camera of the selected pane stands."""
        chosen = self._look.selected if self._look else None
        place = self.grid.ids.index(chosen) if chosen in self.grid.ids else 0
        return self.grid.poses()[place]

    def set_pose(self, pose: CameraPose) -> None:
        """Put the cameras of all panes into a pose."""
        self.grid.set_poses([pose])
        self._drawing.request()

    def set_linked(self, linked: bool, leader: str | None) -> None:
        """Link or unlink the cameras; nothing jumps on unlinking."""
        if linked != self.grid.linked:
            self.grid.link(linked, leader)
            self._drawing.request()

    def toggle_enlarged(self, pane: str | None) -> None:
        """Enlarge one pane to the whole viewport, or bring the others back."""
        self.grid.enlarged = None if self.grid.enlarged else pane
        self.redraw()

    def camera_moved(self) -> None:
        """Draw what is seen after a camera was moved."""
        self.interactor.update()

    def view_at(self, x: float, y: float) -> View | None:
        """Return the view at a point, in shares of the widget from its lower left corner."""
        pane = self.grid.pane_at(x, y)
        return View(self.grid.renderer(pane), self.grid.viewports[pane]) if pane else None

    def share(self, point: QPointF) -> tuple[float, float]:
        """Turn a point of the widget into shares of its size from the lower left corner."""
        return share_of(self, point)

    def close_interactor(self) -> None:
        """Release the graphics; the widget cannot be used any more."""
        self.interactor.removeEventFilter(self)
        self.interactor.close()

    def eventFilter(self, watched: QWidget, event: QEvent) -> bool:
        if not isinstance(event, QMouseEvent):
            return False
        handlers = {
            QEvent.Type.MouseButtonPress: self._press,
            QEvent.Type.MouseButtonRelease: self._release,
            QEvent.Type.MouseButtonDblClick: self._double_click,
        }
        handler = handlers.get(event.type())
        return handler(event) if handler else False

    def _press(self, event: QMouseEvent) -> bool:
        self._pressed = event.position().toPoint()
        return False

    def _release(self, event: QMouseEvent) -> bool:
        pressed, self._pressed = self._pressed, None
        if pressed is None:
            return False
        moved = (event.position().toPoint() - pressed).manhattanLength()
        pane = self._pane_at(pressed)
        if moved < _CLICK_PIXELS and pane:
            self.selected.emit(pane)
        return False

    def _double_click(self, event: QMouseEvent) -> bool:
        pane = self._pane_at(event.position().toPoint())
        if pane is None:
            self.bar_opened.emit()
        elif self.grid.swipe is None:
            self.toggle_enlarged(pane)
        return True

    def _draw(self) -> Iterator[None]:
        """Draw what is due a part a turn, then show all of it at once.

        Until then the picture stays as it is, so that panes never contradict each other. Whatever
        else paints meanwhile, a camera that moves or another size, draws what is left at once.
        """
        area, begun, seconds = self.interactor, time.perf_counter(), 0.0
        while area.isVisible() and area.isValid() and self._due.draw_one():
            # Its pixels are filled while the window does other things.
            area.context().functions().glFlush()
            seconds += time.perf_counter() - begun
            yield
            begun = time.perf_counter()
            if self._due.is_complete:
                area.repaint()
                self.draw_seconds = seconds + time.perf_counter() - begun
                break
        self.drawn_at = time.perf_counter()

    def _before_drawing(self, *_: object) -> None:
        if self._look is not None and self._size != self.pixel_size():
            self._size = self.pixel_size()
            self.grid.show(self._panes, self._look, self._size)
        self.grid.fit_clipping()
        self._due.begin()

    def _after_drawing(self, *_: object) -> None:
        self._due.end()

    def _pane_at(self, point: QPoint) -> str | None:
        return self.grid.pane_at(*self.share(QPointF(point)))
