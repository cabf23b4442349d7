"""One model or two beside the statistics plots, with the vertices that a plot lights up."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from app.scene.camera import CameraPose, distance_to, preset_pose
from app.scene.caption import Caption
from app.scene.colour_bar import ColourBar
from app.scene.layout import Viewport, tile
from app.scene.panes import Look, Pane
from app.scene.parted_camera import PartedCamera, parted
from app.scene.parts import Part, parts_of
from app.scene.surface import SurfaceActor, lookup_table
from app.scene.unit_ball import UnitFrame
from core.arrays import BoolArray, FloatArray
from core.mesh.topology import Topology

CAPACITY = 2
SCENE_SHAPE = (1, 3)
"""Shape a plotter needs: two models and the colour bar."""

_BAR_PIXELS = 84.0
_RADIUS = 1.05
_LIT_COLOUR = {False: "#e4007c", True: "#ffd23f"}
_NOWHERE = Viewport(0.0, 0.0, 0.0, 0.0)
_WHOLE = Viewport(0.0, 0.0, 1.0, 1.0)


@dataclass(frozen=True, eq=False)
class ModelPane:
    """One model as it is drawn.

    Attributes
    ----------
    pane : Pane
        Title, points scaled to the unit ball, and the values that colour it.
    topology : Topology
        Its connectivity.
    frame : UnitFrame
        How its points were scaled.
    """

    pane: Pane
    topology: Topology
    frame: UnitFrame


class StatisticsScene:
    """Draws one or two models into a PyVista plotter; they share one camera.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Made with ``shape=SCENE_SHAPE, border=False``.
    """

    def __init__(self, plotter: pv.BasePlotter) -> None:
        self.plotter = plotter
        *self._renderers, self._bar_renderer = plotter.renderers
        self._surfaces = [SurfaceActor() for _ in self._renderers]
        self._captions = [Caption() for _ in self._renderers]
        self._lights = [_Lights() for _ in self._renderers]
        self._parts: list[tuple[Topology, tuple[Part, ...]] | None] = [None] * CAPACITY
        self._bar = ColourBar()
        self._bar.add_to(self._bar_renderer)
        self._panes: list[ModelPane] = []
        self._narrowest = 1.0
        self.viewports: list[Viewport] = []
        self._camera = PartedCamera()
        for place, renderer in enumerate(self._renderers):
            renderer.AddActor(self._surfaces[place].actor)
            renderer.AddActor(self._lights[place].actor)
            self._captions[place].add_to(renderer)
        self._share_camera()
        for renderer in self._renderers:
            renderer.SetDraw(False)
        self._bar_renderer.SetViewport(_WHOLE)

    def show(self, panes: Sequence[ModelPane], look: Look, size: tuple[int, int]) -> None:
        """Draw models in a window of `size` pixels."""
        self._panes = list(panes[:CAPACITY])
        self._arrange(look, size)
        table = lookup_table(look.colour_range)
        self._bar.show(look, table)
        for place, shown in enumerate(self._panes):
            look_here = replace(look, topology=shown.topology)
            self._surfaces[place].use(self._parts_of(place, shown.topology))
            self._surfaces[place].show(shown.pane, look_here, table)
            width, height = self.viewports[place].pixels(*size)[2:]
            self._captions[place].show(shown.pane, look_here, height, width=width)
            self._lights[place].set_look(look)

    def light(self, masks: Sequence[BoolArray | None]) -> None:
        """Light up vertices of each model; None lights none."""
        for lights, shown, mask in zip(self._lights, self._panes, masks, strict=False):
            lights.show(shown.pane.points, mask)

    def set_ground(self, bottom: str, top: str | None) -> None:
        """Colour the background, with a gradient if `top` is given."""
        for renderer in (*self._renderers, self._bar_renderer):
            renderer.set_background(bottom, top=top)

    def look_from(self, preset: str) -> None:
        """Show the whole models from a preset direction."""
        if self._panes:
            points = self._panes[0].pane.points
            self.set_pose(preset_pose(preset, points, _RADIUS, self._narrowest))

    @property
    def pose(self) -> CameraPose:
        """Where the camera stands, beside models in the unit ball."""
        return self._camera.pose

    def set_pose(self, pose: CameraPose) -> None:
        """Put the camera into a pose."""
        self._camera.set_pose(pose)
        self.fit_clipping()

    def part(self, share: float | None) -> None:
        """Show both models as one, parted by a line at a share of the width; None as two."""
        self._camera.part(share)
        self._share_camera()

    @property
    def share(self) -> float | None:
        """Place of the line that parts the models, or None."""
        return self._camera.share

    def fit_clipping(self) -> None:
        """Set the clipping range from the unit ball, which holds both models."""
        self._camera.follow()
        for renderer in self._renderers:
            renderer.ResetCameraClippingRange((-1, 1, -1, 1, -1, 1))

    def model_at(self, x: float, y: float) -> int | None:
        """Return which model is at a point, in shares of the window from its lower left corner."""
        found = (place for place, port in enumerate(self.viewports) if port.holds(x, y))
        return next(found, None)

    def renderer(self, place: int) -> pv.Renderer:
        """Return the renderer of a model."""
        return self._renderers[place]

    def nearest_vertex(self, place: int, point: Sequence[float]) -> int:
        """Return the vertex of a model that is nearest to a point of the scene."""
        offsets: FloatArray = self._panes[place].pane.points - np.asarray(point)
        return int(np.argmin((offsets**2).sum(axis=1)))

    def _arrange(self, look: Look, size: tuple[int, int]) -> None:
        width, height = max(size[0], 1), max(size[1], 1)
        bar = (
            min(_BAR_PIXELS * look.text_scale / width, 0.4)
            if look.bar and look.colour_title
            else 0.0
        )
        if len(self._panes) < CAPACITY and self.share is not None:
            self.part(None)
        self.viewports = tile(len(self._panes), width / height, 1 - bar)
        if self.share is not None:
            self.viewports = parted(self.share, 1 - bar)
        self._keep_fitting(width / height)
        places = [*self.viewports, *[_NOWHERE] * (CAPACITY - len(self.viewports))]
        bar_place = Viewport(1 - bar, 0.0, 1.0, 1.0) if bar else _NOWHERE
        if not self.viewports:
            # Else nothing would be drawn, and the view were black.
            bar_place = _WHOLE
        every = zip((*self._renderers, self._bar_renderer), (*places, bar_place), strict=True)
        for renderer, port in every:
            renderer.SetViewport(port)
            renderer.SetDraw(port != _NOWHERE)
        self._bar_renderer.InteractiveOff()

    def _keep_fitting(self, aspect: float) -> None:
        """Step back where the views have become narrower, closer where they are wider again."""
        sides = [aspect * (p.right - p.left) / (p.top - p.bottom) for p in self.viewports]
        sides = [sum(sides)] if self.share is not None else sides
        narrowest = min(sides, default=1.0)
        before, after = (_distance(side) for side in (self._narrowest, narrowest))
        self._narrowest = narrowest
        self._camera.shown[0].Dolly(before / after)

    def _share_camera(self) -> None:
        for renderer, camera in zip(self._renderers, self._camera.shown, strict=True):
            renderer.SetActiveCamera(camera)
            # Else PyVista chooses a view of its own at the first picture.
            renderer.camera.is_set = True

    def _parts_of(self, place: int, topology: Topology) -> tuple[Part, ...]:
        known = self._parts[place]
        if known is None or known[0] is not topology:
            known = self._parts[place] = topology, parts_of(topology)
        return known[1]


def _distance(aspect: float) -> float:
    """Distance from which a camera sees a model in a view of this width over height."""
    return distance_to(_RADIUS, aspect)


class _Lights:
    """Vertices drawn as dots on top of a surface."""

    def __init__(self) -> None:
        self._mapper = pv.DataSetMapper(pv.PolyData(np.zeros((1, 3), np.float32)))
        self.actor = pv.Actor(mapper=self._mapper)
        self.actor.prop.render_points_as_spheres = True
        self.actor.prop.lighting = False
        self.actor.SetPickable(False)
        self.actor.SetVisibility(False)
        self._scale = 1.0

    def set_look(self, look: Look) -> None:
        """Take the colours and the size of a look."""
        self.actor.prop.color = _LIT_COLOUR[look.theme.dark]
        self._scale = look.text_scale

    def show(self, points: NDArray[np.float32], mask: BoolArray | None) -> None:
        """Draw the vertices of a mask, smaller where there are many."""
        lit = points[mask] if mask is not None and len(mask) == len(points) else points[:0]
        self.actor.SetVisibility(bool(len(lit)))
        if len(lit):
            self._mapper.dataset = pv.PolyData(lit)
            size = float(np.clip(40 / np.sqrt(len(points) ** 0.5), 3, 9))
            self.actor.prop.point_size = (size + 4 * (len(lit) == 1)) * self._scale
