"""The lines of text above a skeletal graph."""

import pyvista as pv

from app.scene.caption import fitting, put_on_plate, text_line
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane

_SIZES = (13, 12, 12)
_GAP = 7
_MARGIN = 8


class SkeletonCaption:
    """Title, counts and the picked node in the upper left corner of a renderer."""

    def __init__(self) -> None:
        self._lines = [text_line(size, bold=i == 0) for i, size in enumerate(_SIZES)]
        for line in self._lines:
            # Pixels, not shares of the viewport, keep the text the same size in every layout.
            line.GetPositionCoordinate().SetCoordinateSystemToViewport()

    def add_to(self, renderer: pv.Renderer) -> None:
        """Put the text into a renderer."""
        for line in self._lines:
            renderer.AddViewProp(line)

    def show(self, pane: SkeletonPane, look: SkeletonLook, size: tuple[float, float]) -> None:
        """Write a pane's text, smaller where it is wider than its viewport of `size` pixels."""
        top = size[1] - _MARGIN * look.text_scale
        room = size[0] - 2 * _MARGIN * look.text_scale
        texts = (pane.title, pane.caption, pane.note)
        ink = look.theme.ink
        colours = (ink, look.theme.warning if pane.warning else ink, ink)
        for line, height, text, colour in zip(self._lines, _SIZES, texts, colours, strict=True):
            line.input = text
            line.SetPosition(_MARGIN * look.text_scale, top)
            longest = max(text.split("\n"), key=len)
            bold = line is self._lines[0]
            line.prop.SetFontSize(fitting(longest, height * look.text_scale, room, bold=bold))
            line.prop.SetColor(pv.Color(colour).float_rgb)
            line.prop.SetLineSpacing(1.25)
            put_on_plate(line, look.theme)
            top -= (height + _GAP) * look.text_scale
