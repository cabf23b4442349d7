"""The runs that a study asks for: started, gone on with, and made again where memory took them."""

from collections.abc import Callable, Collection, Iterator
from functools import lru_cache
from typing import Any

from psygnal import Signal

from app.session.jobs import Job, Jobs
from app.session.meshes import Meshes
from app.session.run_source import Kept, kept_iterations
from app.session.runs import Run, RunKey, RunStore
from core.smoothing import METHODS, DivergenceError
from core.study import MethodChoice, Study

Steps = Iterator[Kept | DivergenceError | None]


class StudyRuns:
    """Computes beside the window what a study asks for and is not there.

    Parameters
    ----------
    jobs : Jobs
        Carries it out.
    report : callable
        Gets what a run raises.
    budget : int
        Memory for snapshots in bytes.
    """

    grown = Signal(str)
    """The run of a method has grown or ended, or holds another snapshot: (method id)."""
    activity_changed = Signal()
    """What is being computed has changed."""
    stopped_short = Signal(Study)
    """Runs were cancelled: the study whose sliders go no further than what is there."""

    def __init__(self, jobs: Jobs, report: Callable[[Exception], None], budget: int) -> None:
        self._jobs, self._report = jobs, report
        self._store = RunStore(budget)
        self._running: dict[RunKey, Job] = {}
        self._study = Study()
        self._meshes: Meshes | None = None

    def follow(self, study: Study, meshes: Meshes | None) -> None:
        """Start what a study asks for and is not there; stop what it no longer asks for."""
        self._study, self._meshes = study, meshes
        self._run_missing()

    def run(self, choice: MethodChoice) -> Run | None:
        """Return what is known of a method with some parameters."""
        return self._store.get(self._key(choice))

    @property
    def busy(self) -> list[str]:
        """Titles of the methods that are being computed."""
        wanted = self._wanted()
        return [METHODS[wanted[key].method].title for key in wanted if key in self._running]

    @property
    def budget(self) -> int:
        """Memory for snapshots in bytes."""
        return self._store.budget

    @budget.setter
    def budget(self, budget: int) -> None:
        """Set the memory for snapshots; what no longer fits goes at once."""
        self._store.budget = budget
        self._store.trim(self._in_use())

    def cancel(self) -> None:
        """Stop all runs; what is there stays, and sliders beyond it go back to it."""
        for job in self._running.values():
            job.cancel()
        self._stop_short(self._wanted())

    def _key(self, choice: MethodChoice) -> RunKey:
        meshes = self._meshes.key if self._meshes else ""
        return meshes, _made_with(choice.method, tuple(choice.params.items()))

    def _wanted(self) -> dict[RunKey, MethodChoice]:
        return {self._key(choice): choice for choice in self._study.methods if choice.enabled}

    def _in_use(self) -> dict[RunKey, int]:
        """Runs that are shown, each with the iteration whose snapshot has to stay."""
        return {key: choice.iterations for key, choice in self._wanted().items()}

    def _target(self, key: RunKey) -> int:
        return self._in_use().get(key, 0)

    def _run_missing(self) -> None:
        wanted = self._wanted()
        for key, job in list(self._running.items()):
            if key not in wanted:
                job.cancel()
        for key, choice in wanted.items():
            self._run(key, choice)
        self.activity_changed.emit()

    def _run(self, key: RunKey, choice: MethodChoice) -> None:
        """Go on with a run, or make a snapshot again that memory did not hold."""
        if self._meshes is None or key in self._running:
            return
        comparison = self._meshes.comparison
        run, source = self._store.begin(key, comparison, choice)
        if run.computed < choice.iterations and not source.ended:
            self._start(key, choice, source.advance(lambda: self._target(key)))
        elif not run.holds(min(choice.iterations, run.computed)):
            kept = kept_iterations(comparison, choice, lambda: self._target(key))
            self._start(key, choice, self._again(key, kept))

    def _again(self, key: RunKey, iterations: Iterator[Kept | None]) -> Steps:
        for kept in iterations:
            yield kept
            if kept and kept.iteration >= self._target(key):
                return

    def _start(self, key: RunKey, choice: MethodChoice, steps: Steps) -> None:
        reached = 0

        def take(step: Kept | DivergenceError) -> None:
            nonlocal reached
            reached = step.iteration
            known = self._store.get(key)
            if known:
                self._store.put(key, known.extended(step, self._target(key)), self._in_use())
                self.grown.emit(choice.method)
                self.activity_changed.emit()

        def done() -> None:
            # A slider may have asked for more, or a cancelled run may be wanted again.
            self._running.pop(key, None)
            self._run_missing()

        job = Job(
            steps, take, self._report, done, title=METHODS[choice.method].title,
            share=lambda: min(reached / max(self._target(key), 1), 1.0),
            on_cancel=lambda: self._stop_short({key}), late=True,
        )  # fmt: skip
        self._running[key] = job
        self._jobs.start(job)

    def _stop_short(self, keys: Collection[RunKey]) -> None:
        """Let the sliders of runs go back to what is there."""
        study = self._study
        for key, choice in self._wanted().items():
            run = self._store.get(key)
            if key not in keys or not run or run.diverged:
                continue
            there = run.nearest(choice.iterations)
            if there < choice.iterations:
                study = study.with_choice(choice.model_copy(update={"iterations": there}))
        if study != self._study:
            self.stopped_short.emit(study)


@lru_cache(maxsize=256)
def _made_with(method: str, params: tuple[tuple[str, Any], ...]) -> str:
    """Say which method with which parameters; asked several times for each step of a run."""
    settings = MethodChoice(method=method, params=dict(params)).settings
    return f"{method} {settings.model_dump_json()}"
