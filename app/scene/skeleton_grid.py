"""One or two panes with skeletal graphs on translucent surfaces, seen by one camera."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pyvista as pv

from app.scene.camera import CameraPose
from app.scene.clipping import SteadyBox
from app.scene.due import Seen
from app.scene.layout import Viewport
from app.scene.parted_camera import PartedCamera, parted
from app.scene.skeleton_camera import fitting_pose
from app.scene.skeleton_graph import node_radius
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane, grown_nodes
from app.scene.skeleton_slot import SkeletonSlot
from core.arrays import FloatArray

SHAPE = (1, 2)
"""Shape a plotter needs."""

_CLICK_PIXELS = 9.0


class SkeletonGrid:
    """Draws panes into a PyVista plotter, on a screen or off it.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Made with ``shape=SHAPE, border=False``.
    """

    def __init__(self, plotter: pv.BasePlotter) -> None:
        self.plotter = plotter
        self.viewports: list[Viewport] = []
        self._panes: list[SkeletonPane] = []
        self._look: SkeletonLook | None = None
        self._slots = [SkeletonSlot(renderer) for renderer in plotter.renderers]
        window = plotter.render_window
        # Multisampling hides translucent surfaces under depth peeling.
        window.SetMultiSamples(0)
        window.SetAlphaBitPlanes(True)
        window.SetNumberOfLayers(2)
        self.set_precise(True)
        self._camera = PartedCamera()
        self._box = SteadyBox()
        for slot in self._slots:
            window.AddRenderer(slot.overlay)
        self._share_camera()

    def show(
        self, panes: Sequence[SkeletonPane], look: SkeletonLook, size: tuple[int, int]
    ) -> None:
        """Draw one or two panes side by side in a window of `size` pixels."""
        self._panes, self._look = list(panes), look
        if len(panes) < len(self._slots):
            self.part(None)
        self.viewports = self._places(len(panes))
        spare = [None] * (len(self._slots) - len(panes))
        for slot, viewport in zip(self._slots, [*self.viewports, *spare], strict=True):
            slot.place(viewport)
        for index, pane in enumerate(self._panes):
            marked = index == look.selected and len(panes) > 1
            mark = look if look.selected is None else replace(look, selected=int(marked))
            part = self.viewports[index].pixels(*size)[2:]
            # Two parts of one picture have one legend, away from the line between them.
            legend = look.legend and (self.share is None or index == 1)
            self._slots[index].show(pane, mark, part, legend=legend)
        self.set_precise(self.precise, coarse=self._coarse)

    def seen(self) -> list[Seen]:
        """Return what the window shows, for whoever draws only what is new."""
        slots = self._slots[: len(self._panes)]
        return [Seen((slot.renderer, slot.overlay), slot.version) for slot in slots]

    def part(self, share: float | None) -> None:
        """Show both panes as one, parted by a line at a share of the width; None as two."""
        self._camera.part(share)
        self._share_camera()

    @property
    def share(self) -> float | None:
        """Place of the line that parts the panes, or None."""
        return self._camera.share

    @property
    def camera(self) -> pv.Camera:
        """The camera, of the left pane where they are parted by a line."""
        return self._camera.shown[0]

    def renderer(self, pane: int) -> pv.Renderer:
        """Return the renderer of a pane's surface."""
        return self._slots[pane].renderer

    def set_precise(self, precise: bool, *, coarse: bool = True) -> None:
        """Choose between exact drawing and a fast one while something moves.

        Translucent layers are blended one by one, by depth peeling, or all at once by weights.
        Neither depends on the order of the faces, so both are right from every side; peeling has
        the exact colours where many layers lie behind each other, weights are several times
        faster. With `coarse`, large surfaces are drawn by a coarse copy meanwhile.
        """
        self.precise, self._coarse = precise, coarse
        for slot in self._slots:
            slot.renderer.SetUseDepthPeeling(precise)
            slot.surface.set_precise(precise or not coarse)

    def set_ground(self, bottom: str, top: str | None) -> None:
        """Colour the background, with a gradient if `top` is given."""
        for slot in self._slots:
            slot.renderer.set_background(bottom, top=top)

    @property
    def pose(self) -> CameraPose:
        """Where the camera stands."""
        return self._camera.pose

    def set_pose(self, pose: CameraPose) -> None:
        """Put the camera into a pose."""
        self._camera.set_pose(pose)
        self.fit_clipping()

    def look_from(self, preset: str, size: tuple[int, int]) -> None:
        """Show the whole model from a preset direction."""
        points = [
            pane.skeleton.mesh.vertices - pane.centre for pane in self._panes if pane.skeleton
        ]
        if points:
            views = 1 if self.share is not None else len(self._panes)
            aspect = size[0] / views / max(size[1], 1)
            self.set_pose(fitting_pose(preset, np.vstack(points), aspect))

    def fit_clipping(self) -> None:
        """Set the clipping range from all that is shown, since the camera is shared."""
        self._camera.follow()
        bounds = [
            slot.renderer.ComputeVisiblePropBounds()
            for slot, _ in zip(self._slots, self._panes, strict=False)
        ]
        valid = [b for b in bounds if b[0] <= b[1]]
        if not valid:
            return
        box = self._box.around(valid)
        for slot in self._slots:
            slot.renderer.ResetCameraClippingRange(box)

    def pane_at(self, x: float, y: float) -> int | None:
        """Return the pane at a point, in shares of the window from the lower left corner."""
        return next((i for i, port in enumerate(self.viewports) if port.holds(x, y)), None)

    def node_at(self, pane: int, x: float, y: float, size: tuple[int, int]) -> int | None:
        """Return the node at a point of a pane, in shares of a window of `size` pixels."""
        shown, look = self._panes[pane], self._look
        if shown.skeleton is None or look is None or not look.settings.show_graph:
            return None
        grown = np.flatnonzero(grown_nodes(shown.skeleton.graph, shown.step))
        places, depths, pixels = self._project(pane, size)
        distances = np.linalg.norm(places[grown] - np.array([x, y]) * size, axis=1)
        radius = node_radius(shown.skeleton, look.settings.node_size)
        reach = np.maximum(radius * pixels[grown], _CLICK_PIXELS * look.text_scale)
        hit = np.flatnonzero(distances < reach)
        return (
            int(grown[hit[np.argmin(distances[hit] + 1e-3 * depths[grown][hit])]])
            if len(hit)
            else None
        )

    def _share_camera(self) -> None:
        for slot, camera in zip(self._slots, self._camera.shown, strict=True):
            slot.use(camera)

    def _places(self, count: int) -> list[Viewport]:
        if self.share is not None:
            return parted(self.share)
        return [Viewport(i / count, 0.0, (i + 1) / count, 1.0) for i in range(count)]

    def _project(
        self, pane: int, size: tuple[int, int]
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Pixels of a pane's nodes, their depths, and pixels per model unit at each."""
        shown, port = self._panes[pane], self.viewports[pane]
        assert shown.skeleton is not None
        _, _, width, height = port.pixels(*size)
        camera = self._camera.shown[pane]
        matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
        rows = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        points = shown.skeleton.graph.nodes - shown.centre
        clip = np.column_stack([points, np.ones(len(points))]) @ rows.T
        share = clip[:, :2] / clip[:, 3:] / 2 + 0.5
        places = share * (width, height) + (port.left * size[0], port.bottom * size[1])
        scale = height / 2 / np.tan(np.radians(camera.GetViewAngle() / 2)) / clip[:, 3]
        return places, clip[:, 3], scale
