"""The translucent surface with its bands, its level curves, and the piece of the picked node."""

import numpy as np
import pyvista as pv

from app.scene.skeleton_colours import band_table, grown_colours
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane
from app.session.skeleton_maker import Skeleton
from core.arrays import FloatArray, IntArray
from core.fields import ScalarField
from core.mesh import TriangleMesh
from core.mesh.geometry import shading_normals
from core.skeleton import LevelCurves, cut_surface

# Opaque: lines that let light through make the drawing several times slower.
_CURVE_INK = {False: 0.55, True: 0.34}


class BandedSurface:
    """The surface; its colours are a texture along the field, so that R costs only a new one."""

    def __init__(self) -> None:
        self._mesh: TriangleMesh | None = None
        self._field: ScalarField | None = None
        self._data, self._sketch = pv.PolyData(), pv.PolyData()
        self._mapper = pv.DataSetMapper(self._data)
        self._mapper.interpolate_before_map = True
        self.table = pv.LookupTable()
        self.actor = pv.Actor(mapper=self._mapper)
        self.actor.prop.specular = 0.2
        self.actor.prop.specular_power = 25
        self.actor.prop.ambient = 0.18

    def show(self, pane: SkeletonPane, look: SkeletonLook) -> None:
        """Draw a pane's surface."""
        skeleton = pane.skeleton
        self.actor.visibility = skeleton is not None and look.settings.opacity > 0
        if skeleton is None:
            return
        if self._mesh is not skeleton.mesh:
            self._take_mesh(skeleton, pane.centre)
        if self._field is not skeleton.field:
            self._take_field(skeleton)
        plain = not look.settings.show_bands
        colours = grown_colours(skeleton.view.resolution, pane.step, look.theme, plain=plain)
        self.table = band_table(skeleton.levels, colours)
        self._mapper.lookup_table = self.table
        self._mapper.scalar_range = (0.0, 1.0)
        self.actor.prop.opacity = look.settings.opacity

    def set_precise(self, precise: bool) -> None:
        """Draw the surface itself, or a coarse copy while something moves."""
        self._mapper.SetInputData(self._data if precise else self._sketch)

    def _take_mesh(self, skeleton: Skeleton, centre: FloatArray) -> None:
        self._data = smooth_data(skeleton.mesh, centre)
        self._sketch = smooth_data(skeleton.sketch.mesh, centre) if skeleton.sketch else self._data
        self._mapper.SetInputData(self._data)
        self._mesh, self._field = skeleton.mesh, None

    def _take_field(self, skeleton: Skeleton) -> None:
        values = skeleton.field.values.astype(np.float32)
        nearest = skeleton.sketch.nearest if skeleton.sketch else slice(None)
        for data, shown in ((self._data, values), (self._sketch, values[nearest])):
            data.point_data.set_array(shown, "field")
            data.point_data.active_scalars_name = "field"
        self._mapper.scalar_visibility = True
        self._mapper.scalar_map_mode = "point"
        self._field = skeleton.field


class CurveActor:
    """Level curves as thin lines."""

    def __init__(self) -> None:
        self._shown: tuple[LevelCurves, int | None] | None = None
        self._mapper = pv.DataSetMapper(pv.PolyData())
        self._mapper.scalar_visibility = False
        # Else the surface, at the same depth, swallows parts of the lines.
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        self._mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -4)
        self.actor = pv.Actor(mapper=self._mapper)
        self.actor.prop.lighting = False

    def show(self, pane: SkeletonPane, look: SkeletonLook) -> None:
        """Draw a pane's level curves."""
        skeleton = pane.skeleton
        self.actor.visibility = skeleton is not None and look.settings.show_curves
        if skeleton is None or not look.settings.show_curves:
            return
        if self._shown != (skeleton.curves, pane.step):
            self._shown = skeleton.curves, pane.step
            self._mapper.dataset = curve_data(skeleton.curves, pane.centre, pane.step)
        self.actor.prop.color = blend(
            look.theme.ground_top, look.theme.ink, _CURVE_INK[look.theme.dark]
        )
        self.actor.prop.line_width = look.text_scale


class PieceActor:
    """The piece of surface that belongs to the picked node, lit up."""

    def __init__(self) -> None:
        self._shown: tuple[Skeleton, int] | None = None
        self._mapper = pv.DataSetMapper(pv.PolyData())
        self._mapper.scalar_visibility = False
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        self._mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2)
        self.actor = pv.Actor(mapper=self._mapper)
        self.actor.prop.ambient = 0.5

    def show(self, pane: SkeletonPane, look: SkeletonLook) -> None:
        """Light up the picked node's piece."""
        skeleton, node = pane.skeleton, pane.picked
        has_piece = skeleton is not None and node is not None and node != skeleton.graph.root
        self.actor.visibility = has_piece
        if skeleton is None or node is None or not has_piece:
            return
        if self._shown != (skeleton, node):
            self._shown = skeleton, node
            self._mapper.dataset = piece_data(skeleton, node, pane.centre)
        self.actor.prop.color = look.theme.accent
        self.actor.prop.opacity = 0.8


def blend(one: str, other: str, share: float) -> tuple[float, ...]:
    """Mix two colours."""
    pair = zip(pv.Color(one).float_rgb, pv.Color(other).float_rgb, strict=True)
    return tuple((1 - share) * a + share * b for a, b in pair)


def surface_data(points: FloatArray, faces: IntArray) -> pv.PolyData:
    """Triangles in VTK's form."""
    data = pv.PolyData(points.astype(np.float32))
    data.SetVerts(None)
    data.SetPolys(pv.CellArray.from_regular_cells(faces))
    return data


def smooth_data(mesh: TriangleMesh, centre: FloatArray) -> pv.PolyData:
    """A surface relative to a centre, with normals for smooth shading."""
    data = surface_data(mesh.vertices - centre, mesh.faces)
    normals = shading_normals(mesh.vertices, mesh.faces)
    data.point_data.active_normals = normals.astype(np.float32)
    return data


def curve_data(curves: LevelCurves, centre: FloatArray, step: int | None) -> pv.PolyData:
    """Polylines of the levels below the bands that have grown."""
    data = pv.PolyData()
    data.points = (curves.points - centre).astype(np.float32)
    starts, items = curves.starts, np.arange(len(curves.points))
    if step is not None:
        lengths = np.diff(starts)
        shown = curves.levels < step
        items = items[np.repeat(shown, lengths)]
        starts = np.concatenate([[0], np.cumsum(lengths[shown])])
    data.SetLines(pv.CellArray.from_arrays(starts, items))
    return data


def piece_data(skeleton: Skeleton, node: int, centre: FloatArray) -> pv.PolyData:
    """The triangles of a node's piece of surface."""
    if skeleton.graph.bands == "exact":
        cut = cut_surface(skeleton.mesh, skeleton.field, skeleton.graph, node)
        return surface_data(cut.points - centre, cut.triangles)
    faces = skeleton.mesh.faces[skeleton.graph.member_faces(node)]
    used, numbers = np.unique(faces, return_inverse=True)
    points = skeleton.mesh.vertices[used] - centre
    return surface_data(points, numbers.reshape(-1, 3).astype(np.int32))
