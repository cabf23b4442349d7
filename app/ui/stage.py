"""What a drawing area offers to whoever looks at it, whichever tab it stands in."""

from typing import Any, NamedTuple, Protocol

import pyvista as pv
from PySide6.QtCore import QPointF

from app.scene.camera import CameraPose
from app.scene.layout import Viewport


class View(NamedTuple):
    """One view of a drawing area: what draws it, and its place."""

    renderer: pv.Renderer
    place: Viewport


class Stage(Protocol):
    """A drawing area with one camera, or with one a view.

    Attributes
    ----------
    interactor : Interactor
        Where it is drawn.
    """

    interactor: Any

    @property
    def pose(self) -> CameraPose:
        """Where the camera stands, in model units from the model's centroid."""

    def set_pose(self, pose: CameraPose) -> None:
        """Put the camera into a pose."""

    def look_from(self, preset: str) -> None:
        """Show the whole model from a preset direction."""

    def view_at(self, x: float, y: float) -> View | None:
        """Return the view at a point, in shares of the area from its lower left corner."""

    def camera_moved(self) -> None:
        """Draw what is seen after a camera was moved."""


def share_of(stage: Stage, point: QPointF) -> tuple[float, float]:
    """Turn a point of a drawing area into shares of its size from the lower left corner."""
    size = stage.interactor.size()
    return point.x() / max(size.width(), 1), 1 - point.y() / max(size.height(), 1)


def device_place(stage: Stage, point: QPointF) -> tuple[float, float]:
    """Turn a point of a drawing area into device pixels from the lower left corner."""
    width, height = stage.interactor.pixel_size()
    x, y = share_of(stage, point)
    return x * width, y * height
