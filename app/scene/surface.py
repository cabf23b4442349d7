"""A triangle mesh as a prop whose points and colours change in place."""

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPolyDataMapper

from app.scene.live_array import LiveArray
from app.scene.panes import Look, Pane, Points
from app.scene.parts import Part
from core.mesh.geometry import shading_normals


def lookup_table(colour_range: tuple[float, float], colour_map: str = "viridis") -> pv.LookupTable:
    """Colours of the values from the lower to the upper end of a range."""
    table = pv.LookupTable(colour_map, n_values=256)
    table.scalar_range = colour_range
    return table


class SurfaceActor:
    """One mesh of the grid.

    Drawing it again with other points costs no more than copying them: nothing is removed from
    or added to the renderer.

    Attributes
    ----------
    actor : vtkAssembly
        What a renderer draws.
    """

    def __init__(self) -> None:
        self.actor = vtkAssembly()
        self._parts: tuple[Part, ...] = ()
        self._drawn: list[_DrawnPart] = []
        self._shown: tuple[Points | None, bool] = (None, False)
        self._plane: vtkPlane | None = None
        self._prop = pv.Property(specular=0.15, specular_power=20, ambient=0.12)

    @property
    def part_actors(self) -> list[vtkActor]:
        """Actors of the parts, which together are the mesh."""
        return [part.actor for part in self._drawn]

    def use(self, parts: tuple[Part, ...]) -> None:
        """Draw a mesh that has these parts."""
        if self._parts is not parts:
            self._begin(parts)

    def show(self, pane: Pane, look: Look, table: pv.LookupTable) -> None:
        """Draw a pane's mesh, which has the parts in use.

        Parts that are hidden at the moment are made ready by :meth:`prepare` once they are not.
        """
        if self._shown[0] is not pane.points or self._shown[1] != look.smooth:
            self._move(pane.points, look)
            self._shown = (pane.points, look.smooth)
        values = pane.values if look.colour_title else None
        for part in self._drawn:
            part.colour(values, look, table)
        self._style(look)
        self.prepare()

    def prepare(self) -> None:
        """Make the parts ready that are to be drawn; the others take their time later."""
        for part in self._drawn:
            if part.actor.GetVisibility():
                part.prepare()

    def cut(self, plane: vtkPlane | None) -> None:
        """Draw only what is on the inner side of a plane; None: all."""
        self._plane = plane
        for actor in self.part_actors:
            actor.GetMapper().RemoveAllClippingPlanes()
            if plane is not None:
                actor.GetMapper().AddClippingPlane(plane)

    def _begin(self, parts: tuple[Part, ...]) -> None:
        """Start a mesh with other faces."""
        for actor in self.part_actors:
            self.actor.RemovePart(actor)
        self._parts = parts
        self._drawn = [_DrawnPart(part, self._prop) for part in parts]
        for actor in self.part_actors:
            self.actor.AddPart(actor)
        self._shown = (None, False)
        self.cut(self._plane)

    def _move(self, points: Points, look: Look) -> None:
        normals = None
        if look.smooth:
            normals = shading_normals(points.astype(np.float64), look.faces)
        for part in self._drawn:
            part.move(points, normals)

    def _style(self, look: Look) -> None:
        self._prop.color = look.theme.surface
        self._prop.interpolation = "Gouraud" if look.smooth else "Flat"
        self._prop.show_edges = look.edges
        self._prop.edge_color = look.theme.ink
        self._prop.edge_opacity = 0.35
        self._prop.line_width = 0.6 * look.text_scale


class _DrawnPart:
    """A part of a mesh with arrays of its own."""

    def __init__(self, part: Part, prop: pv.Property) -> None:
        self._part = part
        count = len(part.vertices)
        self._points, self._normals = LiveArray((count, 3), "points"), LiveArray((count, 3), "n")
        self._values = LiveArray((0,), "error")
        self._wanted: tuple[Points, NDArray[np.float64] | None] | None = None
        points = vtkPoints()
        points.SetData(self._points.vtk)
        self._mesh = vtkPolyData()
        self._mesh.SetPoints(points)
        self._mesh.SetPolys(part.cells)
        self._mapper = vtkPolyDataMapper()
        self._mapper.ScalarVisibilityOff()
        self._mapper.SetInputData(self._mesh)
        self.actor = vtkActor()
        self.actor.SetMapper(self._mapper)
        self.actor.SetProperty(prop)

    def move(self, points: Points, normals: NDArray[np.float64] | None) -> None:
        """Take positions, and normals of smooth shading, from those of the whole mesh."""
        self._wanted = points, normals

    def prepare(self) -> None:
        """Copy what was taken."""
        if self._wanted is None:
            return
        (points, normals), self._wanted = self._wanted, None
        self._points.write(points[self._part.vertices])
        self._mesh.GetPoints().Modified()
        data = self._mesh.GetPointData()
        data.SetNormals(None if normals is None else self._normals.vtk)
        if normals is not None:
            self._normals.write(normals[self._part.vertices])
        self._mesh.Modified()

    def colour(self, values: NDArray[np.float64] | None, look: Look, table: pv.LookupTable) -> None:
        """Colour it by values of the whole mesh; None: not by values."""
        if values is None:
            self._mapper.ScalarVisibilityOff()
            return
        on_vertices = look.values_on == "vertex"
        chosen = values[self._part.vertices if on_vertices else self._part.faces]
        if self._values.rows != len(chosen):
            self._values = LiveArray((len(chosen),), "error")
        self._values.write(chosen)
        self._mesh.GetPointData().SetScalars(self._values.vtk if on_vertices else None)
        self._mesh.GetCellData().SetScalars(None if on_vertices else self._values.vtk)
        if on_vertices:
            self._mapper.SetScalarModeToUsePointData()
        else:
            self._mapper.SetScalarModeToUseCellData()
        self._mapper.SetLookupTable(table)
        self._mapper.SetScalarRange(table.scalar_range)
        self._mapper.ScalarVisibilityOn()
