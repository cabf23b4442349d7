"""What a figure takes its pictures from, on whichever tab they are."""

from collections.abc import Callable, Iterator, Sequence
from typing import Protocol

from matplotlib.figure import FigureBase

from app.export.montage_plan import Entry
from app.export.pictures import Picture
from app.scene.panes import Look

SCREEN_DPI = 96.0

Drawing = Callable[[FigureBase], object]
"""Draws a plot into a part of a figure: without VTK, and so on any thread."""

Drawn = Picture | Drawing
"""What fills a cell of a figure: a picture, or a plot that stays lines and text."""


class PictureSource(Protocol):
    """What a montage takes its pictures from.

    Attributes
    ----------
    look : Look
        Colours, and the colour bar that all pictures share.
    """

    @property
    def look(self) -> Look:
        """Return the colours, and the colour bar that all pictures share."""

    def entries(self) -> tuple[Entry, ...]:
        """Return what a figure can show."""

    def pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Iterator[Drawn]:  # fmt: skip
        """Draw some of the entries in a look: pictures of `size` pixels, and plots."""
