"""What the commands ask of the tab that is shown: one desk a tab, the same questions to each."""

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, NamedTuple

from PySide6.QtCore import QObject, QPointF, Signal

from app.export.montage_panes import Source
from app.export.pictures import Picture
from app.export.statistics_plots import PLOTS
from app.scene.layout import Viewport
from app.ui.actions import TABS
from app.ui.camera_gestures import CameraGestures
from app.ui.screenshot_dialog import Request
from app.ui.stage import Stage
from core.mesh import TriangleMesh

NO_MODEL = "Open a model first."


IS_ON = {title: f"This is on the {title} tab." for title in TABS}
"""Reason why a command cannot be done on another tab, by the tab that can."""

STATISTICS_ONLY = (
    "save_statistics", "save_matrix", *(f"save_plot_{id_}" for id_ in PLOTS),
)  # fmt: skip
"""Commands of the Statistics tab."""


class NamedMesh(NamedTuple):
    """A mesh to save, and the end of its file's name."""

    mesh: TriangleMesh
    name: str


class PictureSubject(NamedTuple):
    """What a screenshot can show: its name and its size in pixels."""

    title: str
    size: tuple[int, int]


class Desk(QObject):
    """One tab as the commands see it.

    Parameters
    ----------
    tab : QWidget
        The tab.
    stage : Stage
        Its drawing area.

    Signals
    -------
    changed() : other commands are possible now.
    """

    changed = Signal()
    lacks: ClassVar[Mapping[str, str]] = {}
    """Commands that the tab cannot do, each with the reason."""

    def __init__(self, tab: Any, stage: Stage) -> None:
        super().__init__(tab)
        self.tab, self.stage = tab, stage
        self.session = tab.session
        self.gestures = CameraGestures(stage)

    def obstacle(self, command: str) -> str:
        """Return why a command cannot be done now, or an empty text."""
        return self.lacks.get(command, "")

    @property
    def flickers(self) -> bool:
        """Whether another mesh is shown in place of one."""
        raise NotImplementedError

    def set_flicker(self, on: bool) -> None:
        """Show another view's mesh in the selected view, or its own again."""
        raise NotImplementedError

    @property
    def swipe_line(self) -> tuple[Viewport, float] | None:
        """The view that a swipe parts, and the place of the line as a share of its width."""
        raise NotImplementedError

    def set_swipe(self, on: bool) -> None:
        """Part a view by a line between two meshes, or show all views again."""
        raise NotImplementedError

    def move_swipe(self, share: float) -> None:
        """Put the line of a swipe elsewhere."""
        raise NotImplementedError

    def describe(self, place: QPointF) -> str:
        """Describe what is seen at a place of the drawing area."""
        raise NotImplementedError

    def enlarge(self) -> None:
        """Enlarge what is selected, or bring all back."""
        raise NotImplementedError

    def mesh(self) -> NamedMesh:
        """Return the mesh of the selected view."""
        raise NotImplementedError

    def montage(self) -> Source:
        """Return what a figure can show."""
        raise NotImplementedError

    def subjects(self) -> dict[str, PictureSubject]:
        """Return what a screenshot can show, by id."""
        raise NotImplementedError

    def picture(self, request: Request, size: tuple[int, int]) -> Iterator[Picture | None]:
        """Return the pieces of what a screenshot shows now, to be drawn at a multiple of `size`."""
        raise NotImplementedError
