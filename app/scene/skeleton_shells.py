"""Surfaces in space on which a field is constant: spheres, ellipsoids, superellipsoids, planes."""

import numpy as np
import pyvista as pv

from app.scene.skeleton_panes import SkeletonLook, SkeletonPane
from app.scene.skeleton_surface import surface_data
from app.session.skeleton_maker import Skeleton
from core.arrays import FloatArray, IntArray
from core.fields import field_spec
from core.fields.centred import surface_vertices
from core.mesh import TriangleMesh
from core.mesh.primitives import sphere

_MOST = 4
_OPACITY = 0.06
_FINENESS = 4


class ShellActor:
    """A few of the shells that the levels lie on."""

    def __init__(self) -> None:
        self._shown: tuple[Skeleton, int | None] | None = None
        self._mapper = pv.DataSetMapper(pv.PolyData())
        self._mapper.scalar_visibility = False
        self.actor = pv.Actor(mapper=self._mapper)
        self.actor.prop.opacity = _OPACITY
        self.actor.prop.interpolation = "Gouraud"

    def show(self, pane: SkeletonPane, look: SkeletonLook) -> None:
        """Draw a pane's shells."""
        wanted = look.settings.show_shells and pane.skeleton is not None
        self.actor.visibility = wanted
        if pane.skeleton is None or not wanted:
            return
        if self._shown != (pane.skeleton, pane.step):
            self._shown = pane.skeleton, pane.step
            shells = shell_surfaces(pane.skeleton, shell_levels(pane.skeleton, pane.step))
            data = surface_data(*_joined(shells, pane.centre))
            self._mapper.dataset = data.compute_normals(split_vertices=False)
        self.actor.prop.color = look.theme.accent


def shell_levels(skeleton: Skeleton, step: int | None) -> FloatArray:
    """Values of the shells to draw: the front of the growth, or a few levels evenly chosen."""
    levels = np.append(skeleton.levels, 1.0)
    if step is not None:
        return levels[max(step, 1) - 1 :][:1]
    picks = np.linspace(0, len(levels) - 1, min(_MOST, len(levels)))
    return levels[np.round(picks).astype(np.intp)]


def shell_surfaces(skeleton: Skeleton, values: FloatArray) -> list[tuple[FloatArray, IntArray]]:
    """Points, in model units, and faces of the shell of each normalised value."""
    centre = skeleton.mesh.vertices[surface_vertices(skeleton.mesh)].mean(axis=0)
    raw = skeleton.field.raw(values)
    if not skeleton.field.is_squared:
        return [_plane(skeleton, centre, float(value)) for value in raw]
    directions = sphere(_FINENESS)
    # A distance is a function of the direction times the squared radius.
    per_square = _values_at(skeleton, centre + directions.vertices)
    radii = np.sqrt(np.maximum(raw, 0)[:, None] / per_square)
    return [(centre + r[:, None] * directions.vertices, directions.faces) for r in radii]


def _values_at(skeleton: Skeleton, points: FloatArray) -> FloatArray:
    """Raw values of the field at points of space.

    A vertex without faces counts neither for the centroid nor for VᵀV, so the points may join
    the mesh without changing its field.
    """
    mesh, view = skeleton.mesh, skeleton.view
    joined = TriangleMesh(np.vstack([mesh.vertices, points]), mesh.faces)
    values: FloatArray = field_spec(view.field).evaluate(joined, view.settings)
    return values[len(mesh.vertices) :]


def _plane(skeleton: Skeleton, centre: FloatArray, height: float) -> tuple[FloatArray, IntArray]:
    """A square across the direction of the height."""
    settings = skeleton.view.settings
    direction = np.array([getattr(settings, axis) for axis in "xyz"], np.float64)
    direction /= np.linalg.norm(direction)
    across = np.linalg.svd(direction[None])[2][1:]
    signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    corners = centre + height * direction + 0.4 * skeleton.size * signs @ across
    return corners, np.array([[0, 1, 2], [0, 2, 3]], np.int32)


def _joined(
    shells: list[tuple[FloatArray, IntArray]], centre: FloatArray
) -> tuple[FloatArray, IntArray]:
    starts = np.cumsum([0, *(len(points) for points, _ in shells)])
    faces = [faces + start for (_, faces), start in zip(shells, starts, strict=False)]
    points = np.vstack([points for points, _ in shells]) - centre
    return points, np.vstack(faces).astype(np.int32)
