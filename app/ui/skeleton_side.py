"""The panel beside the views: their settings, what is drawn, and the numbers."""

from PySide6.QtCore import QSignalBlocker, QSize, Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFrame,
    QLabel,
    QScrollArea,
    QTabBar,
    QVBoxLayout,
    QWidget,
)

from app.scene.skeleton_panes import field_title
from app.session import Session
from app.session.skeleton_views import VIEW_COUNT
from app.ui.skeleton_changes import change_settings, current_view
from app.ui.skeleton_facts import FactsPanel
from app.ui.skeleton_layers import LayersPanel
from app.ui.skeleton_view_panel import ViewPanel


class SkeletonSide(QScrollArea):
    """Settings of the selected view, layers, and facts.

    Signals
    -------
    selected(int) : the view whose tab was chosen.
    """

    selected = Signal(int)

    def __init__(self, session: Session) -> None:
        super().__init__(frameShape=QFrame.Shape.NoFrame, widgetResizable=True)
        self._session = session
        self.compare = QCheckBox("Compare two views")
        self.tabs = QTabBar(expanding=True, drawBase=False)
        self.panels = [ViewPanel(session, view) for view in range(VIEW_COUNT)]
        self.layers, self.facts = LayersPanel(session), FactsPanel()
        for _ in self.panels:
            self.tabs.addTab("")
        self._lay_out()
        self.tabs.currentChanged.connect(self.selected)
        self.compare.toggled.connect(
            lambda on: change_settings(session, "Compare views", compare=on)
        )
        session.study_changed.connect(self._refresh)
        self.select(VIEW_COUNT - 1)
        self._refresh()

    def select(self, view: int) -> None:
        """Show the settings of a view."""
        with QSignalBlocker(self.tabs):
            self.tabs.setCurrentIndex(view)
        for index, panel in enumerate(self.panels):
            panel.setVisible(index == view)

    def show_outcome(self, text: str) -> None:
        """Show what a check of invariance found, where it can be seen."""
        self.facts.show_outcome(text)
        if text:
            # It takes its place only when the panel is laid out anew.
            QTimer.singleShot(0, self, lambda: self.ensureWidgetVisible(self.facts.outcome))

    def minimumSizeHint(self) -> QSize:
        bar = self.verticalScrollBar().sizeHint().width()
        return QSize(self._inside.minimumSizeHint().width() + bar + 2, 200)

    def _lay_out(self) -> None:
        inside = QWidget()
        layout = QVBoxLayout(inside)
        layout.setContentsMargins(10, 6, 10, 10)
        layout.addWidget(self.compare)
        layout.addWidget(self.tabs)
        for panel in self.panels:
            layout.addWidget(panel)
        layout.addWidget(_heading("Drawn in both views"))
        layout.addWidget(self.layers)
        layout.addWidget(_heading("Loops and genus"))
        layout.addWidget(self.facts)
        layout.addStretch()
        self.setWidget(inside)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._inside = inside

    def _refresh(self, *_: object) -> None:
        compare = self._session.study.skeleton.compare
        with QSignalBlocker(self.compare):
            self.compare.setChecked(compare)
        self.tabs.setVisible(compare)
        for view, side in enumerate(("Left", "Right")):
            title = field_title(current_view(self._session, view)).partition(" ")[0]
            self.tabs.setTabText(view, f"{side}: {title}")


def _heading(text: str) -> QLabel:
    label = QLabel(f"<b>{text}</b>")
    label.setContentsMargins(0, 10, 0, 0)
    return label
