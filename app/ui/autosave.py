"""Keeps the study of a running window on disk, and finds what a crash has left."""

import json
import logging
import os
import shutil
import time
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QLockFile, QObject

from app.session import Session
from app.session.documents import Document, Documents
from app.ui.controls import Coalesced
from core.study_files import StudyFile, StudyFileError, parse_study, study_text
from core.whole_files import write_atomically

logger = logging.getLogger(__name__)

_DELAY_MS = 2000
_LOCK, _CONTENT = "session.lock", "study.json"
_MOST_LEFT = 20


@dataclass(frozen=True)
class Leftover:
    """A study of a window that ended without closing; ours as long as its lock is held.

    Attributes
    ----------
    folder : Path
        Where it is.
    lock : QLockFile
        Keeps others from offering it too.
    saved_at : float
        When it was kept last.
    title : str
        What the window called it.
    document : Document
        The file it belongs to.
    study : StudyFile
        The study.
    """

    folder: Path
    lock: QLockFile
    saved_at: float
    title: str
    document: Document
    study: StudyFile

    def discard(self) -> None:
        """Remove it for good."""
        self.lock.unlock()
        shutil.rmtree(self.folder, ignore_errors=True)


class Autosave(QObject):
    """Writes the study two seconds after a change, whole or not at all, where it could be lost.

    Parameters
    ----------
    session : Session
        What to keep.
    documents : Documents
        Which file it belongs to.
    folder : Path
        Folder of all sessions; this one gets a folder with a lock in it.
    """

    def __init__(self, session: Session, documents: Documents, folder: Path) -> None:
        super().__init__()
        self._session, self._documents = session, documents
        self.folder = folder / f"{os.getpid()}-{time.time_ns()}"
        self._lock = self._locked()
        self._timer = Coalesced(self.write, _DELAY_MS, self)
        session.study_changed.connect(self._timer.request)
        documents.changed.connect(self._timer.request)

    def write(self) -> None:
        """Write now, if a model is open; what is saved or untouched needs no restoring."""
        self._timer.stop()
        meshes = self._session.meshes
        if meshes is None or self._lock is None:
            return
        document = self._documents.current
        try:
            if document.holds(self._session.study):
                (self.folder / _CONTENT).unlink(missing_ok=True)
                return
            text = study_text(self._session.study, self.folder, self._session.fingerprints)
            kept = {
                "title": document.path.name if document.path else meshes.name,
                "document": str(document.path) if document.path else None,
                "packed": document.packed,
                "study": text,
            }
            write_atomically(self.folder / _CONTENT, json.dumps(kept).encode())
        except (OSError, ValueError) as error:
            logger.warning("the study could not be kept: %s", error)

    def close(self) -> None:
        """Forget the session: it was closed as it should be."""
        self._timer.stop()
        if self._lock is not None:
            self._lock.unlock()
            shutil.rmtree(self.folder, ignore_errors=True)
            self._lock = None

    def _locked(self) -> QLockFile | None:
        try:
            self.folder.mkdir(parents=True)
        except OSError as error:
            logger.warning("studies are not kept, there is no folder for them: %s", error)
            return None
        return _lock_of(self.folder)


def leftovers(folder: Path) -> list[Leftover]:
    """Take hold of what ended windows have left in a folder, newest first."""
    found = []
    places = sorted(folder.glob(f"*/{_CONTENT}"), key=_age)
    for content in places[:_MOST_LEFT]:
        lock = _lock_of(content.parent)
        if lock is None:
            continue
        try:
            found.append(_leftover(content, lock))
        except (OSError, ValueError, KeyError, TypeError) as error:
            logger.warning("what an ended window has left cannot be read: %s", error)
            lock.unlock()
    return found


def _age(path: Path) -> float:
    try:
        return -path.stat().st_mtime
    except OSError:
        return 0.0


def _lock_of(folder: Path) -> QLockFile | None:
    """Lock a folder, or return None while the program that has locked it still runs."""
    lock = QLockFile(str(folder / _LOCK))
    lock.setStaleLockTime(0)
    return lock if lock.tryLock(0) else None


def _leftover(content: Path, lock: QLockFile) -> Leftover:
    kept = json.loads(content.read_bytes())
    if not isinstance(kept, dict):
        raise StudyFileError(f"{content}: is not a kept study.")
    document = Document(Path(kept["document"]) if kept["document"] else None, bool(kept["packed"]))
    study = parse_study(str(kept["study"]).encode(), content)
    return Leftover(
        content.parent, lock, content.stat().st_mtime, str(kept["title"]), document, study
    )
