"""The statistics of the models on show: computed beside the window, and kept."""

import time
from collections import OrderedDict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, Literal

from psygnal import Signal

from app.export.statistics_series import SERIES_COLOURS, Series
from app.session import Job, Jobs
from core.mesh import TriangleMesh
from core.statistics import (
    GeodesicParams,
    Progress,
    SpectrumParams,
    StatisticsError,
    Summary,
    connectivity,
    geodesic_steps,
    spectrum_steps,
    summarise,
    vertex_distance_steps,
)

Kind = Literal["vertices", "spectrum", "geodesic", "picked"]
_KEPT = 60
_TELL_SECONDS = 0.4
_NAMES = {"vertices": "degrees", "spectrum": "spectrum", "geodesic": "geodesic distances",
          "picked": "distances from the vertex"}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Model:
    """A model on show.

    Attributes
    ----------
    name : str
        Its label.
    mesh : TriangleMesh
        The mesh; a model with the same mesh is the same.
    """

    name: str
    mesh: TriangleMesh


@dataclass(frozen=True, eq=False)
class _Task:
    """One computation: of what, with which parameters."""

    kind: Kind
    mesh: TriangleMesh
    params: Any = None

    @property
    def key(self) -> tuple[Any, ...]:
        """Equal keys have equal results: a spectrum does not depend on where the vertices are."""
        subject = self.mesh.topology if self.kind == "spectrum" else self.mesh
        return self.kind, id(subject), str(self.params)

    @property
    def takes_steps(self) -> bool:
        """Whether it is known on the way how far it is."""
        return self.kind in {"spectrum", "geodesic"}

    def steps(self) -> Iterator[Progress[Any]]:
        """Carry it out."""
        if self.kind == "spectrum":
            return spectrum_steps(self.mesh, self.params)
        if self.kind == "geodesic":
            return geodesic_steps(self.mesh, self.params)
        if self.kind == "picked":
            return vertex_distance_steps(self.mesh, *self.params)
        return self._vertices()

    def _vertices(self) -> Iterator[Progress[Any]]:
        yield Progress((connectivity(self.mesh), summarise(self.mesh)), 1.0)


def _same_mesh(old: tuple[Model, ...], new: tuple[Model, ...], place: int) -> bool:
    return place < len(new) and new[place].mesh is old[place].mesh


