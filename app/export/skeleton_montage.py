"""Skeletal graphs in a figure, as in figures 5.4 and 5.7–5.15 of the thesis."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.export.montage_plan import Entry
from app.export.montage_source import SCREEN_DPI
from app.export.pictures import Picture, shot, unmix
from app.export.skeleton_pictures import studio
from app.scene.camera import CameraPose
from app.scene.colours import Theme
from app.scene.panes import NO_FACES, Look
from app.scene.skeleton_colours import BAND_MAP
from app.scene.skeleton_grid import SkeletonGrid
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane

_SCALE = "band / R"
# With no-break spaces: "R = 22" stays on one line.
_EQUALS = "\u00a0=\u00a0"
_GROWN = (0.25, 0.5, 0.75)


@dataclass(frozen=True, eq=False)
class FigurePane:
    """One picture of a graph.

    Attributes
    ----------
    entry : Entry
        Its name in the list.
    pane : SkeletonPane
        The graph.
    look : SkeletonLook
        How it is drawn.
    """

    entry: Entry
    pane: SkeletonPane
    look: SkeletonLook


@dataclass(frozen=True, eq=False)
class SkeletonSource:
    """The pictures that a montage can take from the Skeleton tab.

    Attributes
    ----------
    panes : tuple of FigurePane
        All pictures there are.
    theme : Theme
        Colours of the window.
    pose : CameraPose
        Where the camera stands.
    aspect : float
        Width over height of the view the pose was set in; as much is seen in every picture.
    """

    panes: tuple[FigurePane, ...]
    theme: Theme
    pose: CameraPose
    aspect: float

    @property
    def look(self) -> Look:
        """Return the colours and the scale of the bands, which all pictures share."""
        coloured = any(shown.look.settings.show_bands for shown in self.panes)
        return Look(
            NO_FACES, self.theme, colour_title=_SCALE if coloured else "", colour_map=BAND_MAP
        )

    def entries(self) -> tuple[Entry, ...]:
        """Return what a figure can show."""
        return tuple(pane.entry for pane in self.panes)

    def pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Iterator[Picture]:  # fmt: skip
        """Draw some of the entries, each into a picture of `size` pixels."""
        panes = {pane.entry.id: pane for pane in self.panes}
        with studio(size) as grid:
            for id_ in chosen:
                yield self._picture(grid, panes[id_], look, size, dpi, transparent=transparent)

    def _picture(
        self, grid: SkeletonGrid, shown: FigurePane, look: Look, size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Picture:  # fmt: skip
        bare = replace(shown.pane, title="", caption="", note="")
        scale = dpi / SCREEN_DPI
        drawn = replace(shown.look, theme=look.theme, text_scale=scale, legend=False)
        grid.show([bare], drawn, size)
        grid.set_pose(self.pose)
        self._widen(grid, size[0] / size[1])
        if not transparent:
            return shot(grid, look.theme.ground, None)
        return unmix(shot(grid, "black", None), shot(grid, "white", None))

    def _widen(self, grid: SkeletonGrid, aspect: float) -> None:
        """Show as much as the window does, also where the picture is narrower than the view."""
        half = np.tan(np.radians(15.0)) * max(self.aspect / aspect, 1.0)
        grid.camera.SetViewAngle(2 * np.degrees(np.arctan(half)))


def figure_panes(panes: Sequence[SkeletonPane], look: SkeletonLook) -> tuple[FigurePane, ...]:
    """Offer each graph as it is seen, its parts alone, and stages of its growth."""
    look = replace(look, selected=None)
    return tuple(
        picture
        for number, pane in enumerate(panes)
        if pane.skeleton is not None
        for picture in _pictures_of(pane, look, number)
    )


def _pictures_of(pane: SkeletonPane, look: SkeletonLook, number: int) -> list[FigurePane]:
    """The graph as it is seen is chosen to begin with; the others wait unchecked."""
    assert pane.skeleton is not None
    last, title = pane.skeleton.view.resolution, pane.title.replace(" = ", _EQUALS)
    whole = replace(pane, picked=None)
    surface = {"show_graph": False}
    graph = {"show_bands": False, "show_curves": False, "show_shells": False, "opacity": 0.0}
    found = [FigurePane(Entry(f"{number}", title), pane, look)]
    for name, words, update in (("surface", "bands", surface), ("graph", "graph alone", graph)):
        settings = look.settings.model_copy(update=update)
        entry = Entry(f"{number}-{name}", f"{title}, {words}", chosen=False)
        found.append(FigurePane(entry, whole, replace(look, settings=settings)))
    for step in sorted({max(round(share * last), 1) for share in _GROWN}):
        entry = Entry(f"{number}-{step}", f"{title}, {step} bands", chosen=False)
        found.append(FigurePane(entry, replace(whole, step=step), look))
    return found
