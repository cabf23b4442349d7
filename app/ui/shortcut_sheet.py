"""The sheet of shortcuts: every key and mouse gesture, searchable, changed in the preferences."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QHeaderView,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.ui.actions import COMMANDS, Command
from app.ui.command_list import plain
from app.ui.controls import FaintLabel
from app.ui.fuzzy import begins_a_word, score
from app.ui.shortcuts import Shortcuts

_NATIVE = QKeySequence.SequenceFormat.NativeText
_GESTURES = (
    ("Turn", "Left drag"),
    ("Move sideways", "Shift + left drag, middle drag"),
    ("Come closer, go away", "Wheel, right drag"),
    ("Select a pane", "Click"),
    ("Enlarge a pane, bring all back", "Double click"),
    ("Move the swipe line", "Drag the line"),
    ("Open a model", "Drop a file on the window"),
)


class ShortcutTable(QWidget):
    """All commands with their keys, by menu, under a line to search in.

    Parameters
    ----------
    shortcuts : Shortcuts
        The keys.
    """

    def __init__(self, shortcuts: Shortcuts) -> None:
        super().__init__()
        self.shortcuts = shortcuts
        self.search = QLineEdit(placeholderText="Find a command or a key …")
        self.search.setClearButtonEnabled(True)
        self.tree = QTreeWidget(columnCount=2, rootIsDecorated=False, uniformRowHeights=True)
        self.tree.setHeaderLabels(["Command", "Key"])
        self.tree.setStyleSheet("QTreeView::item { padding: 2px 8px 2px 0; }")
        self.tree.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.tree.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        self.tree.header().setStretchLastSection(False)
        self.nothing = FaintLabel("No command or key fits what is typed.")
        self.nothing.hide()
        self.items: dict[str, QTreeWidgetItem] = {}
        self._fill()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.search)
        layout.addWidget(self.nothing)
        layout.addWidget(self.tree, 1)
        self.search.textChanged.connect(self._filter)
        self.refresh()

    def refresh(self) -> None:
        """Show the keys as they are now; a changed one in bold."""
        for command in COMMANDS:
            item = self.items[command.id]
            item.setText(1, self.shortcuts.key(command.id).toString(_NATIVE))
            font = item.font(1)
            font.setBold(self.shortcuts.is_changed(command))
            item.setFont(1, font)

    def command(self) -> Command | None:
        """Return the command of the current row."""
        current = self.tree.currentItem()
        found = (c for c in COMMANDS if self.items[c.id] is current)
        return next(found, None)

    def add_gestures(self) -> None:
        """List the gestures of the mouse as well."""
        group = self._group("Mouse")
        for name, gesture in _GESTURES:
            group.addChild(QTreeWidgetItem([name, gesture]))

    def _fill(self) -> None:
        groups: dict[str, QTreeWidgetItem] = {}
        for command in COMMANDS:
            menu = plain(command.menu).replace("/", " › ")
            if menu not in groups:
                groups[menu] = self._group(menu)
            item = QTreeWidgetItem([plain(command.text), ""])
            item.setToolTip(0, command.tip)
            groups[menu].addChild(item)
            self.items[command.id] = item

    def _group(self, name: str) -> QTreeWidgetItem:
        group = QTreeWidgetItem([name])
        font = group.font(0)
        font.setBold(True)
        group.setFont(0, font)
        group.setFlags(Qt.ItemFlag.ItemIsEnabled)
        self.tree.addTopLevelItem(group)
        group.setExpanded(True)
        return group

    def _filter(self, text: str) -> None:
        groups = [self.tree.topLevelItem(row) for row in range(self.tree.topLevelItemCount())]
        for group in groups:
            children = [group.child(i) for i in range(group.childCount())]
            for item in children:
                item.setHidden(not _fits(text, item))
            group.setHidden(all(item.isHidden() for item in children))
        self.nothing.setVisible(all(group.isHidden() for group in groups))


class ShortcutSheet(QDialog):
    """Shows all keys; `change` opens the page where they are changed."""

    def __init__(self, parent: QWidget, shortcuts: Shortcuts, change: Callable[[], None]) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Keyboard shortcuts")
        self.resize(560, 620)
        self.table = ShortcutTable(shortcuts)
        self.table.add_gestures()
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        button = buttons.addButton("Change keys…", QDialogButtonBox.ButtonRole.ActionRole)
        button.clicked.connect(lambda: (self.accept(), change()))
        layout = QVBoxLayout(self)
        layout.addWidget(self.table)
        layout.addWidget(buttons)
        self.table.search.setFocus()


class ShortcutPage(QWidget):
    """Page of the preferences: choose a command, press its new key."""

    title = "Keyboard"

    def __init__(self, shortcuts: Shortcuts) -> None:
        super().__init__()
        self._shortcuts = shortcuts
        self.table = ShortcutTable(shortcuts)
        self.editor = QKeySequenceEdit(maximumSequenceLength=1)
        self.remove_button = QPushButton("Remove key")
        self.message = FaintLabel("Double click a command, then press its new key.")
        self.reset_button = QPushButton("Reset all keys")
        self._lay_out()
        self.table.tree.currentItemChanged.connect(self._show)
        self.table.tree.itemActivated.connect(lambda *_: self.editor.setFocus())
        self.editor.keySequenceChanged.connect(self._on_key)
        self.editor.editingFinished.connect(self._show)
        self.remove_button.clicked.connect(lambda: self._change(QKeySequence()))
        self.reset_button.clicked.connect(self.reset)
        self._show()

    def reset(self) -> None:
        """Give every command its own key again."""
        self._shortcuts.reset()
        self.table.refresh()
        self._show()
        self.message.setText("Every command has its own key again.")

    def _lay_out(self) -> None:
        label = QLabel("&New key")
        label.setBuddy(self.editor)
        key = QHBoxLayout()
        key.addWidget(self.editor, 1)
        key.addWidget(self.remove_button)
        layout = QVBoxLayout(self)
        layout.addWidget(self.table, 1)
        layout.addWidget(label)
        layout.addLayout(key)
        layout.addWidget(self.message)
        layout.addWidget(self.reset_button, alignment=Qt.AlignmentFlag.AlignLeft)

    def _show(self, *_: object) -> None:
        command = self.table.command()
        for widget in (self.editor, self.remove_button):
            widget.setEnabled(command is not None)
        self.editor.blockSignals(True)
        self.editor.setKeySequence(self._shortcuts.key(command.id) if command else QKeySequence())
        self.editor.blockSignals(False)

    def _on_key(self, key: QKeySequence) -> None:
        """Take on what was pressed; each press begins with no key, which removes nothing."""
        if not key.isEmpty():
            self._change(key)

    def _change(self, key: QKeySequence) -> None:
        command = self.table.command()
        if command is None:
            return
        holder = self._shortcuts.change(command.id, key)
        name, shown = plain(command.text), key.toString(_NATIVE) or "no key"
        self.message.setText(
            f"{shown} belongs to “{plain(holder.text)}” already; choose another key."
            if holder
            else f"“{name}” has {shown} now."
        )
        self.table.refresh()
        self._show()


def _fits(text: str, item: QTreeWidgetItem) -> bool:
    """Whether a row's name, key or tip fits what is typed."""
    name, key = item.text(0), item.text(1)
    is_told = bool(text) and (text.lower() in key.lower() or begins_a_word(text, item.toolTip(0)))
    return score(text, name) is not None or is_told
