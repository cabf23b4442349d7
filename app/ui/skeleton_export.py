"""What the Skeleton tab writes beside pictures: graphs and films."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from app.export.skeleton_films import write_film
from app.export.skeleton_pictures import growth_frames, turn_frames
from app.session import Job
from app.ui.dialogs import ask_where_to_save
from app.ui.exporting import Drawer, ask_to_export, at_once, export
from app.ui.skeleton_film_dialog import FilmDialog, FilmRequest
from core.skeleton import FORMATS, write_graph

if TYPE_CHECKING:
    from app.ui.skeleton_tab import SkeletonTab

_GRAPH_FILTERS = ";;".join(f"{known.title} (*{suffix})" for suffix, known in FORMATS.items())


def ask_for_graph(tab: "SkeletonTab") -> None:
    """Ask where to save the graph of the selected view."""
    skeleton = tab.views.skeleton(tab.selected)
    if skeleton is not None:
        name = f"{_stem(tab)}_{skeleton.view.field}_{skeleton.view.resolution}.graphml"
        write = at_once(partial(write_graph, skeleton.graph))
        ask_to_export(tab, tab.session, "Save the graph", name, _GRAPH_FILTERS, write)


def ask_for_film(tab: "SkeletonTab") -> None:
    """Ask what to film, then where to save it."""
    dialog = FilmDialog(tab)

    def wanted(request: FilmRequest) -> None:
        name = f"{_stem(tab)}_{request.subject}{request.suffix}"
        filters = f"{request.suffix[1:].upper()} (*{request.suffix})"
        ask_where_to_save(
            tab, "Save the animation", name, filters, lambda path: film(tab, request, path)
        )

    dialog.wanted.connect(wanted)
    dialog.open()


def film(tab: "SkeletonTab", request: FilmRequest, path: Path) -> Job:
    """Film the views: the window draws a frame at a time, the worker puts it into the file."""
    panes, look = tab.panes(tab.devicePixelRatioF())
    look, pose, size = tab.without_frame(look), tab.viewport.grid.pose, tab.viewport.pixel_size()
    if request.subject == "turn":
        frames, count = turn_frames(panes, look, pose, size, request.frames), request.frames
    else:
        frames = growth_frames(panes, look, pose, size)
        count = 1 + max(pane.skeleton.view.resolution for pane in panes if pane.skeleton)

    def begin(path: Path, drawer: Drawer) -> Iterator[float]:
        written = write_film(path, drawer(frames), request.per_second)
        return (number / count for number in written)

    return export(tab.session, path, begin)


def _stem(tab: "SkeletonTab") -> str:
    return Path(tab.session.meshes.name).stem
