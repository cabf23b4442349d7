"""The two lines of text above a pane's mesh."""

from functools import cache
from pathlib import Path

import matplotlib
import numpy as np
import pyvista as pv
from PIL import ImageFont

from app.scene.colours import Theme
from app.scene.panes import Look, Pane

_TITLE_SIZE = 13
_CAPTION_SIZE = 12
_MARGIN = 8
_MEASURED_SIZE = 100
_SMALLEST = 0.66
_LINE_SPACING = 1.2
PART_GAP = "   "
"""What stands between the parts of a caption that are on one line."""
PLATE_OPACITY = 0.9
"""Of the ground behind text: little enough to guess what lies below, enough to read any ink."""


class Caption:
    """Title and caption in the upper left corner of a renderer."""

    def __init__(self) -> None:
        self._title = _line(_TITLE_SIZE, bold=True)
        self._caption = _line(_CAPTION_SIZE, bold=False)
        self._caption.prop.SetLineSpacing(_LINE_SPACING)

    def add_to(self, renderer: pv.Renderer) -> None:
        """Put the text into a renderer."""
        renderer.AddViewProp(self._title)
        renderer.AddViewProp(self._caption)

    def remove_from(self, renderer: pv.Renderer) -> None:
        """Take the text out of a renderer."""
        renderer.RemoveViewProp(self._title)
        renderer.RemoveViewProp(self._caption)

    def show(
        self,
        pane: Pane,
        look: Look,
        height: float,
        right: float | None = None,
        width: float | None = None,
    ) -> None:
        """Write a pane's text.

        `height` is the height of its viewport in pixels; the text ends at `right`, or begins at
        the left edge where that is None. A caption that is wider than `width` gets more lines, and
        what is still wider is written smaller.
        """
        scale = look.text_scale
        top = height - _MARGIN * scale
        edge = _MARGIN * scale if right is None else right - _MARGIN * scale
        room = np.inf if width is None else width - 2 * _MARGIN * scale
        below = top - (_TITLE_SIZE + 7) * scale
        self._place(
            self._title, top, fitting(pane.title, _TITLE_SIZE * scale, room, bold=True), edge
        )
        caption = parted(pane.caption, _CAPTION_SIZE * scale, room)
        widest = max(caption.split("\n"), key=len)
        size = fitting(widest, _CAPTION_SIZE * scale, room)
        self._place(self._caption, below, size, edge)
        for line in (self._title, self._caption):
            line.prop.justification_horizontal = "left" if right is None else "right"
        self._title.input = pane.title
        self._title.prop.SetColor(pv.Color(pane.colour).float_rgb)
        self._caption.input = caption
        colour = look.theme.warning if pane.warning else look.theme.ink
        self._caption.prop.SetColor(pv.Color(colour).float_rgb)
        for line in (self._title, self._caption):
            put_on_plate(line, look.theme)

    @staticmethod
    def _place(line: pv.Text, top: float, size: int, left: float) -> None:
        line.SetPosition(left, top)
        line.prop.SetFontSize(size)


def parted(text: str, size: float, room: float) -> str:
    """Put the parts of a caption below each other where they do not fit beside each other."""
    first, *others = text.split(PART_GAP)
    lines = [first]
    for part in others:
        joined = f"{lines[-1]}{PART_GAP}{part}"
        if text_width(joined, size) <= room:
            lines[-1] = joined
        else:
            lines.append(part)
    return "\n".join(lines)


def fitting(text: str, size: float, room: float, *, bold: bool = False) -> int:
    """Size of the letters at which a text fits into a width; never less than two thirds."""
    wide = text_width(text, size, bold=bold)
    return int(size * min(1.0, max(room / max(wide, 1e-9), _SMALLEST)))


def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """Width of a text whose letters have a size, in the unit of that size."""
    return float(_measure(bold).getlength(text)) / _MEASURED_SIZE * size


@cache
def _measure(bold: bool) -> ImageFont.FreeTypeFont:
    """A font to measure text by, at a size where rounding does not matter."""
    return ImageFont.truetype(_font_file(bold=bold), _MEASURED_SIZE)


def put_on_plate(line: pv.Text, theme: Theme) -> None:
    """Let the ground show behind a text, so that it can be read whatever mesh lies below it."""
    line.prop.SetBackgroundColor(pv.Color(theme.ground_top).float_rgb)
    line.prop.SetBackgroundOpacity(PLATE_OPACITY)


def text_line(size: int, *, bold: bool = False) -> pv.Text:
    """An empty line of text, hanging from its position."""
    line = pv.Text("", position=(0, 0))
    line.prop = text_style(size, bold=bold)
    line.prop.SetVerticalJustificationToTop()
    return line


def text_style(size: int, *, bold: bool = False) -> pv.TextProperty:
    """Text in a font that has the signs of the field: VTK's own knows neither σ nor ℓ."""
    return pv.TextProperty(font_file=_font_file(bold=bold), font_size=size)


def _font_file(*, bold: bool) -> str:
    name = "DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf"
    return str(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / name)


def _line(size: int, *, bold: bool) -> pv.Text:
    line = text_line(size, bold=bold)
    # Pixels, not shares of the viewport, keep the text the same size in every layout.
    line.GetPositionCoordinate().SetCoordinateSystemToViewport()
    return line
