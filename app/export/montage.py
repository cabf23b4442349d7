"""A figure of pictures and plots in a grid with captions (a), (b), (c)."""

from collections.abc import Callable, Iterable
from dataclasses import replace

import matplotlib as mpl
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from app.export.montage_plan import (
    BAR_WIDTH,
    GAP,
    INCH,
    MARGIN,
    Ground,
    Layout,
    Montage,
    montage_layout,
)
from app.export.montage_source import Drawing, Drawn, PictureSource
from app.export.pictures import Picture, PictureError
from app.scene.colours import LIGHT
from app.scene.panes import Look

_LEAST_PLOT = 3.0
# The histogram beside a plot is as wide as its axes allow: each round comes closer.
_ROUNDS = 2
_TOO_SMALL = (
    f"The figure is too small for its plots: each needs {_LEAST_PLOT:g} × {_LEAST_PLOT:g} cm; "
    "make it larger, or its columns fewer."
)
_WHITE = replace(LIGHT, ground="#ffffff", ground_top="#ffffff", panel="#ffffff", ink="#000000")

Box = tuple[float, float, float, float]


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

    Raises
    ------
    PictureError
        If there are no pictures, or the size leaves them no room; before any is drawn.
    """
    look, layout = _grounded(source.look, montage.ground), layout_of(montage, source)
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
    look, layout = _grounded(source.look, montage.ground), layout_of(montage, source)
    wide, high = layout.pixels(montage.dpi)
    # A little more than whole pixels: Matplotlib cuts off what is behind the point.
    inches = (wide + 1e-6) / montage.dpi, (high + 1e-6) / montage.dpi
    figure = Figure(figsize=inches, dpi=montage.dpi)
    figure.set_facecolor("none" if montage.ground == "transparent" else look.theme.ground)
    if pictures is None:
        pictures = montage_pictures(montage, source)
    for place, drawn in enumerate(pictures):
        box = layout.cell(montage, place)
        _fill_cell(figure, layout, box, drawn)
        _caption_cell(figure, montage, layout, place, look.theme.ink)
    _arrange_plots(figure)
    if _has_bar(montage, source):
        _place_bar(figure, montage, layout, look)
    return figure


def layout_of(montage: Montage, source: PictureSource) -> Layout:
    """Place the pictures of a montage, beside the colour bar where the source has one.

    Raises
    ------
    PictureError
        If there are no pictures, or the size leaves them no room.
    """
    return montage_layout(montage, with_bar=_has_bar(montage, source))


def _has_bar(montage: Montage, source: PictureSource) -> bool:
    return montage.bar and bool(source.look.colour_title)


def _grounded(look: Look, ground: Ground) -> Look:
    """Return a look for a figure: no frames, no bar, dark ink unless the theme is wanted."""
    theme = replace(look.theme, ground_top=look.theme.ground) if ground == "theme" else _WHITE
    return replace(look, theme=theme, bar=False, framed=False, selected=None)


def _fill_cell(figure: Figure, layout: Layout, box: Box, drawn: Drawn) -> None:
    if callable(drawn):
        _place_plot(figure, layout, box, drawn)
    else:
        _place_picture(figure, layout, box, drawn)


def _place_picture(figure: Figure, layout: Layout, box: Box, picture: Picture) -> None:
    left, bottom, wide, high = box
    axes = figure.add_axes(
        (left / layout.width, bottom / layout.height, wide / layout.width, high / layout.height)
    )
    axes.set_axis_off()
    axes.imshow(picture, aspect="auto", interpolation="nearest")


def _place_plot(figure: Figure, layout: Layout, box: Box, draw: Drawing) -> None:
    """Draw into a part of the figure, which is the middle of a grid around the cell."""
    left, bottom, wide, high = box
    if min(wide, high) < _LEAST_PLOT:
        raise PictureError(_TOO_SMALL)
    grid = figure.add_gridspec(
        3, 3,
        width_ratios=(left, wide, layout.width - left - wide),
        height_ratios=(layout.height - bottom - high, high, bottom),
    )  # fmt: skip
    draw(figure.add_subfigure(grid[1, 1]))


def _arrange_plots(figure: Figure) -> None:
    """Let axes and their labels fill their cells; once, not anew for each file."""
    engine = ConstrainedLayoutEngine(w_pad=0, h_pad=0, wspace=0, hspace=0)
    for _ in range(_ROUNDS if figure.subfigs else 0):
        engine.execute(figure)


def _caption_cell(figure: Figure, montage: Montage, layout: Layout, place: int, ink: str) -> None:
    left, bottom, wide, _ = layout.cell(montage, place)
    middle = (left + wide / 2) / layout.width
    below = (bottom - 0.35 * montage.line) / layout.height
    figure.text(
        middle, below, "\n".join(montage.caption_lines(place, wide)), ha="center", va="top",
        size=montage.font_size, color=ink,
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
