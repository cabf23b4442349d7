"""The grid of panes: one renderer a pane, linked cameras, one shared colour bar."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkActor

from app.scene.camera import CameraPose, distance_to, preset_pose
from app.scene.clipping import SteadyBox
from app.scene.colour_bar import ColourBar
from app.scene.due import Seen
from app.scene.layout import Viewport, tile
from app.scene.pane_slot import PaneSlot
from app.scene.panes import Look, Pane
from app.scene.parts import Part, parts_of
from app.scene.surface import lookup_table
from app.scene.swipe import Swipe, SwipeLayer
from core.mesh.topology import Topology

CAPACITY = 9
GRID_SHAPE = (2, 5)
"""Shape a plotter needs: nine panes and the colour bar."""

_BAR_PIXELS = 124.0
_NOWHERE = Viewport(0.0, 0.0, 0.0, 0.0)


class PaneGrid:
    """Draws panes into a PyVista plotter, on a screen or off it.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Made with ``shape=GRID_SHAPE, border=False``.
    """

    def __init__(self, plotter: pv.BasePlotter) -> None:
        self.plotter = plotter
        self.viewports: dict[str, Viewport] = {}
        self.enlarged: str | None = None
        self.swipe: Swipe | None = None
        self._renderers = list(plotter.renderers)[:CAPACITY]
        self._bar_renderer = list(plotter.renderers)[CAPACITY]
        self._slots = [PaneSlot(renderer) for renderer in self._renderers]
        self._swiped = SwipeLayer()
        self._bar = ColourBar()
        self._bar.add_to(self._bar_renderer)
        self._scale: tuple[object, ...] = ()
        self._bar_version = 0
        self._box = SteadyBox()
        self._parts: tuple[Topology, tuple[Part, ...]] | None = None
        self._panes: list[Pane] = []
        self._look: Look | None = None
        self._linked = True
        self._narrowest = 1.0
        self._share_camera(pv.Camera())

    def show(self, panes: Sequence[Pane], look: Look, size: tuple[int, int]) -> None:
        """Draw the panes in a window of `size` pixels; at most :data:`CAPACITY`."""
        self._panes, self._look = list(panes[:CAPACITY]), look
        self._arrange(look, size)
        table = lookup_table(look.colour_range, look.colour_map)
        self._show_bar(look, table)
        parts = self._shared_parts(look.topology)
        for slot, pane in zip(self._slots, self._panes, strict=False):
            if pane.id in self.viewports:
                width, height = self.viewports[pane.id].pixels(*size)[2:]
                mark = look.selected if look.selected == pane.id else None
                room = width / (1 + bool(self.swipe)), height
                slot.show(pane, replace(look, selected=mark, histogram=None), parts, table, room)
        self._show_swipe(look, parts, table, size)

    def seen(self) -> list[Seen]:
        """Return what the window shows, for whoever draws only what is new."""
        views = [
            Seen((slot.renderer,), slot.version, self._parts_in(pane.id, slot))
            for slot, pane in zip(self._slots, self._panes, strict=False)
            if pane.id in self.viewports
        ]
        if self._bar_renderer.GetViewport() != _NOWHERE:
            views.append(Seen((self._bar_renderer,), self._bar_version))
        return views

    def _parts_in(self, pane: str, slot: PaneSlot) -> list[vtkActor]:
        """Parts of the meshes in a pane: of two where a line parts it."""
        other = self._swiped.surface.part_actors if self.swipe and self.swipe.left == pane else []
        return slot.surface.part_actors + other

    def set_ground(self, bottom: str, top: str | None) -> None:
        """Colour the background, with a gradient if `top` is given."""
        for renderer in (*self._renderers, self._bar_renderer):
            renderer.set_background(bottom, top=top)

    @property
    def panes(self) -> list[Pane]:
        """Panes as they were drawn last."""
        return list(self._panes)

    @property
    def look(self) -> Look | None:
        """How they were drawn last."""
        return self._look

    @property
    def ids(self) -> list[str]:
        """Ids of the panes in their order."""
        return [pane.id for pane in self._panes]

    def pane_size(self, size: tuple[int, int]) -> tuple[float, float]:
        """Width and height of the first pane in a window of `size` pixels."""
        port = next(iter(self.viewports.values()), Viewport(0.0, 0.0, 1.0, 1.0))
        return port.pixels(*size)[2:]

    def pane_at(self, x: float, y: float) -> str | None:
        """Return the pane at a point, in shares of the window from the lower left corner."""
        return next((id_ for id_, port in self.viewports.items() if port.holds(x, y)), None)

    def mesh_at(self, x: float, y: float) -> str | None:
        """Return the pane whose mesh is seen at a point, either side of a swipe's line."""
        pane = self.pane_at(x, y)
        if self.swipe is None or pane is None:
            return pane
        port = self.viewports[pane]
        on_right = x >= port.left + self.swipe.share * (port.right - port.left)
        return self.swipe.right if on_right else self.swipe.left

    def renderer(self, pane: str) -> pv.Renderer:
        """Return the renderer of a pane."""
        return self._renderers[self.ids.index(pane)]

    @property
    def linked(self) -> bool:
        """Whether all panes share one camera."""
        return self._linked

    def link(self, linked: bool, leader: str | None = None) -> None:
        """Share one camera between all panes, or give each its own; no view jumps.

        On linking, all panes take the view of `leader`, the first pane if it is None.
        """
        self._linked = linked
        if linked:
            first = self.ids.index(leader) if leader in self.ids else 0
            self._share_camera(self._renderers[first].GetActiveCamera())
            return
        for renderer in self._renderers:
            camera = pv.Camera()
            camera.DeepCopy(renderer.GetActiveCamera())
            self._use(renderer, camera)

    def poses(self) -> list[CameraPose]:
        """Return the pose of every camera, pane by pane."""
        return [CameraPose.of(renderer.GetActiveCamera()) for renderer in self._renderers]

    def set_poses(self, poses: Sequence[CameraPose]) -> None:
        """Put the cameras into poses; one pose serves all panes."""
        every = list(poses) * (CAPACITY if len(poses) == 1 else 1)
        for renderer, pose in zip(self._renderers, every, strict=True):
            pose.apply(renderer.GetActiveCamera())
        self.fit_clipping()

    def look_from(self, preset: str) -> None:
        """Show the whole of the first pane's model from a preset direction."""
        if self._panes:
            points = self._panes[0].points
            radius = float(np.linalg.norm(points, axis=1).max())
            self.set_poses([preset_pose(preset, points, radius, self._narrowest)])

    def fit_clipping(self) -> None:
        """Set the clipping ranges from the union of all panes, which a shared camera needs."""
        shown = self._slots[: len(self._panes)]
        if not shown:
            return
        box = self._box.around([slot.box for slot in shown])
        for renderer in self._renderers:
            renderer.ResetCameraClippingRange(box)
        self._swiped.cut(self._narrowest)

    def _share_camera(self, camera: pv.Camera) -> None:
        for renderer in self._renderers:
            self._use(renderer, camera)

    @staticmethod
    def _use(renderer: pv.Renderer, camera: pv.Camera) -> None:
        renderer.SetActiveCamera(camera)
        # Else PyVista chooses a view of its own at the first picture.
        renderer.camera.is_set = True

    def _shared_parts(self, topology: Topology) -> tuple[Part, ...]:
        if self._parts is None or self._parts[0] is not topology:
            self._parts = topology, parts_of(topology)
        return self._parts[1]

    def _arrange(self, look: Look, size: tuple[int, int]) -> None:
        """Give each shown pane its viewport; the others get none."""
        width, height = size
        has_bar = look.bar and bool(look.colour_title)
        bar = _BAR_PIXELS * look.text_scale / max(width, 1) if has_bar else 0.0
        right = 1 - min(bar, 0.4)
        if self.enlarged not in self.ids:
            self.enlarged = None
        if self.swipe and not {self.swipe.left, self.swipe.right} <= set(self.ids):
            self.swipe = None
        alone = self.swipe.left if self.swipe else self.enlarged
        shown = [alone] if alone else self.ids
        ports = tile(len(shown), width / max(height, 1), right)
        self.viewports = dict(zip(shown, ports, strict=True))
        sides = [port.pixels(width, max(height, 1))[2:] for port in ports]
        self._keep_fitting(min((wide / max(high, 1) for wide, high in sides), default=1.0))
        places = [self.viewports.get(id_, _NOWHERE) for id_ in self.ids]
        places += [_NOWHERE] * (CAPACITY - len(places))
        bar_place = Viewport(right, 0.0, 1.0, 1.0) if bar else _NOWHERE
        every = zip((*self._renderers, self._bar_renderer), (*places, bar_place), strict=True)
        for renderer, place in every:
            renderer.SetViewport(place)
            renderer.SetDraw(place != _NOWHERE)
        self._bar_renderer.InteractiveOff()

    def _keep_fitting(self, narrowest: float) -> None:
        """Step back where panes have become narrower, closer where they are wider again."""
        before, after = (distance_to(1.0, aspect) for aspect in (self._narrowest, narrowest))
        self._narrowest = narrowest
        for renderer in self._renderers[: 1 if self._linked else CAPACITY]:
            renderer.GetActiveCamera().Dolly(before / after)

    def _show_bar(self, look: Look, table: pv.LookupTable) -> None:
        histogram = None if look.histogram is None else tuple(look.histogram.tolist())
        ends = look.colour_title, look.colour_range, look.colour_map
        scale = (*ends, histogram, look.theme, look.text_scale)
        if scale != self._scale:
            self._scale = scale
            self._bar_version += 1
            self._bar.show(look, table)

    def _show_swipe(
        self, look: Look, parts: tuple[Part, ...], table: pv.LookupTable, size: tuple[int, int]
    ) -> None:
        if self.swipe is None:
            self._swiped.hide()
            return
        left, right = (self.ids.index(id_) for id_ in (self.swipe.left, self.swipe.right))
        pixels = self.viewports[self.swipe.left].pixels(*size)[2:]
        self._slots[left].version += 1
        self._swiped.show(
            self._renderers[left], self._slots[left].surface, self.swipe, self._panes[right],
            look, parts, table, pixels,
        )  # fmt: skip
