"""What a montage shows and where its pictures stand, in centimetres."""

from dataclasses import dataclass
from typing import Literal

from app.export.pictures import PictureError
from app.export.wrapping import wrapped

Ground = Literal["white", "transparent", "theme"]

MARGIN = 0.1
GAP = 0.15
BAR_WIDTH = 0.3
INCH = 2.54
_CAPTION_HEIGHT = 1.7
_NEXT_LINE = 1.4
_BAR_TEXT = 4.2
_TOO_SMALL = "The figure is too small for its panes; make it larger."


@dataclass(frozen=True)
class Entry:
    """What a figure can show: its id, its title, and whether it is chosen to begin with."""

    id: str
    title: str
    chosen: bool = True


@dataclass(frozen=True)
class Cell:
    """One picture of a montage: the pane it shows, and its caption without the letter."""

    pane: str
    caption: str


@dataclass(frozen=True)
class Montage:
    """What a figure shows and how large it is.

    Attributes
    ----------
    cells : tuple of Cell
        The pictures in reading order.
    columns : int
        Most pictures in a row.
    letters : bool
        Whether captions begin with (a), (b), (c).
    bar : bool
        Whether the colour bar stands at the right, where panes are coloured.
    ground : {"white", "transparent", "theme"}
        What is behind everything.
    width, height : float
        Size in centimetres; a height of 0 makes the pictures square.
    dpi : float
        Pixels an inch.
    font_size : float
        Size of the captions in points.
    """

    cells: tuple[Cell, ...]
    columns: int = 3
    letters: bool = True
    bar: bool = True
    ground: Ground = "white"
    width: float = 16.0
    height: float = 0.0
    dpi: float = 300.0
    font_size: float = 9.0

    @property
    def line(self) -> float:
        """Height of the letters in centimetres."""
        return self.font_size * INCH / 72

    @property
    def across(self) -> int:
        """Pictures in a full row."""
        return max(1, min(self.columns, len(self.cells)))

    @property
    def rows(self) -> int:
        """Number of rows."""
        return -(-len(self.cells) // self.across)

    def caption(self, place: int) -> str:
        """Return a caption with its letter; after (z) comes (aa)."""
        text = self.cells[place].caption
        if not self.letters:
            return text
        letter = chr(ord("a") + place % 26)
        return f"({letter * (place // 26 + 1)}) {text}".rstrip()

    def caption_lines(self, place: int, width: float) -> list[str]:
        """Return a caption in lines that fit below a picture `width` centimetres wide."""
        return wrapped(self.caption(place), width, self.font_size)


@dataclass(frozen=True)
class Layout:
    """Where everything stands, in centimetres from the lower left corner."""

    width: float
    height: float
    cell_width: float
    cell_height: float
    step_down: float
    bar_left: float

    def pixels(self, dpi: float) -> tuple[int, int]:
        """Width and height of the figure in pixels."""
        return round(self.width / INCH * dpi), round(self.height / INCH * dpi)

    def cell(self, montage: Montage, place: int) -> tuple[float, float, float, float]:
        """Left, bottom, width and height of a picture; a last row that is not full is centred."""
        row, column = divmod(place, montage.across)
        missing = montage.across - min(montage.across, len(montage.cells) - row * montage.across)
        step = self.cell_width + GAP
        left = MARGIN + (column + missing / 2) * step
        bottom = self.height - MARGIN - row * self.step_down - self.cell_height
        return left, bottom, self.cell_width, self.cell_height


def montage_layout(montage: Montage, *, with_bar: bool) -> Layout:
    """Place the pictures of a montage.

    Raises
    ------
    PictureError
        If there are no pictures, or the size leaves them no room.
    """
    if not montage.cells:
        raise PictureError("The figure has no panes; choose at least one.")
    line = montage.line
    bar = BAR_WIDTH + GAP + _BAR_TEXT * line if with_bar else 0.0
    room = montage.width - 2 * MARGIN - bar - (montage.across - 1) * GAP
    wide = room / montage.across
    if wide < line:
        raise PictureError(_TOO_SMALL)
    lines = max(len(montage.caption_lines(i, wide)) for i in range(len(montage.cells)))
    text = (_CAPTION_HEIGHT + (lines - 1) * _NEXT_LINE) * line
    rest = montage.height - 2 * MARGIN - (montage.rows - 1) * GAP
    high = rest / montage.rows - text if montage.height else wide
    if high < line:
        raise PictureError(_TOO_SMALL)
    step = high + text + GAP
    height = montage.height or montage.rows * step - GAP + 2 * MARGIN
    return Layout(montage.width, height, wide, high, step, montage.width - bar - MARGIN)
