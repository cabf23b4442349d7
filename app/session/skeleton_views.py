"""The skeletal graphs that the study asks for, drawn again whenever it changes."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import TypeVar

from psygnal import Signal

from app.session.jobs import Job, progress_job
from app.session.session import Session
from app.session.skeleton_invariance import InvarianceReport, invariance_steps
from app.session.skeleton_maker import Skeleton, SkeletonMaker, SkeletonSource
from core.mesh import TriangleMesh
from core.skeleton import AutomaticResolution, automatic_resolution_steps
from core.smoothing import METHODS
from core.statistics import Progress
from core.study import SkeletonView, Study

T = TypeVar("T")
VIEW_COUNT = 2
_Asked = tuple[str, SkeletonView]
_Made = tuple[_Asked, Skeleton | Exception]


class SkeletonViews:
    """Draws the graphs of a session's study beside the window; nothing while asleep.

    At most one job a view waits. It draws what is wanted when its turn comes, so that a slider
    that is dragged never leaves stale work behind.

    Parameters
    ----------
    session : Session
        What to listen to.
    """

    changed = Signal(int)
    """Another graph, or the reason why there is none, is there: (view)."""
    cancelled_changed = Signal(int)
    """The graph that is asked for was given up, or no longer is: (view)."""
    invariance_checked = Signal(int, object)
    """A check of invariance has ended: (view, report)."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._maker = SkeletonMaker(lambda: session.budget // 4)
        self._awake = False
        self._skeletons: list[Skeleton | None] = [None] * VIEW_COUNT
        self._problems = [""] * VIEW_COUNT
        self._wanted: list[tuple[SkeletonSource, SkeletonView] | None] = [None] * VIEW_COUNT
        self._drawn: list[_Asked | None] = [None] * VIEW_COUNT
        self._given_up: list[_Asked | None] = [None] * VIEW_COUNT
        self._jobs: list[Job | None] = [None] * VIEW_COUNT
        session.study_changed.connect(self._on_study_changed)
        session.meshes_changed.connect(self._update)
        session.run_changed.connect(self._on_run_changed)

    def set_awake(self, awake: bool) -> None:
        """Start or stop following the study."""
        self._awake = awake
        self._update()

    def skeleton(self, view: int) -> Skeleton | None:
        """Return the last graph of a view."""
        return self._skeletons[view]

    def problem(self, view: int) -> str:
        """Return why a view has no graph, or an empty text."""
        return self._problems[view]

    def is_cancelled(self, view: int) -> bool:
        """Whether the graph that a view asks for was cancelled; another may be shown."""
        return self._given_up[view] is not None

    def resume(self, view: int) -> None:
        """Draw the graph after all that was cancelled."""
        self._give_up(view, None)
        self._update()

    @property
    def shown(self) -> tuple[int, ...]:
        """Views that are shown."""
        return (0, 1) if self._session.study.skeleton.compare else (1,)

    @property
    def is_settled(self) -> bool:
        """Whether every shown view has what it asks for, or was cancelled."""
        return self._session.meshes is not None and not any(self._jobs)

    def find_resolution(self, view: int) -> None:
        """Find the resolution of a view by itself, and put it into the study."""

        def found(result: AutomaticResolution) -> None:
            settings = self._session.study.skeleton
            chosen = settings.views[view].model_copy(update={"resolution": result.resolution})
            self._session.notified.emit(_found_text(result))
            study = self._session.study.model_copy(
                update={"skeleton": settings.with_view(view, chosen)}
            )
            self._session.apply(study, "Automatic resolution")

        self._run(view, "Automatic resolution", _automatic, found)

    def check_invariance(self, view: int, seed: int) -> None:
        """Move a view's model at random and compare; `invariance_checked` tells the outcome."""

        def checked(report: InvarianceReport) -> None:
            self.invariance_checked.emit(view, report)

        title = "Check of invariance"
        self._run(view, title, lambda known: invariance_steps(known, seed), checked)

    def _run(
        self,
        view: int,
        title: str,
        work: Callable[[Skeleton], Iterator[Progress[T] | None]],
        use: Callable[[T], None],
    ) -> None:
        """Work on the graph of a view beside the window."""
        known = self._skeletons[view]
        if known is not None:
            job = progress_job(work(known), use, self._session.report, title=title)
            self._session.jobs.start(job, urgent=True)

    def _on_study_changed(self, study: Study, before: Study) -> None:
        if study.skeleton != before.skeleton or study.methods != before.methods:
            self._update()

    def _on_run_changed(self, method: str) -> None:
        if any(view.source == method for view in self._session.study.skeleton.views):
            self._update()

    def _update(self) -> None:
        if not self._awake or self._session.meshes is None:
            return
        views = self._session.study.skeleton.views
        for index in self.shown:
            source, asked = self._source(views[index]), self._asked(index)
            if asked != self._given_up[index]:
                self._give_up(index, None)
            if source is None:
                self._tell_problem(index, _absent_text(views[index].source))
            elif asked not in (self._drawn[index], self._given_up[index]):
                self._wanted[index] = source, views[index]
                self._start(index)

    def _start(self, index: int) -> None:
        if self._jobs[index]:
            return

        def steps() -> Iterator[Progress[_Made]]:
            wanted = self._wanted[index]
            if wanted is not None:
                yield from self._make(*wanted)

        def done() -> None:
            if self._jobs[index] is job:
                self._jobs[index] = None

        def cancel() -> None:
            done()  # what is asked for meanwhile need not wait
            asked = self._asked(index)
            self._give_up(index, asked if asked != self._drawn[index] else None)

        adopt, title = partial(self._adopt, index), "Skeletal graph"
        job = progress_job(steps(), adopt, self._session.report, done, title=title)
        job.on_cancel = cancel
        self._jobs[index] = job
        self._session.jobs.start(job, urgent=True)

    def _make(self, source: SkeletonSource, view: SkeletonView) -> Iterator[Progress[_Made]]:
        drawn: _Asked = source.key, view
        try:
            for step in self._maker.steps(source, view):
                yield Progress((drawn, step.value) if step.value else None, step.share)
        except ValueError as error:
            yield Progress((drawn, error), 1.0)

    def _adopt(self, index: int, result: _Made) -> None:
        self._drawn[index], made = result
        if isinstance(made, Skeleton):
            self._skeletons[index], self._problems[index] = made, ""
        else:
            self._skeletons[index], self._problems[index] = None, str(made)
        self._jobs[index] = None
        self._update()
        self.changed.emit(index)

    def _asked(self, index: int) -> _Asked | None:
        """What a view asks for; None where there is no surface."""
        view = self._session.study.skeleton.views[index]
        source = self._source(view)
        return (source.key, view) if source else None

    def _give_up(self, index: int, asked: _Asked | None) -> None:
        if asked != self._given_up[index]:
            self._given_up[index] = asked
            self.cancelled_changed.emit(index)

    def _tell_problem(self, index: int, problem: str) -> None:
        self._drawn[index] = self._wanted[index] = None
        self._skeletons[index], self._problems[index] = None, problem
        self.changed.emit(index)

    def _source(self, view: SkeletonView) -> SkeletonSource | None:
        """Return the surface of a view; None where its method has not run."""
        meshes = self._session.meshes
        if meshes is None:
            return None
        key, comparison = meshes.key, meshes.comparison
        if view.source in {"original", "noisy"}:
            mesh: TriangleMesh = getattr(comparison, view.source)
            return SkeletonSource(f"{key}|{view.source}", lambda: mesh)
        run = self._session.run(view.source) if view.source in METHODS else None
        if run is None:
            return None
        shown = self._session.shown_iteration(view.source)
        choice = self._session.study.choice(view.source)
        made_of = f"{view.source} {choice.settings.model_dump_json()} {shown}"
        return SkeletonSource(
            f"{key}|{made_of}", lambda: comparison.noisy.with_vertices(run.vertices(shown))
        )


def _automatic(known: Skeleton) -> Iterator[Progress[AutomaticResolution] | None]:
    steps = automatic_resolution_steps(known.mesh, known.field, spacing=known.view.spacing)
    found = yield from steps
    yield Progress(found, 1.0)


def _found_text(result: AutomaticResolution) -> str:
    shows = "shows" if result.is_complete else "is the largest and still does not show"
    return (
        f"R = {result.resolution} {shows} all {result.loops} loops and {result.branches} branches "
        f"longer than {result.share:.0%} of the field's range."
    )


def _absent_text(source: str) -> str:
    if source not in METHODS:
        return f"There is no surface {source}; allowed: original, noisy, {', '.join(METHODS)}."
    return f"{METHODS[source].title} has not run: check it on the Denoise tab."
