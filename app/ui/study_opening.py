"""Opening a study file: its models are looked for, and asked for where they are not as saved."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMessageBox

from app.folders import forget_old, unpacked_folder
from app.session import Job
from app.ui import dialogs
from core.study import Study
from core.study_files import ChangedModelError, MissingModelError, Role, StudyFile, StudyFileError

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_Role = QMessageBox.ButtonRole


class StudyOpening:
    """One study on its way into the window.

    Parameters
    ----------
    window : MainWindow
        Where to ask.
    file : StudyFile
        What was read.
    use : callable
        Gets the study when all its models are found.
    """

    def __init__(self, window: "MainWindow", file: StudyFile, use: Callable[[Study], None]) -> None:
        self._window, self._file, self._use = window, file, use
        self._chosen: dict[Role, str] = {}
        self._accepted: set[Role] = set()
        self._with_second = True

    def start(self) -> None:
        """Look for the models beside the window: comparing large files takes a while."""

        def steps() -> Iterator[Study]:
            forget_old(unpacked_folder())
            yield self._file.locate(
                unpacked_folder(), chosen=self._chosen, accepted=self._accepted,
                with_second=self._with_second,
            )  # fmt: skip

        job = Job(steps(), self._use, self._failed, title="Opening the study")
        self._window.session.jobs.start(job, urgent=True)

    def _failed(self, error: Exception) -> None:
        if isinstance(error, MissingModelError | ChangedModelError):
            self._ask(error)
        elif isinstance(error, StudyFileError):
            dialogs.tell(self._window, str(error))
        else:
            self._window.session.report(error)

    def _ask(self, error: MissingModelError | ChangedModelError) -> None:
        changed = isinstance(error, ChangedModelError)
        more = "Another model gives other numbers." if changed else "Where is it now?"
        box = dialogs.question(self._window, str(error), more)
        if changed:
            anyway = box.addButton("Use it anyway", _Role.AcceptRole)
            anyway.clicked.connect(lambda: self._accept(error.role))
        if error.role == "second":
            box.addButton("Open without it", _Role.AcceptRole).clicked.connect(self._leave_second)
        choose = box.addButton("Choose a file…", _Role.ActionRole)
        choose.clicked.connect(lambda: self._choose(error.role))
        cancel = box.addButton(QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(cancel if changed else choose)
        box.open()

    def _accept(self, role: Role) -> None:
        self._accepted.add(role)
        self.start()

    def _leave_second(self) -> None:
        self._with_second = False
        self.start()

    def _choose(self, role: Role) -> None:
        def use(path: Path) -> None:
            self._chosen[role] = str(path)
            self.start()

        dialogs.ask_for_file(self._window, "Where is the model now?", use)
