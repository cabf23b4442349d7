"""The model that is laid over the first: a file, a sample, or the session's own other meshes."""

from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.session import Job, Session
from app.session.meshes import read_with_mark
from app.ui.statistics_work import Model
from core.io import LoadedMesh, LoadError, bundled_samples
from core.mesh import TriangleMesh
from core.smoothing import METHODS
from core.statistics_view import METHOD_PREFIX, NO_SECOND, NOISY_SECOND
from core.study import SAMPLE_PREFIX, Study
from core.study_files import Fingerprint, fingerprint

NONE, OPEN = NO_SECOND, "open"
_NOISY, _METHOD = NOISY_SECOND, METHOD_PREFIX


class SecondModel(QObject):
    """Knows which models can be laid over the first, and gets the chosen one.

    Signals
    -------
    changed() : another model is chosen, or the chosen one has changed.
    """

    changed = Signal()

    def __init__(self, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._loaded: dict[str, LoadedMesh] = {}
        self._denoised: tuple[Any, int, TriangleMesh] | None = None
        session.study_changed.connect(self._on_study_changed)

    @property
    def chosen(self) -> str:
        """Id of the chosen model."""
        return str(self._session.study.statistics.second)

    def choices(self) -> dict[str, str]:
        """List the models by id."""
        files = {id_: _short(id_) for id_ in self._loaded if not id_.startswith(SAMPLE_PREFIX)}
        samples = {SAMPLE_PREFIX + sample.id: sample.title for sample in bundled_samples()}
        methods = {
            _METHOD + choice.method: f"Denoised: {METHODS[choice.method].title}"
            for choice in self._session.study.methods
            if choice.enabled
        }
        return {NONE: "None", _NOISY: "Noisy mesh", **methods, **samples, **files,
                OPEN: "Open a file…"}  # fmt: skip

    def choose(self, id_: str) -> None:
        """Choose a model by its id, which may be the path of a file; it may have to be read."""
        if self._is_file(id_):
            self._load(id_, self._choose)
        else:
            self._choose(id_)

    def model(self) -> Model | None:
        """Return the chosen model, or None where there is none (yet)."""
        meshes = self._session.meshes
        if meshes is None or self.chosen == NONE:
            return None
        if self.chosen == _NOISY:
            return Model("noisy", meshes.comparison.noisy)
        if self.chosen.startswith(_METHOD):
            return self._denoised_model(self.chosen.removeprefix(_METHOD))
        loaded = self._loaded.get(self.chosen)
        return Model(Path(loaded.name).stem, loaded.mesh) if loaded else None

    def _denoised_model(self, method: str) -> Model | None:
        run = self._session.run(method)
        if run is None:
            return None
        iteration = self._session.shown_iteration(method)
        positions = run.snapshot(iteration)
        if self._denoised is None or self._denoised[0] is not positions:
            noisy = self._session.meshes.comparison.noisy
            self._denoised = positions, iteration, noisy.with_vertices(run.vertices(iteration))
        return Model(f"{METHODS[method].title}, k = {iteration}", self._denoised[2])

    def _choose(self, id_: str) -> None:
        """Put a model that is there into the study."""
        study = self._session.study
        settings = study.statistics.model_copy(update={"second": id_})
        self._session.apply(study.model_copy(update={"statistics": settings}), "Second model")

    def _on_study_changed(self, study: Study, before: Study) -> None:
        if study.statistics.second == before.statistics.second:
            return
        if self._is_file(self.chosen):
            self._load(self.chosen, lambda _: self.changed.emit())
        self.changed.emit()

    @staticmethod
    def _is_file(id_: str) -> bool:
        return id_ not in {NONE, _NOISY} and not id_.startswith(_METHOD)

    def _load(self, id_: str, use: Callable[[str], None]) -> None:
        def read() -> Iterator[tuple[LoadedMesh, Fingerprint]]:
            yield self._known(id_) or read_with_mark(id_)

        def loaded(result: tuple[LoadedMesh, Fingerprint]) -> None:
            self._loaded[id_], self._session.others[id_] = result
            use(id_)

        def failed(error: Exception) -> None:
            self._session.report(error)
            self.changed.emit()

        job = Job(read(), loaded, failed, title=f"Loading {_short(id_)}")
        self._session.jobs.start(job, urgent=True)

    def _known(self, id_: str) -> tuple[LoadedMesh, Fingerprint] | None:
        """What a model was when it was read, unless its file has changed since."""
        mesh, mark = self._loaded.get(id_), self._session.others.get(id_)
        if mesh is None or mark is None:
            return None
        with suppress(OSError, LoadError):  # a file that is gone is still what it was
            if fingerprint(id_) != mark:
                return None
        return mesh, mark


def _short(path: str) -> str:
    return Path(path.removeprefix(SAMPLE_PREFIX)).name
