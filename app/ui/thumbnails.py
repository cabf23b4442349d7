"""Small pictures of models, drawn beside the window and kept in the cache."""

import hashlib
import logging
from collections.abc import Iterator
from pathlib import Path

from PySide6.QtCore import QObject, QTimer

from app.export.pictures import PictureError, save_picture
from app.export.sketch import sketch_picture
from app.folders import cache_folder
from app.session import Job, Session
from app.session.documents import Documents
from core.mesh import TriangleMesh

logger = logging.getLogger(__name__)

_SIZE = (224, 168)
_IDLE_MS = 1500


def thumbnail(model: str) -> Path:
    """Return where the picture of a model, a study or ``sample:ID`` is kept."""
    name = hashlib.sha256(model.encode()).hexdigest()[:32]
    return cache_folder() / "thumbnails" / f"{name}.png"


def draw_thumbnail(mesh: TriangleMesh, files: list[Path]) -> None:
    """Draw a mesh into files, on any thread; what cannot be written is left out."""
    picture = sketch_picture(mesh, _SIZE)
    for file in files:
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            save_picture(picture, file)
        except (OSError, PictureError) as error:
            logger.warning("no thumbnail: %s", error)


class Thumbnailer(QObject):
    """Draws the model that is open, once, beside the window when nothing else is to do.

    Parameters
    ----------
    session : Session
        Whose model is drawn.
    documents : Documents
        A study gets the picture of its model.
    """

    def __init__(self, session: Session, documents: Documents) -> None:
        super().__init__()
        self._session, self._documents = session, documents
        self._drawn: set[Path] = set()
        self._timer = QTimer(self, singleShot=True, interval=_IDLE_MS)
        self._timer.timeout.connect(self._draw)
        session.activity_changed.connect(self._wait)
        documents.changed.connect(self._wait)

    def close(self) -> None:
        """Draw nothing more."""
        self._timer.stop()

    def _wait(self) -> None:
        if self._session.meshes is not None:
            self._timer.start()

    def _missing(self) -> list[Path]:
        document = self._documents.current.path
        names = [self._session.study.model, *([str(document)] if document else [])]
        files = [thumbnail(name) for name in names if not _has_picture(name)]
        return [file for file in files if file not in self._drawn]

    def _draw(self) -> None:
        meshes, missing = self._session.meshes, self._missing()
        if meshes is None or self._session.activity is not None or not missing:
            return
        self._drawn.update(missing)
        mesh = meshes.comparison.original

        def steps() -> Iterator[None]:
            yield draw_thumbnail(mesh, missing)

        self._session.jobs.start(Job(steps(), title="Small picture of the model"))


def _has_picture(model: str) -> bool:
    """Whether a model has a picture that is not older than its file."""
    picture, file = thumbnail(model), Path(model)
    changed = file.stat().st_mtime if file.exists() else 0.0
    return picture.exists() and picture.stat().st_mtime >= changed
