"""The model beside the statistics plots: turned with the mouse, a click picks a vertex."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPoint, QSize, QTimer, Signal
from PySide6.QtGui import QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget
from vtkmodules.vtkRenderingCore import vtkCellPicker

from app.scene.camera import OBLIQUE, CameraPose
from app.scene.colours import Theme
from app.scene.panes import Look
from app.scene.statistics_scene import SCENE_SHAPE, ModelPane, StatisticsScene
from app.scene.unit_ball import UnitFrame
from app.ui.interactor import Interactor
from app.ui.stage import View, device_place, share_of
from core.arrays import BoolArray

_CLICK_PIXELS = 4


class StatisticsView(QWidget):
    """Shows one model or two.

    Signals
    -------
    picked(int, int) : a model and the vertex that was clicked on it.
    """

    picked = Signal(int, int)

    def __init__(self) -> None:
        super().__init__()
        self.interactor = Interactor(self, SCENE_SHAPE)
        self.interactor.installEventFilter(self)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.interactor)
        self.scene = StatisticsScene(self.interactor)
        self._panes: Sequence[ModelPane] = ()
        self._look: Look | None = None
        self._masks: Sequence[BoolArray | None] = ()
        self._pressed: QPoint | None = None
        self.flickers = False
        self.interactor.render_window.AddObserver(
            "StartEvent", lambda *_: self.scene.fit_clipping()
        )

    def sizeHint(self) -> QSize:
        return QSize(320, 270)

    def set_ground(self, theme: Theme) -> None:
        """Show the ground of a theme where there is no model yet."""
        self.scene.set_ground(theme.ground, theme.ground_top)
        self.interactor.update()

    def show_models(self, panes: Sequence[ModelPane], look: Look) -> None:
        """Draw models; the camera stays unless their number changes."""
        fresh = len(panes) != len(self._panes)
        self._panes, self._look = panes, look
        self._draw()
        if fresh:
            self.look_from(OBLIQUE)

    def light(self, masks: Sequence[BoolArray | None]) -> None:
        """Light up vertices of each model."""
        if any(mask is not None for mask in (*masks, *self._masks)):
            self._masks = masks
            self.scene.light(masks)
            self.interactor.update()

    def look_from(self, preset: str) -> None:
        """Show the whole models from a preset direction."""
        self.scene.look_from(preset)
        self.interactor.update()

    @property
    def pose(self) -> CameraPose:
        """Where the camera stands, in units of the first model from its centroid."""
        return self._frame.to_model(self.scene.pose)

    def set_pose(self, pose: CameraPose) -> None:
        """Put the camera into a pose in units of the first model."""
        self.scene.set_pose(self._frame.to_unit(pose))
        self.interactor.update()

    def view_at(self, x: float, y: float) -> View | None:
        """Return the view at a point, in shares of the widget from its lower left corner."""
        model = self.scene.model_at(x, y)
        if model is None:
            return None
        return View(self.scene.renderer(model), self.scene.viewports[model])

    def camera_moved(self) -> None:
        """Draw what is seen after a camera was moved."""
        self.interactor.update()

    def set_flicker(self, on: bool) -> None:
        """Show the second model in place of the first, or the first again."""
        if on != self.flickers:
            self.flickers = on
            self._draw()

    def part(self, share: float | None) -> None:
        """Show both models as one, parted by a line at a share of the width; None as two."""
        self.scene.part(share)
        self._draw()

    @property
    def panes(self) -> Sequence[ModelPane]:
        """Models as they were drawn last."""
        return self._panes

    @property
    def shown(self) -> Sequence[ModelPane]:
        """Models in the places where they are seen."""
        return [self._panes[1]] * 2 if self.flickers and len(self._panes) > 1 else self._panes

    @property
    def look(self) -> Look | None:
        """How they were drawn last."""
        return self._look

    @property
    def _frame(self) -> UnitFrame:
        return self._panes[0].frame if self._panes else UnitFrame()

    def close_interactor(self) -> None:
        """Release the graphics; the widget cannot be used any more."""
        self.interactor.removeEventFilter(self)
        self.interactor.close()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # The interactor gets its size after this event; draw with the new one.
        QTimer.singleShot(0, self, self._draw)

    def eventFilter(self, watched: QWidget, event: QEvent) -> bool:
        if event.type() == QEvent.Type.MouseButtonPress:
            self._pressed = event.position().toPoint()
        elif event.type() == QEvent.Type.MouseButtonRelease and self._pressed is not None:
            self._click(event)
        return False

    def _draw(self) -> None:
        if self._look is None:
            return
        self.set_ground(self._look.theme)
        self.scene.show(self.shown, self._look, self.interactor.pixel_size())
        self.scene.light(self._masks)

    def _click(self, event: QMouseEvent) -> None:
        """Pick the vertex nearest to where the surface was clicked without dragging."""
        place = event.position()
        moved = (place.toPoint() - self._pressed).manhattanLength()
        self._pressed = None
        model = self.scene.model_at(*share_of(self, place))
        if moved >= _CLICK_PIXELS or model is None:
            return
        picker = vtkCellPicker()
        if picker.Pick(*device_place(self, place), 0, self.scene.renderer(model)):
            self.picked.emit(model, self.scene.nearest_vertex(model, picker.GetPickPosition()))
