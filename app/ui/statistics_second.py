"""The model that is laid over the first: a file, a sample, or the session's own other meshes."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.session import Job, Session
from app.ui.statistics_work import Model
from core.comparison import read_model
from core.io import LoadedMesh, bundled_samples
from core.mesh import TriangleMesh
from core.smoothing import METHODS
from core.study import SAMPLE_PREFIX

NONE, OPEN = "none", "open"
_NOISY, _METHOD = "noisy", "method:"


class SecondModel(QObject):
    """Knows which models can be laid over the first, and gets the chosen one.

    Signals
    -------
    changed() : another model is chosen, or the chosen one has changed.
    failed(str) : it cannot be read.
    """

    changed = Signal()
    failed = Signal(str)

    def __init__(self, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self.chosen = NONE
        self._session = session
        self._loaded: dict[str, LoadedMesh] = {}
        self._denoised: tuple[Any, int, TriangleMesh] | None = None

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
        if id_ in self._loaded or id_ not in self.choices() or id_.startswith(SAMPLE_PREFIX):
            self._load(id_)
            return
        self.chosen = id_
        self.changed.emit()

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
        positions = run.positions[iteration]
        if self._denoised is None or self._denoised[0] is not positions:
            noisy = self._session.meshes.comparison.noisy
            self._denoised = positions, iteration, noisy.with_vertices(run.vertices(iteration))
        return Model(f"{METHODS[method].title}, k = {iteration}", self._denoised[2])

    def _load(self, id_: str) -> None:
        def read() -> Iterator[LoadedMesh]:
            yield self._loaded.get(id_) or read_model(id_)

        def loaded(mesh: LoadedMesh) -> None:
            self._loaded[id_] = mesh
            self.chosen = id_
            self.changed.emit()

        def failed(error: Exception) -> None:
            self.failed.emit(str(error) or type(error).__name__)
            self.changed.emit()

        self._session.jobs.start(Job(read(), loaded, failed), urgent=True)


def _short(path: str) -> str:
    return Path(path).name
