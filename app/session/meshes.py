"""Reading the meshes of a study, without reading twice what has not changed."""

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from core.comparison import Comparison
from core.doctor import Repaired, repair_steps
from core.io import LoadedMesh, LoadError
from core.models import matched, read_model
from core.noise import add_noise
from core.stepwise import Stepwise, carried_out
from core.study import SAMPLE_PREFIX, Study
from core.study_files import Fingerprint, fingerprint

_KEPT = 4
# Pairs of meshes take this share of the memory for results, and a pair takes about this many
# times its noisy vertices, because the metrics keep what they have prepared.
_SHARE = 0.25
_PREPARED = 20
_FEWEST_PAIRS = 2


@dataclass(frozen=True, eq=False)
class Meshes:
    """The meshes of a study.

    Attributes
    ----------
    key : str
        Says what they were made from; equal keys mean equal meshes.
    name : str
        File name of the original.
    report : tuple of str
        What loading changed.
    comparison : Comparison
        The original and the noisy mesh.
    fingerprints : dict of str to Fingerprint
        What each file was when it was read.
    repairs : tuple of str
        What each repair of the study changed, one sentence for each.
    """

    key: str
    name: str
    report: tuple[str, ...]
    comparison: Comparison
    fingerprints: dict[str, Fingerprint]
    repairs: tuple[str, ...] = ()


class MeshReader:
    """Reads meshes and keeps the last ones, with the topology they share.

    Parameters
    ----------
    budget : int
        Memory for all results in bytes, of which the pairs take a share.
    """

    def __init__(self, budget: int) -> None:
        self.budget = budget
        self._files: dict[tuple[str, int], tuple[LoadedMesh, Fingerprint]] = {}
        self._repaired: dict[str, Repaired] = {}
        self._meshes: dict[str, Meshes] = {}
        self._open: set[str | None] = set()

    def known(self, study: Study) -> Meshes | None:
        """Return the meshes of a study where they are still there."""
        return self._meshes.get(mesh_key(study))

    def read(self, study: Study) -> Meshes:
        """Read the meshes of a study and prepare what every method needs."""
        return carried_out(self.read_steps(study))

    def read_steps(self, study: Study) -> Stepwise[Meshes]:
        """Return what `read` does; whoever iterates may stop after any step."""
        meshes = yield from self._read(study)
        self._meshes[meshes.key] = meshes
        self._open = {study.model, study.noisy}
        while len(self._meshes) > _FEWEST_PAIRS and self._bytes() > _SHARE * self.budget:
            self._meshes.pop(next(iter(self._meshes)))
        return meshes

    def _bytes(self) -> int:
        pairs = self._meshes.values()
        return sum(_PREPARED * pair.comparison.noisy.vertices.nbytes for pair in pairs)

    def _read(self, study: Study) -> Stepwise[Meshes]:
        key = mesh_key(study)
        original, mark = self._file(study.model)
        marks = {study.model: mark}
        whole = yield from self._whole(study, original)
        if study.noisy is None:
            noisy = add_noise(whole.mesh, study.noise.sigma, study.noise.seed)
        else:
            scan, marks[study.noisy] = self._file(study.noisy)
            noisy = whole.carry(matched(original.mesh, scan))
        yield
        comparison = Comparison(whole.mesh, noisy, study.model_units)
        _ = comparison.noisy_errors  # prepares the metrics here, beside the window
        return Meshes(key, original.name, original.report, comparison, marks, whole.changes)

    def _whole(self, study: Study, original: LoadedMesh) -> Stepwise[Repaired]:
        """Repair the original; kept, so that other noise finds the same topology."""
        key = "|".join([_file_key(study.model), *_repair_keys(study)])
        if key not in self._repaired:
            self._repaired[key] = yield from repair_steps(original.mesh, study.repairs)
        while len(self._repaired) > _KEPT:
            self._repaired.pop(next(iter(self._repaired)))
        return self._repaired[key]

    def _file(self, model: str) -> tuple[LoadedMesh, Fingerprint]:
        key = (model, _changed_at(model))
        if key not in self._files:
            self._files[key] = self._last_known(model) or read_with_mark(model)
        while len(self._files) > _KEPT:
            self._files.pop(next(iter(self._files)))
        return self._files[key]

    def _last_known(self, model: str) -> tuple[LoadedMesh, Fingerprint] | None:
        """What the open file was if it is no longer there: work on it goes on."""
        if model not in self._open or model.startswith(SAMPLE_PREFIX) or Path(model).exists():
            return None
        known = [key for key in self._files if key[0] == model]
        return self._files[known[-1]] if known else None


def read_with_mark(model: str) -> tuple[LoadedMesh, Fingerprint]:
    """Read a model and say what its file was; both are of the same content.

    Raises
    ------
    LoadError
        If it cannot be read, or changes meanwhile.
    """
    before = _changed_at(model)
    loaded = read_model(model)
    with suppress(OSError):
        mark = fingerprint(model)
        if _changed_at(model) == before:
            return loaded, mark
    raise LoadError(f"{loaded.name}: has changed while it was read; open it again.")


def mesh_key(study: Study) -> str:
    """Say what the meshes of a study are made from, the state of the files included."""
    files = [_file_key(model) for model in (study.model, study.noisy) if model]
    noise = "" if study.noisy else study.noise.model_dump_json()
    units = "model units" if study.model_units else ""
    return "|".join([*files, *_repair_keys(study), noise, units])


def _file_key(model: str) -> str:
    return f"{model}@{_changed_at(model)}"


def _repair_keys(study: Study) -> list[str]:
    return [choice.model_dump_json() for choice in study.repairs]


def _changed_at(model: str) -> int:
    """Time of the last change of a file, 0 for a bundled model or a file that is gone."""
    path = Path(model)
    if model.startswith(SAMPLE_PREFIX) or not path.exists():
        return 0
    return path.stat().st_mtime_ns
