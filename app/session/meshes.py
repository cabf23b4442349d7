"""Reading the meshes of a study, without reading twice what has not changed."""

from dataclasses import dataclass
from pathlib import Path

from core.comparison import Comparison, matched, read_model
from core.io import LoadedMesh
from core.noise import add_noise
from core.study import SAMPLE_PREFIX, Study

_KEPT = 4


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
    """

    key: str
    name: str
    report: tuple[str, ...]
    comparison: Comparison


class MeshReader:
    """Reads meshes and keeps the last few files, with the topology they share."""

    def __init__(self) -> None:
        self._files: dict[tuple[str, int], LoadedMesh] = {}

    def read(self, study: Study) -> Meshes:
        """Read the meshes of a study and prepare what every method needs."""
        original = self._file(study.model)
        if study.noisy is None:
            noisy = add_noise(original.mesh, study.noise.sigma, study.noise.seed)
        else:
            noisy = matched(original.mesh, self._file(study.noisy))
        comparison = Comparison(original.mesh, noisy, study.model_units)
        _ = comparison.noisy_errors  # prepares the metrics here, beside the window
        return Meshes(mesh_key(study), original.name, original.report, comparison)

    def _file(self, model: str) -> LoadedMesh:
        key = (model, _changed_at(model))
        if key not in self._files:
            self._files[key] = read_model(model)
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
