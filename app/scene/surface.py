"""A triangle mesh as an actor whose points and colours change in place."""

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

from app.scene.live_array import LiveArray
from app.scene.panes import Look, Pane, Points
from core.arrays import IntArray
from core.mesh.geometry import shading_normals


def cell_array(faces: IntArray) -> vtkCellArray:
    """Faces in VTK's form, to be shared by all meshes that have them."""
    polygons: vtkCellArray = pv.CellArray.from_regular_cells(faces)
    return polygons


def lookup_table(colour_range: tuple[float, float], colour_map: str = "viridis") -> pv.LookupTable:
    """Colours of the values from the lower to the upper end of a range."""
    table = pv.LookupTable(colour_map, n_values=256)
    table.scalar_range = colour_range
    return table


class SurfaceActor:
    """One mesh of the grid.

    Drawing it again with other points costs no more than copying them: nothing is removed from
    or added to the renderer.
    """

    def __init__(self) -> None:
        self._mesh = vtkPolyData()
        self._faces: IntArray | None = None
        self._points = LiveArray((0, 3), "points")
        self._normals = LiveArray((0, 3), "normals")
        self._values = LiveArray((0,), "error")
        self._shown: tuple[Points | None, bool] = (None, False)
        self._mapper = vtkPolyDataMapper()
        self._mapper.ScalarVisibilityOff()
        self.actor = pv.Actor()
        self.actor.SetMapper(self._mapper)
        self.actor.prop.specular = 0.15
        self.actor.prop.specular_power = 20
        self.actor.prop.ambient = 0.12

    def show(self, pane: Pane, look: Look, cells: vtkCellArray, table: pv.LookupTable) -> None:
        """Draw a pane's mesh."""
        if self._faces is not look.faces:
            self._begin(len(pane.points), cells)
            self._faces = look.faces
        if self._shown[0] is not pane.points or self._shown[1] != look.smooth:
            self._move(pane.points, look)
            self._shown = (pane.points, look.smooth)
        self._colour(pane.values, look, table)
        self._style(look)

    def _begin(self, count: int, cells: vtkCellArray) -> None:
        """Start a mesh with other faces."""
        self._points, self._normals = LiveArray((count, 3), "points"), LiveArray((count, 3), "n")
        points = vtkPoints()
        points.SetData(self._points.vtk)
        self._mesh = vtkPolyData()
        self._mesh.SetPoints(points)
        self._mesh.SetPolys(cells)
        self._mapper.SetInputData(self._mesh)
        self._shown = (None, False)

    def _move(self, points: Points, look: Look) -> None:
        self._points.write(points)
        self._mesh.GetPoints().Modified()
        data = self._mesh.GetPointData()
        data.SetNormals(self._normals.vtk if look.smooth else None)
        if look.smooth:
            self._normals.write(shading_normals(points.astype(np.float64), look.faces))
        self._mesh.Modified()

    def _colour(
        self, values: NDArray[np.float64] | None, look: Look, table: pv.LookupTable
    ) -> None:
        if values is None or not look.colour_title:
            self._mapper.ScalarVisibilityOff()
            return
        if self._values.rows != len(values):
            self._values = LiveArray((len(values),), "error")
        self._values.write(values)
        on_vertices = look.values_on == "vertex"
        self._mesh.GetPointData().SetScalars(self._values.vtk if on_vertices else None)
        self._mesh.GetCellData().SetScalars(None if on_vertices else self._values.vtk)
        if on_vertices:
            self._mapper.SetScalarModeToUsePointData()
        else:
            self._mapper.SetScalarModeToUseCellData()
        self._mapper.SetLookupTable(table)
        self._mapper.SetScalarRange(table.scalar_range)
        self._mapper.ScalarVisibilityOn()

    def _style(self, look: Look) -> None:
        prop = self.actor.prop
        prop.color = look.theme.surface
        prop.interpolation = "Gouraud" if look.smooth else "Flat"
        prop.show_edges = look.edges
        prop.edge_color = look.theme.ink
        prop.edge_opacity = 0.35
        prop.line_width = 0.6 * look.text_scale
