"""Studies as files of the window: open, save, keep, restore, and ask before work is lost."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMessageBox

from app.export.study_script import script_of
from app.folders import sessions_folder
from app.session import Job
from app.session.documents import Document, Documents
from app.study_words import command_of
from app.ui import dialogs
from app.ui.autosave import Autosave
from app.ui.dialogs import question
from app.ui.gallery import GalleryDialog
from app.ui.recent import RecentFiles
from app.ui.study_opening import StudyOpening
from app.ui.thumbnails import Thumbnailer
from core.io import SUPPORTED_READ
from core.study import SAMPLE_PREFIX, Study
from core.study_files import (
    STUDY_SUFFIX,
    StudyFileError,
    read_study_file,
    write_study_file,
)

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_FILTER = f"Burnish studies (*{STUDY_SUFFIX})"
_Button = QMessageBox.StandardButton


class StudyFiles:
    """The file side of a window.

    Parameters
    ----------
    window : MainWindow
        Its session is what is opened and saved.
    """

    def __init__(self, window: "MainWindow") -> None:
        self._window, self._session = window, window.session
        self.documents = Documents(window.session)
        self.autosave = Autosave(window.session, self.documents, sessions_folder())
        self.recent = RecentFiles(self.open, window)
        self._thumbnailer = Thumbnailer(window.session, self.documents)
        self._may_close = self._close_soon = False
        self._saves = 0
        self.documents.changed.connect(self._remember)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Return what the commands of this module do, by id."""
        return {
            "open": self._ask_for_any,
            "open_study": self._ask_for_study,
            "save_study": self.save,
            "save_study_as": self.save_as,
            "save_packed": partial(self.save_as, packed=True),
            "gallery": lambda: GalleryDialog(self._window).open(),
            "copy_command": lambda: self._copy(command_of, "command line"),
            "copy_script": lambda: self._copy(script_of, "Python script"),
        }

    @property
    def title(self) -> str:
        """Name of the study and its model, with a star while there is unsaved work."""
        meshes, path = self._session.meshes, self.documents.current.path
        if meshes is None:
            return "Burnish"
        star = "*" if self.documents.is_modified else ""
        names = [f"{path.name}{star}", meshes.name] if path else [f"{meshes.name}{star}"]
        return " – ".join([*names, "Burnish"])

    def _copy(self, describe: Callable[[Study], str], name: str) -> None:
        QGuiApplication.clipboard().setText(describe(self._session.study))
        self._session.notified.emit(f"Copied the study as a {name}.")

    # -- opening

    def open(self, name: str) -> None:
        """Open a study or a model by its path, or a bundled model as ``sample:ID``."""
        if Path(name).suffix.lower() == STUDY_SUFFIX:
            self._when_safe(partial(self._open_study, Path(name).absolute()))
        elif self.documents.current.path:
            self._when_safe(partial(self._open_model, name))
        else:
            self._open_model(name)

    def may_drop(self, data: QMimeData) -> bool:
        """Whether something that is dragged can be opened; tell what could be where it cannot."""
        if dropped_file(data):
            return True
        if data.hasUrls():
            self._session.notified.emit("What can be dropped is a model or a study, not a folder.")
        return False

    def drop(self, data: QMimeData) -> bool:
        """Open the first model or study among what is dropped; tell where there are more."""
        name = dropped_file(data)
        if name is None:
            return False
        dialogs.remember_folder(name)
        if len(data.urls()) > 1:
            self._session.notified.emit(f"Only {Path(name).name} is opened: one file at a time.")
        self.open(name)
        return True

    def _remember(self) -> None:
        """Put what is open first in the list of recent files."""
        path = self.documents.current.path
        model = self._session.study.model
        if path or not model.startswith(SAMPLE_PREFIX):
            self.recent.add(str(path or model))

    def _open_model(self, model: str) -> None:
        name = model.removeprefix(SAMPLE_PREFIX)
        fresh = {"model": model, "noisy": None, "repairs": ()}
        study = self._session.study.model_copy(update=fresh)
        begun = self.documents.current if self.documents.is_modified else Document(saved=study)
        self.documents.open(study, Document(saved=begun.saved), f"Open {Path(name).name}")

    def _open_study(self, path: Path) -> None:
        try:
            file = read_study_file(path)
        except StudyFileError as error:
            dialogs.tell(self._window, str(error))
            return

        def use(study: Study) -> None:
            document = Document(path, file.packed, study)
            self.documents.open(study, document, f"Open {path.name}")

        StudyOpening(self._window, file, use).start()

    def _ask_for_any(self) -> None:
        suffixes = " ".join(f"*{suffix}" for suffix in (*SUPPORTED_READ, STUDY_SUFFIX))
        filters = f"Models and studies ({suffixes});;{_FILTER};;All files (*)"
        title = "Open a model or a study"
        dialogs.ask_for_file(self._window, title, lambda path: self.open(str(path)), filters)

    def _ask_for_study(self) -> None:
        dialogs.ask_for_file(
            self._window, "Open a study", lambda path: self.open(str(path)), _FILTER
        )

    # -- saving

    def save(self, then: Callable[[], object] = lambda: None) -> None:
        """Save the study to its file; ask for one where it has none."""
        document = self.documents.current
        if document.path is None:
            self.save_as(then)
        else:
            self._write(document.path, document.packed, then)

    def save_as(self, then: Callable[[], object] = lambda: None, *, packed: bool = False) -> None:
        """Ask where to save the study, on request with its models inside."""
        path = self.documents.current.path
        model = Path(self._session.study.model.removeprefix(SAMPLE_PREFIX))
        name = str(path) if path else f"{model.stem}{STUDY_SUFFIX}"
        title = "Save the study with its models inside" if packed else "Save the study"
        dialogs.ask_where_to_save(
            self._window, title, name, _FILTER, lambda path: self._write(path, packed, then)
        )

    def _write(self, path: Path, packed: bool, then: Callable[[], object]) -> None:
        """Write beside the window: packing large models takes a while."""
        study = self._session.study
        known = self._session.fingerprints

        def steps() -> Iterator[bool]:
            write_study_file(study, path, packed=packed, known=known)
            yield True

        def written(_: bool) -> None:
            self.documents.saved(study, path.absolute(), packed=packed)
            self._session.notified.emit(f"Saved {path.name}.")
            then()

        def done() -> None:
            self._saves -= 1
            if self._close_soon and not self._saves:
                self._close_soon = False
                self._window.close()

        self._saves += 1
        job = Job(
            steps(), written, self._session.report, done,
            title=f"Saving {path.name}", can_cancel=False,
        )  # fmt: skip
        self._session.saving.start(job)

    # -- work that is not saved

    def may_close(self) -> bool:
        """Whether the window may close now; else it asks or saves, and closes after that."""
        if self._may_close or self._session.meshes is None or not self.documents.is_modified:
            return True
        if self._saves:  # how that ends decides whether there is anything to ask
            self._close_soon = True
            return False
        self._when_safe(self._close)
        return False

    def close(self) -> None:
        """Forget the session: the window closes as it should."""
        self.autosave.close()
        self._thumbnailer.close()

    def discard_changes(self) -> None:
        """Let the window close without a question."""
        self._may_close = True

    def _close(self) -> None:
        self._may_close = True
        self._window.close()

    def _when_safe(self, go: Callable[[], object]) -> None:
        """Go on at once, or after asking what becomes of unsaved work."""
        if self._session.meshes is None or not self.documents.is_modified:
            go()
            return
        path = self.documents.current.path
        name = path.name if path else f"the study of {self._session.meshes.name}"
        box = question(self._window, f"Save the changes to {name}?", "Else they are lost.")
        box.addButton(_Button.Save).clicked.connect(lambda: self.save(go))
        box.addButton(_Button.Discard).clicked.connect(lambda *_: go())
        box.addButton(_Button.Cancel)
        box.setDefaultButton(_Button.Save)
        box.open()


def dropped_file(data: QMimeData) -> str | None:
    """Return the first model or study among what is dragged, None where there is none."""
    names = [url.toLocalFile() for url in data.urls()]
    allowed = (*SUPPORTED_READ, STUDY_SUFFIX)
    return next((name for name in names if Path(name).suffix.lower() in allowed), None)
