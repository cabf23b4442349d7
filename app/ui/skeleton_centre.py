"""The middle of the Skeleton tab: views, their resolutions, growth, exports, flat drawings."""

from PySide6.QtWidgets import QHBoxLayout, QMenu, QToolButton, QVBoxLayout, QWidget

from app.scene.skeleton_panes import SkeletonLook, SkeletonPane
from app.session import Session
from app.session.skeleton_views import VIEW_COUNT
from app.ui.action_book import ActionBook
from app.ui.skeleton_drawing import FlatDrawing
from app.ui.skeleton_growth import GrowthBar
from app.ui.skeleton_resolution import ResolutionBar
from app.ui.skeleton_viewport import SkeletonViewport

_EXPORTS = ("save_graph", "screenshot", "figure", "save_film", "save_mesh")


class ExportButton(QToolButton):
    """A button with what can be written here; the commands are those of the menus."""

    def __init__(self) -> None:
        super().__init__(text="Export", popupMode=QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setMenu(QMenu(self))

    def offer(self, book: ActionBook) -> None:
        """List the commands."""
        for command in _EXPORTS:
            self.menu().addAction(book[command])


class SkeletonCentre(QWidget):
    """Viewport with a bar for each view below it; the flat drawings stand in a dock."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.viewport = SkeletonViewport()
        self.resolutions = [ResolutionBar(session, view) for view in range(VIEW_COUNT)]
        self.flat = [FlatDrawing() for _ in range(VIEW_COUNT)]
        self.growth = GrowthBar()
        self.exports = ExportButton()
        self.drawings = _row(self.flat)
        self.drawings.layout().setSpacing(2)
        below = QWidget()
        row = QHBoxLayout(below)
        row.setContentsMargins(0, 0, 8, 2)
        row.addWidget(self.growth, 1)
        row.addWidget(self.exports)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.viewport, 1)
        layout.addWidget(_row(self.resolutions))
        layout.addWidget(below)

    def show_panes(self, panes: dict[int, SkeletonPane], look: SkeletonLook) -> None:
        """Draw the graphs flat, and show the bars of the views that are there."""
        for view in range(VIEW_COUNT):
            for widget in (self.resolutions[view], self.flat[view]):
                widget.setVisible(view in panes)
            if view in panes:
                self.flat[view].show_pane(panes[view], look)


def _row(widgets: list[QWidget]) -> QWidget:
    row = QWidget()
    layout = QHBoxLayout(row)
    layout.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        layout.addWidget(widget, 1)
    return row
