"""The list of a figure's panes: checked, dragged into order, captions written in place."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QAbstractItemView, QListWidget, QListWidgetItem

from app.export.montage_plan import Cell, Entry

_ID = Qt.ItemDataRole.UserRole


class CellList(QListWidget):
    """Panes with their captions; `changed` says that a figure looks different now.

    Parameters
    ----------
    entries : sequence of Entry
        What there is to show.
    """

    changed = Signal()

    def __init__(self, entries: Sequence[Entry]) -> None:
        super().__init__()
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setAccessibleName("Panes of the figure")
        self.setSpacing(2)
        for entry in entries:
            item = QListWidgetItem(entry.title, self)
            item.setData(_ID, entry.id)
            item.setToolTip(f"{entry.title}: the text is its caption")
            item.setFlags(
                (item.flags() | Qt.ItemFlag.ItemIsEditable | Qt.ItemFlag.ItemIsUserCheckable)
                & ~Qt.ItemFlag.ItemIsDropEnabled
            )
            chosen = Qt.CheckState.Checked if entry.chosen else Qt.CheckState.Unchecked
            item.setCheckState(chosen)
        self.itemChanged.connect(lambda _: self.changed.emit())
        self.model().rowsMoved.connect(lambda *_: self.changed.emit())

    def chosen(self) -> tuple[Cell, ...]:
        """Return the checked panes with their captions, in their order."""
        items = [self.item(row) for row in range(self.count())]
        return tuple(
            Cell(item.data(_ID), item.text())
            for item in items
            if item.checkState() == Qt.CheckState.Checked
        )
