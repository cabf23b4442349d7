"""Two meshes in one pane, parted by a vertical line: one left of it, the other right of it.

Both are cut by the plane through the eye and the line, so every pixel shows exactly one of them,
with one camera and one renderer.
"""

from dataclasses import dataclass

import numpy as np
import pyvista as pv
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkCamera, vtkCoordinate, vtkPolyDataMapper2D

from app.scene.camera import point_on_focal_plane
from app.scene.caption import Caption
from app.scene.panes import Look, Pane
from app.scene.parts import Part
from app.scene.surface import SurfaceActor
from core.arrays import FloatArray


@dataclass(frozen=True)
class Swipe:
    """Which panes stand left and right of the line, and where it is.

    Attributes
    ----------
    left, right : str
        Ids of the panes.
    share : float
        Place of the line, as a share of the pane's width.
    """

    left: str
    right: str
    share: float = 0.5


def cutting_normal(camera: vtkCamera, share: float, aspect: float) -> FloatArray:
    """Normal, pointing right, of the plane through the eye and a vertical line of the picture.

    Parameters
    ----------
    camera : vtkCamera
        Where the eye is.
    share : float
        Place of the line, as a share of the picture's width.
    aspect : float
        Width of the picture over its height.
    """
    low, high = (point_on_focal_plane(camera, 2 * share - 1, y, aspect) for y in (-1, 1))
    normal = np.cross(low - np.array(camera.GetPosition()), high - low)
    result: FloatArray = normal / np.linalg.norm(normal)
    return result


class SwipeLayer:
    """What a swipe adds to the renderer of its left pane: the right mesh, its text, the line."""

    def __init__(self) -> None:
        self.surface = SurfaceActor()
        self._caption = Caption()
        self._line = _Line()
        self._planes = vtkPlane(), vtkPlane()
        self._renderer: pv.Renderer | None = None
        self._left: SurfaceActor | None = None
        self._share = 0.5

    def show(
        self, renderer: pv.Renderer, left: SurfaceActor, swipe: Swipe, pane: Pane, look: Look,
        parts: tuple[Part, ...], table: pv.LookupTable, size: tuple[float, float],
    ) -> None:  # fmt: skip
        """Draw the right pane into the renderer of the left one, `size` pixels large."""
        if renderer is not self._renderer:
            self.hide()
            self._attach(renderer, left)
        self._share = swipe.share
        self.surface.use(parts)
        self.surface.show(pane, look, table)
        self._caption.show(pane, look, size[1], right=size[0], width=size[0] / 2)
        self._line.show(swipe.share, look)
        self.cut(size[0] / max(size[1], 1))

    def cut(self, aspect: float) -> None:
        """Cut both meshes anew, after the camera has moved."""
        if self._renderer is None:
            return
        camera = self._renderer.GetActiveCamera()
        normal = cutting_normal(camera, self._share, aspect)
        for plane, sign in zip(self._planes, (-1, 1), strict=True):
            plane.SetOrigin(camera.GetPosition())
            plane.SetNormal(*(sign * normal))

    def hide(self) -> None:
        """Leave the left pane whole again."""
        if self._renderer is None or self._left is None:
            return
        self._left.cut(None)
        self.surface.cut(None)
        self._renderer.RemoveActor(self.surface.actor)
        self._renderer.RemoveViewProp(self._line.actor)
        self._caption.remove_from(self._renderer)
        self._renderer = self._left = None

    def _attach(self, renderer: pv.Renderer, left: SurfaceActor) -> None:
        self._renderer, self._left = renderer, left
        for surface, plane in zip((left, self.surface), self._planes, strict=True):
            surface.cut(plane)
        renderer.AddActor(self.surface.actor)
        renderer.AddViewProp(self._line.actor)
        self._caption.add_to(renderer)


class _Line:
    """A vertical line over the whole height of a viewport."""

    def __init__(self) -> None:
        self._mapper = vtkPolyDataMapper2D()
        self._mapper.SetScalarVisibility(False)
        place = vtkCoordinate()
        place.SetCoordinateSystemToNormalizedViewport()
        self._mapper.SetTransformCoordinate(place)
        self.actor = vtkActor2D()
        self.actor.SetMapper(self._mapper)

    def show(self, share: float, look: Look) -> None:
        self._mapper.SetInputData(pv.Line((share, 0, 0), (share, 1, 0)))
        self.actor.GetProperty().SetColor(pv.Color(look.theme.accent).float_rgb)
        self.actor.GetProperty().SetLineWidth(2 * look.text_scale)
