"""Which file the current study belongs to, and whether it differs from what is saved there."""

from dataclasses import dataclass
from pathlib import Path

from psygnal import Signal

from app.session.session import Session
from core.study import Study


@dataclass(frozen=True)
class Document:
    """A study file that is open.

    Attributes
    ----------
    path : Path or None
        The file; None for a study that was never saved.
    packed : bool
        Whether the models are inside the file.
    saved : Study or None
        The study as the file holds it; without a file, as it was begun.
    """

    path: Path | None = None
    packed: bool = False
    saved: Study | None = None

    def differs(self, study: Study) -> bool:
        """Whether a study holds work that is not saved.

        Without a file, another model or another way to look at it is no work.
        """
        if self.path is None:
            return _work(study) != _work(self.saved or Study())
        return study != self.saved

    def holds(self, study: Study) -> bool:
        """Whether nothing of a study would be lost without it: all is saved, or just opened."""
        if self.path is None:
            return study == (self.saved or Study()).model_copy(update={"model": study.model})
        return study == self.saved


class Documents:
    """The document of a session; undo and redo across an opening bring its document back.

    Parameters
    ----------
    session : Session
        What to listen to.
    """

    changed = Signal()
    """Another file belongs to the study, or it was saved."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._documents = {0: Document()}
        self._place = 0
        self._expected: tuple[Study, Document] | None = None
        # Studies at which another document begins, as the very objects that the history keeps.
        self._borders: list[tuple[Study, int]] = []
        session.study_changed.connect(self._on_study_changed)

    @property
    def current(self) -> Document:
        """The document of the study."""
        return self._documents[self._place]

    @property
    def is_modified(self) -> bool:
        """Whether there is work that is not saved."""
        return self.current.differs(self._session.study)

    def open(self, study: Study, document: Document, step: str) -> None:
        """Make a study the current one as a named step; its document comes with it."""
        self._expected = study, document
        if study == self._session.study and self._session.meshes is not None:
            self._adopt(self._session.study, document)
        else:
            self._session.apply(study, step)

    def saved(self, study: Study, path: Path, *, packed: bool) -> None:
        """Say that a study was written to a file, which is now its document."""
        self._session.history.seal()
        self._documents[self._place] = Document(path, packed, study)
        self.changed.emit()

    def _on_study_changed(self, study: Study, before: Study) -> None:
        if self._expected and _is_same_opening(study, self._expected[0]):
            self._borders.append((before, self._place))
            self._adopt(study, self._expected[1])
            return
        for border, place in reversed(self._borders):
            if border is study and place != self._place:
                self._place = place
                self.changed.emit()
                return

    def _adopt(self, study: Study, document: Document) -> None:
        self._expected = None
        self._place = max(self._documents) + 1
        self._documents[self._place] = document
        self._borders.append((study, self._place))
        self._forget_what_is_out_of_reach(study)
        self.changed.emit()

    def _forget_what_is_out_of_reach(self, study: Study) -> None:
        """Keep the current document, and those that undo and redo come to: steps have an end."""
        reached = {id(one) for one in (study, *self._session.history.studies)}
        self._borders = [border for border in self._borders if id(border[0]) in reached]
        places = {self._place, *(place for _, place in self._borders)}
        self._documents = {place: self._documents[place] for place in sorted(places)}


def _is_same_opening(study: Study, opened: Study) -> bool:
    return (study.model, study.noisy) == (opened.model, opened.noisy)


def _work(study: Study) -> Study:
    fresh = Study()
    return study.model_copy(update={"model": fresh.model, "view": fresh.view})
