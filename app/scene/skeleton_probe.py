"""What lies under the cursor on a surface that lets light through: no pixel tells its depth."""

from typing import Any, NamedTuple

import numpy as np
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkRenderingCore import vtkCamera

from app.scene.camera import point_on_focal_plane
from app.scene.skeleton_panes import SkeletonPane, field_title, grown_nodes
from app.scene.skeleton_surface import surface_data
from app.session.skeleton_maker import Skeleton
from core.arrays import FloatArray
from core.fields import FIELDS
from core.mesh import TriangleMesh

_FAR = 1e3
_TOLERANCE = 1e-9


class SurfacePlace(NamedTuple):
    """A point of a surface: its face, and the shares of the face's corners in it."""

    face: int
    shares: FloatArray


class SurfaceProbe:
    """Finds where a ray meets a surface first; the search tree of a surface is kept."""

    def __init__(self) -> None:
        self._mesh: TriangleMesh | None = None
        self._locator: Any = vtkStaticCellLocator()

    def find(self, mesh: TriangleMesh, start: FloatArray, end: FloatArray) -> SurfacePlace | None:
        """Return the place at which the line from `start` to `end` meets a mesh first."""
        if mesh is not self._mesh:
            self._mesh = mesh
            self._locator = vtkStaticCellLocator()
            # Relative to a vertex, so that single precision is enough.
            self._locator.SetDataSet(surface_data(mesh.vertices - mesh.vertices[0], mesh.faces))
            self._locator.BuildLocator()
        origin = mesh.vertices[0]
        share, part, face = reference(0.0), reference(0), reference(-1)
        point, inside = [0.0] * 3, [0.0] * 3
        hit = self._locator.IntersectWithLine(
            start - origin, end - origin, _TOLERANCE, share, point, inside, part, face
        )
        if not hit:
            return None
        u, v = inside[0], inside[1]
        return SurfacePlace(int(face), np.array([1 - u - v, u, v]))


def sight_line(camera: vtkCamera, x: float, y: float, aspect: float) -> tuple[FloatArray, ...]:
    """Ends of the line that is seen as a point, at (x, y) from −1 to 1 in a view."""
    eye = np.array(camera.GetPosition())
    return eye, eye + _FAR * (point_on_focal_plane(camera, x, y, aspect) - eye)


def surface_text(skeleton: Skeleton, place: SurfacePlace) -> str:
    """Say which value the field has at a place, and in which band it lies."""
    face = skeleton.mesh.faces[place.face]
    value = float(place.shares @ skeleton.field.values[face])
    band = int(np.searchsorted(skeleton.levels, value, side="right")) + 1
    vertex = int(face[np.argmax(place.shares)])
    name = FIELDS[skeleton.view.field].title
    return (
        f"{name}: vertex {vertex:,}, field value {value:.4f}, "
        f"band {band} of {skeleton.view.resolution}"
    )


def node_line(pane: SkeletonPane, node: int) -> str:
    """Say which node of a graph it is, in one line."""
    if pane.skeleton is None or not grown_nodes(pane.skeleton.graph, pane.step)[node]:
        return ""
    graph = pane.skeleton.graph
    name = field_title(pane.skeleton.view)
    if node == graph.root:
        return f"{name}: root"
    share = graph.area[node] / max(float(graph.area.sum()), 1e-300)
    return (
        f"{name}: node {node}, {graph.kinds[node]}, band {graph.band[node] + 1} of "
        f"{graph.resolution}, {share:.2%} of the area"
    )
