"""Reading the meshes of a study, without reading twice what has not changed."""

from dataclasses import dataclass
from pathlib import Path

from core.comparison import Comparison, matched, read_model
from core.io import LoadedMesh
from core.noise import add_noise
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
    """

    key: str
    name: str
    report: tuple[str, ...]
    comparison: Comparison
    fingerprints: dict[str, Fingerprint]


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
        self._meshes: dict[str, Meshes] = {}

    def known(self, study: Study) -> Meshes | None:
        """Return the meshes of a study where they are still there."""
        return self._meshes.get(mesh_key(study))

    def read(self, study: Study) -> Meshes:
        """Read the meshes of a study and prepare what every method needs."""
        meshes = self._read(study)
        self._meshes[meshes.key] = meshes
        while len(self._meshes) > _FEWEST_PAIRS and self._bytes() > _SHARE * self.budget:
            self._meshes.pop(next(iter(self._meshes)))
        return meshes

    def _bytes(self) -> int:
        pairs = self._meshes.values()
        return sum(_PREPARED * pair.comparison.noisy.vertices.nbytes for pair in pairs)

    def _read(self, study: Study) -> Meshes:
        key = mesh_key(study)
        original, mark = self._file(study.model)
        marks = {study.model: mark}
        if study.noisy is None:
            noisy = add_noise(original.mesh, study.noise.sigma, study.noise.seed)
        else:
            scan, marks[study.noisy] = self._file(study.noisy)
            noisy = matched(original.mesh, scan)
        comparison = Comparison(original.mesh, noisy, study.model_units)
        _ = comparison.noisy_errors  # prepares the metrics here, beside the window
        return Meshes(key, original.name, original.report, comparison, marks)

    def _file(self, model: str) -> tuple[LoadedMesh, Fingerprint]:
        key = (model, _changed_at(model))
        if key not in self._files:
            self._files[key] = read_model(model), fingerprint(model)
        while len(self._files) > _KEPT:
            self._files.pop(next(iter(self._files)))
        return self._files[key]


def mesh_key(study: Study) -> str:
    """Say what the meshes of a study are made from, the state of the files included."""
    files = [f"{model}@{_changed_at(model)}" for model in (study.model, study.noisy) if model]
    noise = "" if study.noisy else study.noise.model_dump_json()
    return "|".join([*files, noise, "model units" if study.model_units else ""])


def _changed_at(model: str) -> int:
    """Time of the last change of a file, 0 for a bundled model or a file that is gone."""
    path = Path(model)
    if model.startswith(SAMPLE_PREFIX) or not path.exists():
        return 0
    return path.stat().st_mtime_ns
