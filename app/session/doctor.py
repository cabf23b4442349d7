"""The mesh doctor of a session: examines the model whenever it is another, and repairs it."""

from collections.abc import Callable, Iterator
from enum import Enum, auto
from typing import Any

from psygnal import Signal

from app.session.jobs import Job
from app.session.session import Session
from core.doctor import (
    NOTHING,
    REPAIRS,
    RepairChoice,
    Report,
    examination_steps,
    needed_repair_steps,
    repair_steps,
)
from core.mesh import TriangleMesh
from core.stepwise import Stepwise
from core.study import Study

REPAIR_ALL = "Repair all"


class _Stage(Enum):
    """How far a repair is."""

    CHOOSING = auto()
    LOADING = auto()


class Doctor:
    """Report on the session's model; repairs become steps of the study.

    Parameters
    ----------
    session : Session
        What to listen to.

    Attributes
    ----------
    report : Report or None
        What was found; None while the model is being examined.
    outcome : str
        What the last repair, or taking it back, has changed.
    """

    changed = Signal()
    """There is another report or outcome, or a new one is being made."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._patient: TriangleMesh | None = None
        self._stage: _Stage | None = None
        self._examination: Job | None = None
        self.report: Report | None = None
        self.outcome = ""
        session.meshes_changed.connect(self._examine)
        session.study_changed.connect(self._tell)
        session.activity_changed.connect(self._on_activity_changed)

    @property
    def is_busy(self) -> bool:
        """Whether a repair or an examination is under way."""
        return self.is_repairing or self._examination is not None

    @property
    def is_cancelled(self) -> bool:
        """Whether the examination of the model was given up."""
        return self._patient is not None and self.report is None and not self._examination

    @property
    def is_repairing(self) -> bool:
        """Whether a repair is under way."""
        return self._stage is not None

    @property
    def patient(self) -> TriangleMesh | None:
        """The mesh that the report is about."""
        return self._patient

    @property
    def changes(self) -> tuple[str, ...]:
        """What the repairs of the study changed, in their order."""
        return self._session.meshes.repairs if self._session.meshes else ()

    @property
    def loading(self) -> tuple[str, ...]:
        """What loading changed."""
        return self._session.meshes.report if self._session.meshes else ()

    def repair(self, repair: str, params: dict[str, Any]) -> None:
        """Do one repair, as a step that can be undone; where it changes nothing, say so."""
        choice = RepairChoice(repair=repair, params=params)

        def choose(mesh: TriangleMesh) -> Stepwise[tuple[RepairChoice, ...]]:
            changes = (yield from repair_steps(mesh, [choice])).changes
            return () if changes == (NOTHING,) else (choice,)

        self._repair(choose, REPAIRS[repair].title)

    def repair_all(self) -> None:
        """Do all repairs that remove a defect and keep the shape, as one step."""
        self._repair(needed_repair_steps, REPAIR_ALL)

    def _repair(
        self, choose: Callable[[TriangleMesh], Stepwise[tuple[RepairChoice, ...]]], name: str
    ) -> None:
        """Choose repairs beside the window, and put them into the study."""
        mesh = self._patient
        if mesh is None or self.is_busy:
            return
        self._stage, self.outcome = _Stage.CHOOSING, ""
        self.changed.emit()

        def steps() -> Iterator[tuple[RepairChoice, ...] | None]:
            yield (yield from choose(mesh))

        def use(choices: tuple[RepairChoice, ...]) -> None:
            if choices and mesh is self._patient:
                self._apply(choices, name)
            elif not choices:
                self._say(NOTHING)

        def done() -> None:
            if self._stage is _Stage.CHOOSING:
                self._end()

        job = Job(steps(), use, self._session.report, done, title=name)
        self._session.jobs.start(job, urgent=True)

    def _apply(self, choices: tuple[RepairChoice, ...], name: str) -> None:
        study = self._session.study
        update = {"repairs": study.repairs + choices}
        self._session.apply(study.model_copy(update=update), name)
        self._stage = _Stage.LOADING

    def _end(self) -> None:
        self._stage = None
        self.changed.emit()

    def _on_activity_changed(self) -> None:
        """End a repair that was cancelled or refused: no other meshes will come."""
        if self._stage is _Stage.LOADING and not self._session.is_loading:
            self._end()

    def _tell(self, study: Study, before: Study) -> None:
        """Say what the last repairs changed, or that they are taken back."""
        now, done = len(study.repairs), len(before.repairs)
        if study.model != before.model:
            self.outcome = ""
        if study.model != before.model or now == done:
            return
        if now > done:
            self._say(" ".join(self.changes[done:]))
        else:
            self._say("The mesh is as it was before the repair.")

    def _say(self, outcome: str) -> None:
        self.outcome = outcome
        self._session.notified.emit(outcome)
        self.changed.emit()

    def _examine(self) -> None:
        self._stage = None
        meshes = self._session.meshes
        mesh = meshes.comparison.original if meshes else None
        if mesh is not None and mesh is not self._patient:
            self._patient, self.report = mesh, None
            self._start(mesh)
        self.changed.emit()

    def resume(self) -> None:
        """Examine the model after all where that was cancelled."""
        if self._patient is not None and self.is_cancelled:
            self._start(self._patient)
            self.changed.emit()

    def _start(self, mesh: TriangleMesh) -> None:
        def steps() -> Iterator[Report | None]:
            yield (yield from examination_steps(mesh))

        def use(report: Report) -> None:
            if mesh is self._patient:
                self.report = report

        def done() -> None:
            if self._examination is job:
                self._examination = None
                self.changed.emit()

        if self._examination:
            self._examination.cancel()  # of a model that is no longer there
        job = Job(steps(), use, self._session.report, done, title="Examining the model")
        self._examination = job
        self._session.jobs.start(job)
