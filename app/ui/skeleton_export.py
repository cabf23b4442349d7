"""What the Skeleton tab writes beside pictures: graphs and films."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from app.export.pictures import PictureError
from app.export.skeleton_films import write_film
from app.export.skeleton_pictures import growth_frames, turn_frames
from app.session import Task
from app.ui.dialogs import ask_where_to_save, tell
from app.ui.skeleton_film_dialog import FilmDialog, FilmRequest
from core.skeleton import FORMATS, GraphError, write_graph

if TYPE_CHECKING:
    from app.ui.skeleton_tab import SkeletonTab

_GRAPH_FILTERS = ";;".join(f"{known.title} (*{suffix})" for suffix, known in FORMATS.items())


def ask_for_graph(tab: "SkeletonTab") -> None:
    """Ask where to save the graph of the selected view."""
    skeleton = tab.views.skeleton(tab.selected)
    if skeleton is not None:
        name = f"{_stem(tab)}_{skeleton.view.field}_{skeleton.view.resolution}.graphml"
        _ask(tab, "Save the graph", name, _GRAPH_FILTERS,
             lambda path: write_graph(skeleton.graph, path))  # fmt: skip


def ask_for_film(tab: "SkeletonTab") -> None:
    """Ask what to film, then where to save it."""
    dialog = FilmDialog(tab)

    def wanted(request: FilmRequest) -> None:
        name = f"{_stem(tab)}_{request.subject}{request.suffix}"
        filters = f"{request.suffix[1:].upper()} (*{request.suffix})"
        _ask(tab, "Save the animation", name, filters, lambda path: film(tab, request, path))

    dialog.wanted.connect(wanted)
    dialog.open()


def film(tab: "SkeletonTab", request: FilmRequest, path: Path) -> "FilmWriting":
    """Film the views, one frame whenever the window has nothing else to do."""
    panes, look = tab.panes(tab.devicePixelRatioF())
    look, pose, size = tab.without_frame(look), tab.viewport.grid.pose, tab.viewport.pixel_size()
    if request.subject == "turn":
        frames, count = turn_frames(panes, look, pose, size, request.frames), request.frames
    else:
        frames = growth_frames(panes, look, pose, size)
        count = 1 + max(pane.skeleton.view.resolution for pane in panes if pane.skeleton)
    return FilmWriting(tab, path, write_film(path, frames, request.per_second), count)


class FilmWriting(QObject):
    """Advances a film among the other tasks; one that is cancelled leaves no file."""

    def __init__(self, tab: "SkeletonTab", path: Path, steps: Iterator[int], count: int) -> None:
        super().__init__(tab)
        self._tab, self._path, self._steps = tab, path, steps
        self._written = 0
        self._task = Task(
            title=f"Writing {path.name}",
            share=lambda: self._written / count,
            on_cancel=self._give_up,
        )
        tab.session.tasks.begin(self._task)
        self._timer = QTimer(self, interval=0)
        self._timer.timeout.connect(self._advance)
        self._timer.start()

    def _advance(self) -> None:
        try:
            written = next(self._steps, None)
        except (PictureError, OSError) as error:
            self._end()
            tell(self._tab, str(error))
            return
        if written is not None:
            self._written = written
            return
        self._end()
        self._tab.session.notified.emit(f"Saved {self._path.name}.")
        self._tab.film_written.emit()

    def _give_up(self) -> None:
        self._end()
        self._path.unlink(missing_ok=True)

    def _end(self) -> None:
        self._timer.stop()
        self._steps.close()
        self._tab.session.tasks.end(self._task)
        self.deleteLater()


def _ask(
    tab: "SkeletonTab", title: str, name: str, filters: str, save: Callable[[Path], object]
) -> None:
    def checked(path: Path) -> None:
        try:
            outcome = save(path)
        except (GraphError, PictureError, OSError) as error:
            tell(tab, str(error))
        else:
            if not isinstance(outcome, FilmWriting):
                tab.session.notified.emit(f"Saved {path.name}.")

    ask_where_to_save(tab, title, name, filters, checked)


def _stem(tab: "SkeletonTab") -> str:
    return Path(tab.session.meshes.name).stem
