"""The two lines of text above a pane's mesh."""

from pathlib import Path

import matplotlib
import pyvista as pv

from app.scene.panes import Look, Pane

_WARNING = {True: "#ff8a7a", False: "#b3261e"}
_TITLE_SIZE = 13
_CAPTION_SIZE = 12
_MARGIN = 8


class Caption:
    """Title and caption in the upper left corner of a renderer."""

    def __init__(self) -> None:
        self._title = _line(_TITLE_SIZE, bold=True)
        self._caption = _line(_CAPTION_SIZE, bold=False)

    def add_to(self, renderer: pv.Renderer) -> None:
        """Put the text into a renderer."""
        renderer.AddViewProp(self._title)
        renderer.AddViewProp(self._caption)

    def remove_from(self, renderer: pv.Renderer) -> None:
        """Take the text out of a renderer."""
        renderer.RemoveViewProp(self._title)
        renderer.RemoveViewProp(self._caption)

    def show(self, pane: Pane, look: Look, height: float, right: float | None = None) -> None:
        """Write a pane's text.

        `height` is the height of its viewport in pixels; the text ends at `right`, or begins at
        the left edge where that is None.
        """
        scale = look.text_scale
        top = height - _MARGIN * scale
        edge = _MARGIN * scale if right is None else right - _MARGIN * scale
        self._place(self._title, top, int(_TITLE_SIZE * scale), edge)
        below = top - (_TITLE_SIZE + 7) * scale
        self._place(self._caption, below, int(_CAPTION_SIZE * scale), edge)
        for line in (self._title, self._caption):
            justify = "left" if right is None else "right"
            line.prop.justification_horizontal = justify
        self._title.input = pane.title
        self._title.prop.SetColor(pv.Color(pane.colour).float_rgb)
        self._caption.input = pane.caption
        colour = _WARNING[look.theme.dark] if pane.warning else look.theme.ink
        self._caption.prop.SetColor(pv.Color(colour).float_rgb)

    @staticmethod
    def _place(line: pv.Text, top: float, size: int, left: float) -> None:
        line.SetPosition(left, top)
        line.prop.SetFontSize(size)


def text_line(size: int, *, bold: bool = False) -> pv.Text:
    """An empty line of text, hanging from its position."""
    line = pv.Text("", position=(0, 0))
    line.prop = text_style(size, bold=bold)
    line.prop.SetVerticalJustificationToTop()
    return line


def text_style(size: int, *, bold: bool = False) -> pv.TextProperty:
    """Text in a font that has the signs of the field: VTK's own knows neither σ nor ℓ."""
    name = "DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf"
    font = Path(matplotlib.get_data_path()) / "fonts" / "ttf" / name
    return pv.TextProperty(font_file=str(font), font_size=size)


def _line(size: int, *, bold: bool) -> pv.Text:
    line = text_line(size, bold=bold)
    # Pixels, not shares of the viewport, keep the text the same size in every layout.
    line.GetPositionCoordinate().SetCoordinateSystemToViewport()
    return line
