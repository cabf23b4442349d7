"""What draws one pane of the grid."""

from dataclasses import fields

import numpy as np
import pyvista as pv

from app.scene.caption import Caption
from app.scene.marks import Marks
from app.scene.panes import Look, Pane
from app.scene.parts import Part
from app.scene.surface import SurfaceActor


class PaneSlot:
    """A renderer with the mesh, the text, the marks and the frame of a pane.

    Attributes
    ----------
    version : int
        Another one after each change of what is to be seen.
    """

    def __init__(self, renderer: pv.Renderer) -> None:
        self.renderer = renderer
        self.version = 0
        self.surface, self.caption = SurfaceActor(), Caption()
        self._marks = Marks()
        self._border = renderer.add_border()
        self._pane: Pane | None = None
        self._look: Look | None = None
        self._size = (0.0, 0.0)
        for actor in (self.surface.actor, self._marks.actor):
            renderer.AddActor(actor)
        self.caption.add_to(renderer)

    def show(
        self, pane: Pane, look: Look, parts: tuple[Part, ...], table: pv.LookupTable,
        size: tuple[float, float],
    ) -> None:  # fmt: skip
        """Draw a pane; `size` is the width that its text has, and the height of its viewport."""
        if size == self._size and looks_same(pane, self._pane) and looks_same(look, self._look):
            return
        self.version += 1
        self._pane, self._look, self._size = pane, look, size
        self.surface.show(pane, look, parts, table)
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
