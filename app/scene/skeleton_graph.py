"""The skeletal graph as tubes and balls whose size suits the model."""

import numpy as np
import pyvista as pv
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper

from app.scene.skeleton_colours import node_colours
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane, grown_nodes
from app.session.skeleton_maker import Skeleton
from core.arrays import BoolArray, FloatArray

_LARGEST, _SMALLEST = 0.011, 0.0068
_SHARE_OF_ARC = 0.42
_TUBE = 0.34
_REGULAR, _ROOT, _PICKED = 0.8, 1.4, 1.7
_SIDES = 10


def node_radius(skeleton: Skeleton, size: float) -> float:
    """Radius of a node in model units.

    About a hundredth of the model, less where the nodes stand closer than that.
    """
    graph = skeleton.graph
    ends = graph.nodes[graph.surface_arcs]
    lengths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
    median = float(np.median(lengths)) if len(lengths) else np.inf
    model = skeleton.size
    return size * float(np.clip(_SHARE_OF_ARC * median, _SMALLEST * model, _LARGEST * model))


class GraphActors:
    """Tubes for the arcs and balls for the nodes of one pane."""

    def __init__(self) -> None:
        self._tubes = pv.DataSetMapper(pv.PolyData())
        self._tubes.scalar_visibility = False
        self.tubes = pv.Actor(mapper=self._tubes)
        self._balls = vtkGlyph3DMapper()
        self._balls.SetSourceData(pv.Sphere(radius=1, theta_resolution=14, phi_resolution=12))
        self._balls.SetScaleArray("radius")
        self._balls.SetScaleModeToScaleByMagnitude()
        self._balls.SetScalarModeToUsePointFieldData()
        self._balls.SelectColorArray("colour")
        self._balls.SetColorModeToDirectScalars()
        self.balls = vtkActor()
        self.balls.SetMapper(self._balls)
        for prop in (self.tubes.prop, self.balls.GetProperty()):
            prop.SetAmbient(0.3)
            prop.SetDiffuse(0.8)
            prop.SetSpecular(0.25)
            prop.SetSpecularPower(30)

    @property
    def actors(self) -> tuple[vtkActor, vtkActor]:
        """Both actors."""
        return self.tubes, self.balls

    def show(self, pane: SkeletonPane, look: SkeletonLook) -> None:
        """Draw a pane's graph."""
        skeleton = pane.skeleton
        grown = grown_nodes(skeleton.graph, pane.step) if skeleton else np.zeros(0, np.bool_)
        visible = look.settings.show_graph and bool(grown.any())
        for actor in self.actors:
            actor.SetVisibility(visible)
        if skeleton is None or not visible:
            return
        radius = node_radius(skeleton, look.settings.node_size)
        self._tubes.dataset = _tube_data(skeleton, pane.centre, grown, radius)
        self._balls.SetInputData(_ball_data(pane, look, grown, radius))
        self.tubes.prop.color = look.theme.ink


def _tube_data(
    skeleton: Skeleton, centre: FloatArray, grown: BoolArray, radius: float
) -> pv.PolyData:
    graph = skeleton.graph
    arcs = graph.arcs[grown[graph.arcs].all(axis=1)]
    lines = pv.PolyData()
    lines.points = (graph.nodes - centre).astype(np.float32)
    lines.SetLines(pv.CellArray.from_regular_cells(arcs))
    tubes = vtkTubeFilter()
    tubes.SetInputData(lines)
    tubes.SetRadius(_TUBE * radius)
    tubes.SetNumberOfSides(_SIDES)
    tubes.Update()
    return pv.wrap(tubes.GetOutput())


def _ball_data(
    pane: SkeletonPane, look: SkeletonLook, grown: BoolArray, radius: float
) -> pv.PolyData:
    skeleton = pane.skeleton
    assert skeleton is not None
    graph = skeleton.graph
    sizes = np.where(graph.kinds == "regular", _REGULAR, 1.0)
    if graph.root is not None:
        sizes[graph.root] = _ROOT
    if pane.picked is not None:
        sizes[pane.picked] = _PICKED
    balls = pv.PolyData((graph.nodes - pane.centre)[grown].astype(np.float32))
    balls.point_data["radius"] = (sizes * radius)[grown].astype(np.float32)
    colours = node_colours(graph, look.settings.node_colour, look.theme)
    balls.point_data["colour"] = colours[grown]
    return balls
