"""A triangle mesh as an actor whose points and colours change in place."""

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkCellArray

from app.scene.panes import Look, Pane, Points
from core.arrays import FloatArray, IntArray
from core.mesh.geometry import shading_normals

_COLOUR_MAP = "viridis"


def cell_array(faces: IntArray) -> vtkCellArray:
    """Faces in VTK's form, to be shared by all meshes that have them."""
    polygons: vtkCellArray = pv.CellArray.from_regular_cells(faces)
    return polygons


def lookup_table(colour_range: tuple[float, float]) -> pv.LookupTable:
    """Colours of the values from the lower to the upper end of a range."""
    table = pv.LookupTable(_COLOUR_MAP, n_values=256)
    table.scalar_range = colour_range
    return table


class SurfaceActor:
    """One mesh of the grid.

    Drawing it again with other points costs no more than copying them: nothing is removed from
    or added to the renderer.
    """

    def __init__(self) -> None:
        self._mesh = pv.PolyData()
        self._faces: IntArray | None = None
        self._mapper = pv.DataSetMapper(self._mesh)
        self._mapper.scalar_visibility = False
        self.actor = pv.Actor(mapper=self._mapper)
        self.actor.prop.specular = 0.15
        self.actor.prop.specular_power = 20
        self.actor.prop.ambient = 0.12

    def show(self, pane: Pane, look: Look, cells: vtkCellArray, table: pv.LookupTable) -> None:
        """Draw a pane's mesh."""
        if self._faces is not look.faces:
            self._mesh = pv.PolyData(pane.points.copy())
            self._mesh.SetVerts(None)
            self._mesh.SetPolys(cells)
            self._mapper.dataset = self._mesh
            self._faces = look.faces
        self._move(pane.points, look)
        self._colour(pane.values, look, table)
        self._style(look)

    def _move(self, points: Points, look: Look) -> None:
        self._mesh.points[:] = points
        self._mesh.GetPoints().Modified()
        if look.smooth:
            normals: FloatArray = shading_normals(points.astype(np.float64), look.faces)
            self._mesh.point_data.active_normals = normals.astype(np.float32)
        self._mesh.Modified()

    def _colour(
        self, values: NDArray[np.float64] | None, look: Look, table: pv.LookupTable
    ) -> None:
        coloured = values is not None and bool(look.colour_title)
        self._mapper.scalar_visibility = coloured
        if not coloured:
            return
        on_vertices = look.values_on == "vertex"
        data = self._mesh.point_data if on_vertices else self._mesh.cell_data
        data.set_array(np.asarray(values, np.float32), "error")
        data.active_scalars_name = "error"
        self._mapper.scalar_map_mode = "point" if on_vertices else "cell"
        self._mapper.lookup_table = table
        self._mapper.scalar_range = table.scalar_range

    def _style(self, look: Look) -> None:
        prop = self.actor.prop
        prop.color = look.theme.surface
        prop.interpolation = "Gouraud" if look.smooth else "Flat"
        prop.show_edges = look.edges
        prop.edge_color = look.theme.ink
        prop.edge_opacity = 0.35
        prop.line_width = 0.6 * look.text_scale
