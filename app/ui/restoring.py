"""After a crash or a kill: offering what was open."""

from datetime import datetime
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMessageBox

from app.folders import sessions_folder
from app.ui.autosave import Leftover, leftovers
from app.ui.dialogs import question
from app.ui.study_opening import StudyOpening
from core.study import Study

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_Role = QMessageBox.ButtonRole


def offer_leftovers(window: "MainWindow") -> None:
    """Ask whether to restore the newest study that a crash has left; others wait their turn."""
    found = leftovers(sessions_folder())
    for other in found[1:]:
        other.lock.unlock()
    if found:
        _offer(window, found[0])


def _offer(window: "MainWindow", leftover: Leftover) -> None:
    when = datetime.fromtimestamp(leftover.saved_at).astimezone()
    box = question(
        window,
        f"Burnish ended without closing while {leftover.title} was open.",
        f"It was kept on {when:%d %B at %H:%M}. Restore it?",
    )
    restore = box.addButton("Restore", _Role.AcceptRole)
    restore.clicked.connect(lambda: _restore(window, leftover))
    box.addButton(QMessageBox.StandardButton.Discard).clicked.connect(leftover.discard)
    later = box.addButton("Ask me next time", _Role.RejectRole)
    later.clicked.connect(leftover.lock.unlock)
    box.setDefaultButton(restore)
    box.open()


def _restore(window: "MainWindow", leftover: Leftover) -> None:
    """Open what was left; it stays on disk until this window keeps it."""
    documents = window.files.documents

    def use(study: Study) -> None:
        documents.changed.connect(discard)
        documents.open(study, leftover.document, f"Restore {leftover.title}")

    def discard() -> None:
        if documents.current is leftover.document:
            documents.changed.disconnect(discard)
            window.files.autosave.write()
            leftover.discard()

    StudyOpening(window, leftover.study, use).start()