class StatisticsWork:
    """Computes what the shown models need and is not there yet.

    Parameters
    ----------
    jobs : Jobs
        Where the work is done.
    report : callable
        Told of what goes wrong.
    """

    changed = Signal()
    """A result has come or grown, or other models are on show."""
    activity_changed = Signal()
    """What is being computed has changed."""

    def __init__(self, jobs: Jobs, report: Callable[[Exception], None]) -> None:
        self.models: tuple[Model, ...] = ()
        self.geodesic = GeodesicParams()
        self.spectrum = SpectrumParams()
        self.relative = False
        self.picked: tuple[int, int] | None = None
        self._jobs, self._report = jobs, report
        self._told = 0.0
        # The task is kept with its result: its mesh must live as long as the key names its id.
        self._results: OrderedDict[tuple[Any, ...], tuple[_Task, Any, float]] = OrderedDict()
        self._running: dict[tuple[Any, ...], Job] = {}
        self._given_up: dict[tuple[Any, ...], _Task] = {}
        self._refused: dict[tuple[Any, ...], str] = {}

    def show(self, models: tuple[Model, ...]) -> None:
        """Show other models; the picked vertex stays while its mesh does."""
        if self.picked and not _same_mesh(self.models, models, self.picked[0]):
            self.picked = None
        self.models = models
        self.start()

    def set_params(self, geodesic: GeodesicParams, spectrum: SpectrumParams) -> None:
        """Measure in another way."""
        self.geodesic, self.spectrum = geodesic, spectrum
        self.start()

    def pick(self, model: int, vertex: int) -> None:
        """Measure the distances from a vertex of a model."""
        self.picked = (model, vertex)
        self.start()

    def start(self, *, again: bool = False) -> None:
        """Start what is missing and stop what is no longer wanted; `again` what was cancelled."""
        if again:
            self._given_up.clear()
            self._refused.clear()
        wanted = {task.key: task for task in self._tasks()}
        for key, job in self._running.items():
            if key not in wanted:
                job.cancel()
        for key, task in wanted.items():
            missing = key not in self._results or self._results[key][2] < 1
            if missing and key not in self._running and key not in self._given_up:
                self._start(task)
        self.changed.emit()
        self.activity_changed.emit()

    @property
    def cancelled(self) -> bool:
        """Whether something that is wanted was given up."""
        return any(task.key in self._given_up for task in self._tasks())

    @property
    def activity(self) -> str | None:
        """What is being computed, or None."""
        busy = [task for task in self._tasks() if task.key in self._running]
        names = dict.fromkeys(_NAMES[task.kind] for task in busy)
        return f"Computing {', '.join(names)}" if names else None

    def series(self) -> list[Series]:
        """Return what is known of the models on show, in their order."""
        found = []
        for place, model in enumerate(self.models):
            known = self._value(_Task("vertices", model.mesh))
            if known is None:
                break
            one = Series.of_vertices(model.name, SERIES_COLOURS[place], known[0])
            slow = self._slow_tasks(model)
            values = {task.kind: self._value(task) for task in slow}
            refused = {t.kind: self._refused[t.key] for t in slow if t.key in self._refused}
            found.append(replace(one, **values, relative=self.relative, refusals=refused))
        return found

    def summaries(self) -> list[Summary]:
        """Return the summaries that are there."""
        known = [self._value(_Task("vertices", model.mesh)) for model in self.models]
        return [value[1] for value in known if value]

    def distances(self, model: int) -> Any:
        """Return the distances from the picked vertex in ℓ̄, or None unless it is this model's."""
        task = self._picked_task()
        if task is None or self.picked is None or self.picked[0] != model:
            return None
        value = self._value(task)
        return None if value is None else value / (task.mesh.mean_edge_length or 1.0)

    def _tasks(self) -> list[_Task]:
        tasks = [_Task("vertices", model.mesh) for model in self.models]
        picked = self._picked_task()
        tasks += [picked] if picked else []
        for model in self.models:
            tasks += self._slow_tasks(model)
        return tasks

    def _slow_tasks(self, model: Model) -> list[_Task]:
        return [
            _Task("spectrum", model.mesh, self.spectrum),
            _Task("geodesic", model.mesh, self.geodesic),
        ]

    def _picked_task(self) -> _Task | None:
        if self.picked is None:
            return None
        model, vertex = self.picked
        return _Task("picked", self.models[model].mesh, (vertex, self.geodesic))

    def _start(self, task: _Task) -> None:
        key = task.key

        def step(progress: Progress[Any]) -> None:
            self._results[key] = task, progress.value, progress.share
            self._forget_oldest()
            self._tell(whole=progress.share >= 1, grown=progress.value is not None)

        def failed(error: Exception) -> None:
            self._given_up[key] = task
            if isinstance(error, StatisticsError):
                self._refused[key] = str(error)
            self._report(error)

        def give_up() -> None:
            self._given_up[key] = task
            self.activity_changed.emit()

        def done() -> None:
            self._running.pop(key, None)
            self.start()

        job = Job(
            task.steps(), step, failed, done, title=self._title(task),
            share=lambda: self._entry(key)[1] if task.takes_steps else None, on_cancel=give_up,
        )  # fmt: skip
        self._running[key] = job
        self._jobs.start(job, urgent=task.kind in {"vertices", "picked"})

    def _title(self, task: _Task) -> str:
        name = next((model.name for model in self.models if model.mesh is task.mesh), "")
        title = _NAMES[task.kind]
        return f"{title[:1].upper()}{title[1:]} of {name}" if name else title

    def _tell(self, *, whole: bool, grown: bool) -> None:
        """Tell of progress, but not so often that drawing it holds up the work."""
        now = time.monotonic()
        if whole or now - self._told > _TELL_SECONDS:
            self._told = now
            self.activity_changed.emit()
            if grown:
                self.changed.emit()

    def _entry(self, key: tuple[Any, ...]) -> tuple[Any, float]:
        _, value, share = self._results.get(key, (None, None, 0.0))
        return value, share

    def _value(self, task: _Task) -> Any:
        return self._entry(task.key)[0]

    def _forget_oldest(self) -> None:
        while len(self._results) > _KEPT:
            self._results.popitem(last=False)
