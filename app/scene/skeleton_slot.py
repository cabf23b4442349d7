"""What draws one pane of the Skeleton tab."""

import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.scene.layout import Viewport
from app.scene.skeleton_caption import SkeletonCaption
from app.scene.skeleton_graph import GraphActors
from app.scene.skeleton_legend import BandLegend
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane
from app.scene.skeleton_shells import ShellActor
from app.scene.skeleton_surface import BandedSurface, CurveActor, PieceActor

_PEELS = 8
_NOWHERE = Viewport(0.0, 0.0, 0.0, 0.0)


class SkeletonSlot:
    """The actors of one pane: the graph in an overlay, so that no surface hides it.

    Attributes
    ----------
    version : int
        Another one after each change of what is to be seen.
    """

    def __init__(self, renderer: pv.Renderer) -> None:
        self.renderer = renderer
        self.version = 0
        self._state: tuple[object, ...] = ()
        self.overlay = vtkRenderer()
        self.overlay.SetLayer(1)
        self.overlay.InteractiveOff()
        self.surface, self.curves, self.piece = BandedSurface(), CurveActor(), PieceActor()
        self.shells, self.graph = ShellActor(), GraphActors()
        self.caption, self.legend = SkeletonCaption(), BandLegend()
        for part in (self.surface, self.curves, self.piece, self.shells):
            renderer.AddActor(part.actor)
        for actor in self.graph.actors:
            self.overlay.AddActor(actor)
        for words in (self.caption, self.legend):
            words.add_to(self.overlay)
        self._frame = renderer.add_border()
        renderer.SetMaximumNumberOfPeels(_PEELS)
        renderer.SetOcclusionRatio(0.0)

    def show(
        self, pane: SkeletonPane, look: SkeletonLook, size: tuple[float, float], *, legend: bool
    ) -> None:
        """Draw a pane in a viewport of `size` pixels."""
        drawn = (pane.skeleton, pane.step, pane.picked, pane.title, pane.caption, pane.warning)
        state = (*drawn, look, size, legend)
        if state == self._state:
            return
        self._state = state
        self.version += 1
        for part in (self.surface, self.curves, self.piece, self.shells, self.graph):
            part.show(pane, look)
        self.caption.show(pane, look, size)
        self.legend.show(pane if legend else None, look, self.surface.table)
        self.legend.place(*size, look.text_scale)
        colour = look.theme.accent if look.selected else look.theme.faint
        self._frame.SetVisibility(look.selected is not None)
        self._frame.GetProperty().SetColor(pv.Color(colour).float_rgb)
        self._frame.GetProperty().SetLineWidth((6 if look.selected else 2) * look.text_scale)

    def place(self, viewport: Viewport | None) -> None:
        """Draw the pane in a viewport, or nowhere."""
        for each in (self.renderer, self.overlay):
            each.SetViewport(viewport or _NOWHERE)
            each.SetDraw(viewport is not None)

    def use(self, camera: pv.Camera) -> None:
        """Look at the pane through a camera."""
        self.renderer.SetActiveCamera(camera)
        # Else PyVista chooses a view of its own at the first picture.
        self.renderer.camera.is_set = True
        self.overlay.SetActiveCamera(camera)
