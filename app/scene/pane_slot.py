"""What draws one pane of the grid."""

from dataclasses import fields
from typing import NamedTuple

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from app.scene.caption import Caption
from app.scene.marks import Marks
from app.scene.panes import Look, Pane
from app.scene.parts import Part
from app.scene.surface import SurfaceActor
from core.mesh.geometry import bounding_box


class _Content(NamedTuple):
    """What a slot shows, and the width that its text has and the height of its viewport."""

    pane: Pane
    look: Look
    table: pv.LookupTable
    size: tuple[float, float]


class PaneSlot:
    """A renderer with the mesh, the text, the marks and the frame of a pane.

    What it is told to show it prepares when it is drawn: whoever tells many has no wait.

    Attributes
    ----------
    box : (6,) float32 ndarray
        x, y and z of the mesh, each from the least to the largest.
    version : int
        Another one after each change of what is to be seen.
    """

    def __init__(self, renderer: pv.Renderer) -> None:
        self.renderer = renderer
        self.version = 0
        self.surface, self.caption = SurfaceActor(), Caption()
        self._marks = Marks()
        self._border = renderer.add_border()
        self._content: _Content | None = None
        self._is_stale = False
        self.box: NDArray[np.float32] = np.zeros(6, np.float32)
        renderer.AddObserver("StartEvent", self._prepare)
        for actor in (self.surface.actor, self._marks.actor):
            renderer.AddActor(actor)
        self.caption.add_to(renderer)

    def show(
        self, pane: Pane, look: Look, parts: tuple[Part, ...], table: pv.LookupTable,
        size: tuple[float, float],
    ) -> None:  # fmt: skip
        """Draw a pane; `size` is the width that its text has, and the height of its viewport."""
        new, old = _Content(pane, look, table, size), self._content
        if old and size == old.size and looks_same(pane, old.pane) and looks_same(look, old.look):
            return
        self.version += 1
        self.surface.use(parts)
        if old is None or old.pane.points is not pane.points:
            self.box = np.stack(bounding_box(pane.points), axis=1).ravel()
        self._content, self._is_stale = new, True

    def _prepare(self, *_: object) -> None:
        if self._content is None or not self._is_stale:
            self.surface.prepare()
            return
        self._is_stale = False
        pane, look, table, size = self._content
        self.surface.show(pane, look, table)
        self._marks.show(pane, look)
        self.caption.show(pane, look, size[1], width=size[0])
        self._frame(look, selected=look.selected == pane.id)

    def _frame(self, look: Look, *, selected: bool) -> None:
        colour = look.theme.accent if selected else look.theme.faint
        self._border.SetVisibility(look.framed)
        line = self._border.GetProperty()
        line.SetColor(pv.Color(colour).float_rgb)
        line.SetLineWidth((3 if selected else 1) * look.text_scale)


def looks_same(one: Pane | Look | None, other: Pane | Look | None) -> bool:
    """Whether two panes, or two looks, are drawn alike; of arrays only whether they are one."""
    if one is None or other is None:
        return one is other
    names = [field.name for field in fields(one)]
    return all(_is_same(getattr(one, name), getattr(other, name)) for name in names)


def _is_same(one: object, other: object) -> bool:
    arrays = isinstance(one, np.ndarray) or isinstance(other, np.ndarray)
    return one is other or (not arrays and one == other)
