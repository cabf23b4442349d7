"""The command palette: type a few letters of what you want, press Enter."""

from PySide6.QtCore import QAbstractListModel, QEvent, QModelIndex, QObject, QRect, QSize, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPalette
from PySide6.QtWidgets import (
    QDialog,
    QLineEdit,
    QListView,
    QMainWindow,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
)

from app.ui.command_list import Entry, entries
from app.ui.controls import FaintLabel
from app.ui.fuzzy import ranked

_SIZE = QSize(560, 420)
_TOP = 60
_LIST_KEYS = {Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown}


class CommandPalette(QDialog):
    """Searchable list of everything the menus can do."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window, Qt.WindowType.Popup)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._all = entries(window)
        self.line = QLineEdit(placeholderText="Find a command …", clearButtonEnabled=True)
        self.line.setAccessibleName("Find a command")
        self.model = _EntryModel(self)
        self.list = QListView(uniformItemSizes=True, frameShape=QListView.Shape.NoFrame)
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setModel(self.model)
        self.list.setItemDelegate(_EntryDelegate(self.list))
        self.told = FaintLabel()
        self.told.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.told.setMinimumHeight(2 * self.told.fontMetrics().lineSpacing())
        self._lay_out(window)
        self.line.textChanged.connect(self._filter)
        self.line.installEventFilter(self)
        self.list.clicked.connect(self._run)
        self.list.selectionModel().currentChanged.connect(self._tell)
        self._filter("")

    def eventFilter(self, _: QObject, event: QEvent) -> bool:
        if event.type() != QEvent.Type.KeyPress:
            return False
        if event.key() in _LIST_KEYS:
            self.list.keyPressEvent(QKeyEvent(event))
            return True
        if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
            self._run(self.list.currentIndex())
            return True
        return False

    def _lay_out(self, window: QMainWindow) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        layout.setSpacing(6)
        layout.addWidget(self.line)
        layout.addWidget(self.list, 1)
        layout.addWidget(self.told)
        size = _SIZE.boundedTo(window.size())
        corner = window.mapToGlobal(window.rect().topLeft())
        left = corner.x() + (window.width() - size.width()) // 2
        self.setGeometry(left, corner.y() + _TOP, size.width(), size.height())
        self.line.setFocus()

    def _filter(self, text: str) -> None:
        known = self._all
        names, paths, tips = ([getattr(e, part) for e in known] for part in ("name", "path", "tip"))
        places = ranked(text, names, paths, tips)
        self.model.show([self._all[place] for place in places])
        self.list.setCurrentIndex(self.model.index(0))
        self._tell(self.list.currentIndex())

    def _tell(self, index: QModelIndex, _: object = None) -> None:
        """Tell what the current command does, and why where it cannot be used now."""
        entry = index.data(Qt.ItemDataRole.UserRole)
        self.told.setText(entry.tip if entry else "No command fits what is typed.")

    def _run(self, index: QModelIndex) -> None:
        """Close, then do what was chosen; a command that is not possible now stays listed."""
        if not index.isValid():
            return
        entry = self.model.entries[index.row()]
        if entry.usable:
            self.close()
            entry.run()


class _EntryModel(QAbstractListModel):
    """The entries that fit."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.entries: list[Entry] = []

    def show(self, entries: list[Entry]) -> None:
        self.beginResetModel()
        self.entries = entries
        self.endResetModel()

    def rowCount(self, _: QModelIndex | None = None) -> int:
        return len(self.entries)

    def data(self, index: QModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        entry = self.entries[index.row()]
        texts = {
            Qt.ItemDataRole.DisplayRole: entry.path,
            Qt.ItemDataRole.ToolTipRole: entry.tip,
            Qt.ItemDataRole.UserRole: entry,
        }
        return texts.get(role)


class _EntryDelegate(QStyledItemDelegate):
    """Name at the left, the menus pale after it, the key at the right."""

    def sizeHint(self, option: QStyleOptionViewItem, _: QModelIndex) -> QSize:
        return QSize(100, option.fontMetrics.height() + 10)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex) -> None:
        entry: Entry = index.data(Qt.ItemDataRole.UserRole)
        roles = QPalette.ColorRole
        if not entry.usable:
            option.palette.setColor(roles.Highlight, option.palette.color(roles.Mid))
        style = option.widget.style()
        style.drawPrimitive(
            QStyle.PrimitiveElement.PE_PanelItemViewItem, option, painter, option.widget
        )
        chosen = entry.usable and bool(option.state & QStyle.StateFlag.State_Selected)
        pale = option.palette.color(roles.HighlightedText if chosen else roles.PlaceholderText)
        strong = option.palette.color(roles.Text) if entry.usable and not chosen else pale
        room = option.rect.adjusted(8, 0, -8, 0)
        mark = "✓  " if entry.checked else ""
        after = self._write(painter, room, mark + entry.name, strong)
        rest = room.adjusted(after + 14, 0, 0, 0)
        self._write(painter, rest, " › ".join(entry.menus), pale)
        right = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight
        painter.drawText(room, right, entry.key)

    @staticmethod
    def _write(painter: QPainter, room: QRect, text: str, colour: object) -> int:
        """Write a text and return its width."""
        painter.setPen(colour)
        flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.drawText(room, flags, text)
        return painter.fontMetrics().horizontalAdvance(text)
