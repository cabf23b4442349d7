"""Places on a mesh that are pointed out: dots at vertices, and a camera that goes close to them."""

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.scene.camera import CameraPose
from app.scene.colours import MARK_COLOUR
from app.scene.panes import Look, Pane, Points
from core.arrays import FloatArray
from core.mesh import TriangleMesh
from core.mesh.geometry import shading_normals

_MOST_PIXELS, _LEAST_PIXELS = 7.0, 3.0
# Fewer dots than this are drawn large.
_FEW = 60
# Dots stand this much, in the depth buffer's own steps, before the surface that they lie on.
_NEARER = -40_000
_HALF_ANGLE = np.radians(15)
# A place is shown with at least this share of the model around it.
_LEAST = 0.12
_FACING = 0.3


class Marks:
    """The dots of one pane."""

    def __init__(self) -> None:
        self._shown: tuple[Points, NDArray[np.int64]] | None = None
        self._mesh = vtkPolyData()
        self._glyphs = vtkVertexGlyphFilter()
        self._glyphs.SetInputData(self._mesh)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self._glyphs.GetOutputPort())
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPointOffsetParameter(_NEARER)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.SetVisibility(False)
        self.actor.GetProperty().SetLighting(False)
        self.actor.GetProperty().SetRenderPointsAsSpheres(True)

    def show(self, pane: Pane, look: Look) -> None:
        """Draw the dots of a pane where the look has some."""
        self.actor.SetVisibility(look.marks is not None)
        if look.marks is None:
            self._shown = None
            return
        if self._shown is None or not _is_same(self._shown, (pane.points, look.marks)):
            self._shown = pane.points, look.marks
            points = vtkPoints()
            points.SetData(numpy_to_vtk(pane.points[look.marks], deep=True))
            self._mesh.SetPoints(points)
        self.actor.GetProperty().SetColor(*_rgb(MARK_COLOUR))
        self.actor.GetProperty().SetPointSize(_pixels(len(look.marks)) * look.text_scale)


def _pixels(count: int) -> float:
    """Size of a dot: many dots are small, or they would hide the surface."""
    return float(np.clip(_MOST_PIXELS * (_FEW / max(count, 1)) ** 0.5, _LEAST_PIXELS, _MOST_PIXELS))


def _is_same(
    one: tuple[Points, NDArray[np.int64]], other: tuple[Points, NDArray[np.int64]]
) -> bool:
    return one[0] is other[0] and one[1] is other[1]


def _rgb(colour: str) -> tuple[float, float, float]:
    red, green, blue = (int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5))
    return red, green, blue


def close_up(mesh: TriangleMesh, vertices: NDArray[np.int64], pose: CameraPose) -> CameraPose:
    """Pose that shows some vertices of a mesh, relative to its centroid.

    The camera looks at the outside of the surface where the vertices agree on one; otherwise it
    keeps its direction.
    """
    centred = mesh.vertices - mesh.vertices.mean(axis=0)
    points = centred[vertices]
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    whole = float(np.linalg.norm(centred, axis=1).max())
    radius = max(float(np.linalg.norm(points - middle, axis=1).max()) * 1.2, _LEAST * whole)
    direction = _outside(mesh, vertices) if radius < whole / 2 else None
    if direction is None:
        direction = np.subtract(pose.position, pose.focal_point)
    direction = direction / (np.linalg.norm(direction) or 1.0)
    position = middle + direction * radius / np.sin(_HALF_ANGLE)
    up = _up(np.array(pose.view_up), direction)
    return pose._replace(
        position=tuple(position.tolist()), focal_point=tuple(middle.tolist()), view_up=up
    )


def _outside(mesh: TriangleMesh, vertices: NDArray[np.int64]) -> FloatArray | None:
    normals = shading_normals(mesh.vertices, mesh.faces)[vertices]
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    mean: FloatArray = (normals / np.maximum(lengths, 1e-300)).mean(axis=0)
    return mean if np.linalg.norm(mean) > _FACING else None


def _up(up: FloatArray, direction: FloatArray) -> tuple[float, float, float]:
    """Keep what is up, unless the camera looks along it."""
    if np.linalg.norm(np.cross(up, direction)) < 0.1:
        up = np.eye(3)[np.abs(direction).argmin()]
    x, y, z = up.tolist()
    return x, y, z
