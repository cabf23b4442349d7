"""The one observable of the program: the current study and what has been computed for it."""

from collections.abc import Callable, Collection, Iterator
from pathlib import Path

from psygnal import Signal

from app.session.history import History
from app.session.jobs import Job, Jobs, Post
from app.session.merging import carried_over, sources_of
from app.session.meshes import Meshes, MeshReader
from app.session.running import RunningTasks
from app.session.runs import Run, RunKey, RunStore
from app.session.sentences import sentence_of
from core.comparison import Snapshot
from core.smoothing import METHODS, DivergenceError
from core.study import SAMPLE_PREFIX, MethodChoice, Study

_BUDGET = 4 * 1024**3


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
    tasks : RunningTasks
        All that runs, of the study and beside it.
    jobs : Jobs
        Carries out what is computed.
    saving : Jobs
        Carries out what is saved, which closing waits for.
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

    def __init__(self, post: Post, *, budget: int = _BUDGET) -> None:
        self.study = Study()
        self.meshes: Meshes | None = None
        self.history = History()
        self.tasks = RunningTasks()
        self.jobs = Jobs(post, self.tasks)
        self.saving = Jobs(post, self.tasks, must_finish=True)
        self._reader = MeshReader(budget)
        self._store = RunStore(budget)
        self._running: dict[RunKey, Job] = {}
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
        for job in self._running.values():
            job.cancel()
        self._set_back(self._wanted())
        self.tasks.cancel_all()

    @property
    def budget(self) -> int:
        """Memory for snapshots in bytes."""
        return self._store.budget

    def set_budget(self, budget: int) -> None:
        """Set the memory for snapshots in bytes; what no longer fits goes at once."""
        self._store.budget = self._reader.budget = budget
        self._store.trim(self._wanted())

    def close(self) -> None:
        """Stop all work for good; only what is being saved is saved."""
        self.jobs.close()
        self.saving.close()
        self.tasks.cancel_all()

    def run(self, method: str) -> Run | None:
        """Return what is known of a method with its current parameters."""
        return self._store.get(self._key(self.study.choice(method)))

    def shown_iteration(self, method: str) -> int:
        """Return the iteration to show: the chosen one, or the last that is there."""
        run = self.run(method)
        return min(self.study.choice(method).iterations, run.computed) if run else 0

    @property
    def activity(self) -> str | None:
        """What is being computed for the study, or None."""
        if self._loading:
            return self._loading.title
        busy = [choice for key, choice in self._wanted().items() if key in self._running]
        return ", ".join(METHODS[choice.method].title for choice in busy) or None

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
        self._run_missing()
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

        def read() -> Iterator[Meshes]:
            yield self._reader.read(study)

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
        self._run_missing()
        self.meshes_changed.emit()
        self.study_changed.emit(study, before)
        if opened and meshes.report:
            self.notified.emit(f"{meshes.name}: {'; '.join(meshes.report)}.")

    def _key(self, choice: MethodChoice) -> RunKey:
        meshes = self.meshes.key if self.meshes else ""
        return meshes, f"{choice.method} {choice.settings.model_dump_json()}"

    def _wanted(self) -> dict[RunKey, MethodChoice]:
        return {self._key(choice): choice for choice in self.study.methods if choice.enabled}

    def _run_missing(self) -> None:
        """Start what the study asks for and is not there; stop what it no longer asks for."""
        wanted = self._wanted()
        for key, job in list(self._running.items()):
            if key not in wanted:
                job.cancel()
        for key, choice in wanted.items():
            self._run(key, choice)
        self.activity_changed.emit()

    def _run(self, key: RunKey, choice: MethodChoice) -> None:
        """Start a method unless it is under way, has diverged or is far enough."""
        if self.meshes is None or key in self._running:
            return
        run, source = self._store.begin(key, self.meshes.comparison, choice)
        if source.ended or run.computed >= choice.iterations:
            return

        def target() -> int:
            wanted = self._wanted().get(key)
            return wanted.iterations if wanted else 0

        def extend(step: Snapshot | DivergenceError) -> None:
            known = self._store.get(key)
            if known:
                self._store.put(key, known.extended(step), self._wanted())
                self.run_changed.emit(choice.method)
                self.activity_changed.emit()

        def share() -> float:
            known = self._store.get(key)
            return known.computed / max(target(), 1) if known else 0.0

        def done() -> None:
            # A slider may have asked for more, or a cancelled run may be wanted again.
            self._running.pop(key, None)
            self._run_missing()

        job = Job(
            source.advance(target), extend, self.report, done,
            title=METHODS[choice.method].title, share=share,
            on_cancel=lambda: self._set_back({key}), late=True,
        )  # fmt: skip
        self._running[key] = job
        self.jobs.start(job)

    def _set_back(self, keys: Collection[RunKey]) -> None:
        """Let the sliders of runs go back to what is there, as one step that can be undone."""
        study = self.study
        for key, choice in self._wanted().items():
            run = self._store.get(key)
            if key in keys and run and run.computed < choice.iterations and not run.diverged:
                update = {"iterations": run.computed}
                study = study.with_choice(choice.model_copy(update=update))
        if study != self.study:
            self.apply(study, "Cancel")

    def report(self, error: Exception) -> None:
        """Tell what a job raised: a sentence where the input was at fault, else a fault."""
        sentence = sentence_of(error)
        if sentence is None:
            self.broken.emit(error)
        else:
            self.failed.emit(sentence)
