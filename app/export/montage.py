"""A figure of panes in a grid with captions (a), (b), (c), as in figure 2.10 of the thesis."""

import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Protocol

import matplotlib as mpl
import numpy as np
import pyvista as pv
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from app.export.montage_plan import (
    BAR_WIDTH,
    GAP,
    INCH,
    MARGIN,
    Entry,
    Ground,
    Layout,
    Montage,
    montage_layout,
)
from app.export.pictures import Picture, PictureError, prefer_headless_graphics, shot, unmix
from app.scene.camera import CameraPose
from app.scene.colours import LIGHT, Theme
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from core.whole_files import write_atomically

Drawn = Picture | Callable[[], Picture]
"""A picture, or what draws it without VTK, and so on any thread."""

SUFFIXES = (".png", ".pdf", ".tiff")
SCREEN_DPI = 96.0
_WHITE = replace(LIGHT, ground="#ffffff", ground_top="#ffffff", panel="#ffffff", ink="#000000")


@dataclass(frozen=True, eq=False)
class Source:
    """The panes a montage takes its pictures from.

    Attributes
    ----------
    panes : tuple of Pane
        All panes there are.
    look : Look
        How they are drawn.
    poses : dict of str to CameraPose, or None
        The camera of each pane by its id; None shows the whole models.
    aspect : float
        Width over height of the view the poses were set in; as much is seen in every picture.
    """

    panes: tuple[Pane, ...]
    look: Look
    poses: dict[str, CameraPose] | None = None
    aspect: float = 1.0

    def entries(self) -> tuple[Entry, ...]:
        """Return what a figure can show."""
        return tuple(Entry(pane.id, pane.title) for pane in self.panes)

    def pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Iterator[Picture]:  # fmt: skip
        """Draw panes, each alone and without its text, into pictures of one size."""
        prefer_headless_graphics()
        panes = {pane.id: pane for pane in self.panes}
        plotter = pv.Plotter(
            shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(size)
        )
        try:
            grid = PaneGrid(plotter)
            look = replace(look, text_scale=dpi / SCREEN_DPI)
            for id_ in chosen:
                yield _cell_picture(grid, panes[id_], look, self, size, transparent=transparent)
        finally:
            plotter.close()


class PictureSource(Protocol):
    """What a montage takes its pictures from, on whichever tab they are.

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
        """Draw some of the entries in a look, each into a picture of `size` pixels."""


def montage_pictures(
    montage: Montage, source: PictureSource, draw: Callable[..., Iterable[Drawn]] | None = None
) -> Iterable[Drawn]:
    """Draw the pictures of a montage, one by one.

    Parameters
    ----------
    montage : Montage
        What to show.
    source : PictureSource
        Where the pictures come from.
    draw : callable, optional
        Used in place of the source's own `pictures`, to keep them between calls.
    """
    look, layout = grounded(source.look, montage.ground), _layout(montage, source)
    dots = montage.dpi / INCH
    size = (max(round(layout.cell_width * dots), 1), max(round(layout.cell_height * dots), 1))
    chosen = [cell.pane for cell in montage.cells]
    transparent = montage.ground == "transparent"
    return (draw or source.pictures)(look, chosen, size, montage.dpi, transparent=transparent)


def montage_figure(
    montage: Montage, source: PictureSource, pictures: Iterable[Drawn] | None = None
) -> Figure:
    """Compose a montage; what is shown on the screen and what is saved both come from here.

    Parameters
    ----------
    montage : Montage
        What to show.
    source : PictureSource
        Where the pictures come from.
    pictures : iterable, optional
        Its pictures where they are drawn already.
    """
    look, layout = grounded(source.look, montage.ground), _layout(montage, source)
    dots = montage.dpi / INCH
    inches = [
        _whole_pixels(length * dots) / montage.dpi for length in (layout.width, layout.height)
    ]
    figure = Figure(figsize=(inches[0], inches[1]), dpi=montage.dpi)
    figure.set_facecolor("none" if montage.ground == "transparent" else look.theme.ground)
    if pictures is None:
        pictures = montage_pictures(montage, source)
    for place, drawn in enumerate(pictures):
        _place_picture(figure, montage, layout, place, finished(drawn), look.theme)
    if _has_bar(montage, source):
        _place_bar(figure, montage, layout, look)
    return figure


def write_montage(
    montage: Montage, source: PictureSource, path: Path, pictures: Iterable[Drawn]
) -> Iterator[float]:
    """Write a montage of pictures that are being drawn; yield the share that is done.

    Raises
    ------
    PictureError
        As :func:`save_montage`.
    """
    kept: list[Drawn] = []
    for drawn in pictures:
        kept.append(finished(drawn))
        yield len(kept) / (len(montage.cells) + 1)
    save_montage(montage_figure(montage, source, kept), path)
    yield 1.0


def finished(drawn: Drawn) -> Picture:
    """Return a picture, drawing what is not drawn yet."""
    return drawn() if callable(drawn) else drawn


def _has_bar(montage: Montage, source: PictureSource) -> bool:
    return montage.bar and bool(source.look.colour_title)


def _layout(montage: Montage, source: PictureSource) -> Layout:
    return montage_layout(montage, with_bar=_has_bar(montage, source))


def _whole_pixels(length: float) -> float:
    """Round to pixels, a little up, since Matplotlib cuts off what is behind the point."""
    return round(length) + 1e-6


def grounded(look: Look, ground: Ground) -> Look:
    """Return a look for a figure: no frames, no bar, dark ink unless the theme is wanted."""
    theme = replace(look.theme, ground_top=look.theme.ground) if ground == "theme" else _WHITE
    return replace(look, theme=theme, bar=False, framed=False, selected=None)


def montage_pixels(figure: Figure) -> Picture:
    """Draw a montage's figure into pixels, (height, width, 4)."""
    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    picture: Picture = np.asarray(canvas.buffer_rgba()).copy()
    return picture


