"""The one observable of the program: the current study and what has been computed for it."""

from collections.abc import Callable, Iterator
from pathlib import Path

from psygnal import Signal

from app.session.history import History
from app.session.jobs import Job, Jobs, Post
from app.session.merging import carried_over, sources_of
from app.session.meshes import Meshes, MeshReader
from app.session.running import RunningTasks
from app.session.runs import Run
from app.session.sentences import sentence_of
from app.session.study_runs import StudyRuns
from core.study import SAMPLE_PREFIX, Study
from core.study_files import Fingerprint

_BUDGET = 4 * 1024**3
_EXPORT_PATIENCE = 0.5


class Session:
    """Current study, its meshes and its runs; everything else listens.

    Change the study with :meth:`apply`; read :attr:`study`, :attr:`meshes` and :meth:`run`. All
    methods belong to one thread, the one that `post` runs functions on.

    Parameters
    ----------
    post : callable
        Runs a function on the owner's thread.
    budget : int
        Memory for snapshots in bytes.

    Attributes
    ----------
    post : callable
        Runs a function on the owner's thread.
    tasks : RunningTasks
        All that runs, of the study and beside it.
    jobs : Jobs
        Carries out what is computed.
    saving : Jobs
        Carries out what is saved, which closing waits for.
    exports : Jobs
        Carries out what is exported, which closing gives a moment and then leaves undone.
    previews : Jobs
        Composes what dialogs show; not listed, and nothing waits for it. One thread for all, since
        Matplotlib opens its fonts anew for each.
    others : dict of str to Fingerprint
        What each file that is not one of the meshes was when it was read.
    """

    study_changed = Signal(Study, Study)
    """The study was replaced: (new, old)."""
    meshes_changed = Signal()
    """Other meshes are there."""
    run_changed = Signal(str)
    """The run of a method has grown or ended: (method id)."""
    activity_changed = Signal()
    """What is being computed for the study has changed."""
    failed = Signal(str)
    """Something could not be done: one sentence for the user."""
    broken = Signal(Exception)
    """Something went wrong that should not: a fault of the program."""
    notified = Signal(str)
    """Something worth a line in the status bar."""
    closing = Signal()
    """All work is about to stop: what waits for the owner's thread waits in vain."""

    def __init__(self, post: Post, *, budget: int = _BUDGET) -> None:
        self.study = Study()
        self.meshes: Meshes | None = None
        self.others: dict[str, Fingerprint] = {}
        self.history = History()
        self.post = post
        self.tasks = RunningTasks()
        self.jobs = Jobs(post, self.tasks)
        self.saving = Jobs(post, self.tasks, must_finish=True, patience=None)
        self.exports = Jobs(post, self.tasks, must_finish=True, patience=_EXPORT_PATIENCE)
        self.previews = Jobs(post, patience=0)
        self._reader = MeshReader(budget)
        self._runs = StudyRuns(self.jobs, self.report, budget)
        self._runs.grown.connect(self.run_changed.emit)
        self._runs.activity_changed.connect(self.activity_changed.emit)
        self._runs.stopped_short.connect(lambda study: self.apply(study, "Cancel"))
        self._loading: Job | None = None

    def apply(self, study: Study, name: str) -> None:
        """Replace the study as one undoable step.

        A step that needs other meshes takes place when they are there; if they cannot be had,
        `failed` says why and everything stays as it was.
        """
        if self._needs_meshes(study):
            self._load(study, name)
        elif study != self.study:
            self.history.record(self.study, name)
            self._replace(study)

    def undo(self) -> None:
        """Take back the last step."""
        self._travel(self.history.undo(self.study), self.history.redo)

    def redo(self) -> None:
        """Do the step again that was taken back last."""
        self._travel(self.history.redo(self.study), self.history.undo)

    def cancel(self) -> None:
        """Stop all work; what is there stays, and sliders beyond it go back to it."""
        self._runs.cancel()
        self.tasks.cancel_all()

    @property
    def budget(self) -> int:
        """Memory for snapshots in bytes."""
        return self._runs.budget

    def set_budget(self, budget: int) -> None:
        """Set the memory for snapshots in bytes; what no longer fits goes at once."""
        self._runs.budget = self._reader.budget = budget

    def close(self) -> None:
        """Stop all work for good; only what is being saved is saved."""
        self.closing.emit()
        self.jobs.close()
        self.saving.close()
        self.exports.close()
        self.previews.tasks.cancel_all()
        self.previews.close()
        self.tasks.cancel_all()

    def run(self, method: str) -> Run | None:
        """Return what is known of a method with its current parameters."""
        return self._runs.run(self.study.choice(method))

    def shown_iteration(self, method: str) -> int:
        """Return the iteration to show: the chosen one, or the last before it that is there."""
        run = self.run(method)
        return run.nearest(self.study.choice(method).iterations) if run else 0

    @property
    def fingerprints(self) -> dict[str, Fingerprint]:
        """What each file of the study was when it was read."""
        return {**self.others, **(self.meshes.fingerprints if self.meshes else {})}

    @property
    def activity(self) -> str | None:
        """What is being computed for the study, or None."""
        if self._loading:
            return self._loading.title
        return ", ".join(self._runs.busy) or None

    @property
    def is_loading(self) -> bool:
        """Whether other meshes are on their way."""
        return self._loading is not None

    def _needs_meshes(self, study: Study) -> bool:
        return self.meshes is None or sources_of(study) != sources_of(self.study)

    def _travel(self, study: Study, go_back: Callable[[Study], Study]) -> None:
        """Go to a study of the history; if its meshes cannot be had, the history goes back."""
        known = self._reader.known(study)
        if self._needs_meshes(study) and known:
            self._stop_loading()
            self._adopt(study, None, known)
        elif self._needs_meshes(study):
            self._load(study, None, stay=lambda: go_back(study))
        elif study != self.study:
            self._replace(study)

    def _replace(self, study: Study) -> None:
        before, self.study = self.study, study
        self._runs.follow(study, self.meshes)
        self.study_changed.emit(study, before)

    def _stop_loading(self) -> None:
        if self._loading:
            self._loading.cancel()

    def _load(
        self, study: Study, name: str | None, stay: Callable[[], object] = lambda: None
    ) -> None:
        """Read the meshes of a study; with a name it becomes an undoable step.

        Where it does not come to that, `stay` makes the history fit again.
        """
        self._stop_loading()
        before = self.study

        def read() -> Iterator[Meshes | None]:
            yield (yield from self._reader.read_steps(study))

        def done() -> None:
            if self._loading is job:
                self._loading = None
                self.activity_changed.emit()

        def loaded(meshes: Meshes) -> None:
            self._adopt(carried_over(study, before, self.study), name, meshes)

        def failed(error: Exception) -> None:
            stay()
            self.report(error)

        title = f"Loading {Path(study.model.removeprefix(SAMPLE_PREFIX)).name}"
        self._loading = job = Job(read(), loaded, failed, done, title=title, on_cancel=stay)
        self.jobs.start(job, urgent=True)
        self.activity_changed.emit()

    def _adopt(self, study: Study, name: str | None, meshes: Meshes) -> None:
        if name is not None and self.meshes is not None:
            self.history.record(self.study, name)
        opened = self.meshes is None or self.study.model != study.model
        before, self.study = self.study, study
        self.meshes = meshes
        self._runs.follow(study, self.meshes)
        self.meshes_changed.emit()
        self.study_changed.emit(study, before)
        if opened and meshes.report:
            self.notified.emit(f"{meshes.name}: {'; '.join(meshes.report)}.")

    def report(self, error: Exception) -> None:
        """Tell what a job raised: a sentence where the input was at fault, else a fault."""
        sentence = sentence_of(error)
        if sentence is None:
            self.broken.emit(error)
        else:
            self.failed.emit(sentence)
