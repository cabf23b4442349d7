"""Keys that a person has changed: kept between starts, free of conflicts."""

from PySide6.QtCore import QSettings
from PySide6.QtGui import QKeySequence

from app.ui.action_book import ActionBook
from app.ui.actions import COMMANDS, Command

_GROUP = "shortcuts"
_PORTABLE = QKeySequence.SequenceFormat.PortableText


class Shortcuts:
    """The keys of all commands.

    Parameters
    ----------
    book : ActionBook
        The commands; gets the keys that were kept.
    """

    def __init__(self, book: ActionBook) -> None:
        self._book = book
        self.load()

    def load(self) -> None:
        """Give every command the key that was kept for it, or its own."""
        for command in COMMANDS:
            kept = QSettings().value(f"{_GROUP}/{command.id}", command.key)
            self._book.set_key(command.id, QKeySequence(str(kept), _PORTABLE))

    def holder(self, key: QKeySequence, besides: str) -> Command | None:
        """Return the other command that has a key already, or begins or ends where it does."""
        if key.isEmpty():
            return None
        others = (command for command in COMMANDS if command.id != besides)
        return next((c for c in others if _clash(self._book.key(c.id), key)), None)

    def change(self, command: str, key: QKeySequence) -> Command | None:
        """Give a command another key, kept between starts; an empty one takes it away.

        Returns the command that has the key already; then nothing changes.
        """
        holder = self.holder(key, command)
        if holder is None:
            self._book.set_key(command, key)
            QSettings().setValue(f"{_GROUP}/{command}", key.toString(_PORTABLE))
        return holder

    def reset(self) -> None:
        """Give every command its own key again."""
        QSettings().remove(_GROUP)
        self.load()

    def key(self, command: str) -> QKeySequence:
        """Return the key of a command."""
        return self._book.key(command)

    def is_changed(self, command: Command) -> bool:
        """Whether a command has another key than its own."""
        return self._book.key(command.id) != QKeySequence(command.key)


def _clash(one: QKeySequence, other: QKeySequence) -> bool:
    """Whether two sequences cannot be told apart, the shorter being the beginning of the longer."""
    if one.isEmpty():
        return False
    no_match = QKeySequence.SequenceMatch.NoMatch
    return one.matches(other) != no_match or other.matches(one) != no_match