def save_montage(figure: Figure, path: Path) -> None:
    """Write a montage's figure as PNG, TIFF or PDF, by the suffix; captions of a PDF stay text.

    Raises
    ------
    PictureError
        If the suffix is another, or the file cannot be written.
    """
    suffix = ".tiff" if path.suffix.lower() == ".tif" else path.suffix.lower()
    if suffix not in SUFFIXES:
        allowed = " ".join(SUFFIXES)
        raise PictureError(f"{path.name}: figures are not written in this format; use {allowed}.")
    # No date: the same study gives the same file.
    metadata = {"CreationDate": None} if suffix == ".pdf" else None
    extra: dict[str, Any] = {"pil_kwargs": {"compression": "tiff_lzw"}} if suffix == ".tiff" else {}
    buffer = io.BytesIO()
    with mpl.rc_context({"pdf.fonttype": 42}):
        figure.savefig(buffer, format=suffix[1:], dpi=figure.dpi, metadata=metadata, **extra)
    try:
        write_atomically(path, buffer.getvalue())
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise PictureError(f"{path} cannot be written: {reason}.") from error


def _cell_picture(
    grid: PaneGrid, pane: Pane, look: Look, source: Source, size: tuple[int, int],
    *, transparent: bool,
) -> Picture:  # fmt: skip
    grid.show([replace(pane, title="", caption="")], look, size)
    _aim(grid, pane.id, source, size[0] / size[1])
    if not transparent:
        return shot(grid, look.theme.ground, None)
    return unmix(shot(grid, "black", None), shot(grid, "white", None))


def _aim(grid: PaneGrid, pane: str, source: Source, aspect: float) -> None:
    """Show as much as the window does, also where the picture is narrower than the pane."""
    camera = grid.renderer(pane).GetActiveCamera()
    camera.SetViewAngle(30.0)
    if source.poses is None:
        grid.look_from("Oblique")
        return
    grid.set_poses([source.poses[pane]])
    if aspect < source.aspect:
        half = np.tan(np.radians(15.0)) * source.aspect / aspect
        camera.SetViewAngle(2 * np.degrees(np.arctan(half)))


def _place_picture(
    figure: Figure, montage: Montage, layout: Layout, place: int, picture: Picture, theme: Theme
) -> None:
    left, bottom, wide, high = layout.cell(montage, place)
    shares = left / layout.width, bottom / layout.height, wide / layout.width, high / layout.height
    axes = figure.add_axes(shares)
    axes.set_axis_off()
    axes.imshow(picture, aspect="auto", interpolation="nearest")
    middle = (left + wide / 2) / layout.width
    below = (bottom - 0.35 * montage.line) / layout.height
    figure.text(
        middle, below, "\n".join(montage.caption_lines(place, wide)), ha="center", va="top",
        size=montage.font_size, color=theme.ink,
    )  # fmt: skip


def _place_bar(figure: Figure, montage: Montage, layout: Layout, look: Look) -> None:
    """Draw the colour bar as high as two thirds of the pictures, its title on top."""
    top = layout.height - MARGIN
    bottom = layout.cell(montage, len(montage.cells) - 1)[1]
    high = 0.66 * (top - bottom)
    left = layout.bar_left + GAP
    middle = (top + bottom) / 2
    axes = figure.add_axes(
        (left / layout.width, (middle - high / 2) / layout.height,
         BAR_WIDTH / layout.width, high / layout.height)
    )  # fmt: skip
    mappable = mpl.cm.ScalarMappable(Normalize(*look.colour_range), look.colour_map)
    bar = figure.colorbar(mappable, cax=axes)
    bar.outline.set_linewidth(0.4)
    bar.outline.set_edgecolor(look.theme.ink)
    axes.tick_params(labelsize=0.8 * montage.font_size, colors=look.theme.ink, width=0.4, length=2)
    title = look.colour_title.replace(" (", "\n(").replace("\n\n", "\n")
    figure.text(
        (layout.width - MARGIN) / layout.width, (middle + high / 2 + GAP) / layout.height,
        title, ha="right", va="bottom", size=0.8 * montage.font_size, color=look.theme.ink,
    )  # fmt: skip
