"""The bundled models."""

from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

from core.io.errors import LoadError
from core.io.reading import load_mesh
from core.mesh import TriangleMesh

# In display order; a model without a title here goes by its file's name, after these.
_TITLES = {
    "creature": "Creature",
    "double_torus": "Double torus",
    "machine_part": "Machine part",
}


@dataclass(frozen=True)
class Sample:
    """A bundled model.

    Attributes
    ----------
    id : str
        Name for the command line and for study files.
    title : str
        Name as a person reads it.
    path : Path
        Its file.
    """

    id: str
    title: str
    path: Path


def bundled_samples() -> tuple[Sample, ...]:
    """List the bundled models in display order; empty where none are installed."""
    try:
        folder = Path(str(files("resources") / "models"))
    except ModuleNotFoundError:
        return ()
    found = {path.stem: path for path in sorted(folder.glob("*.ply"))}
    order = [
        *(name for name in _TITLES if name in found),
        *(name for name in found if name not in _TITLES),
    ]
    return tuple(Sample(name, _title(name), found[name]) for name in order)


def _title(name: str) -> str:
    return _TITLES.get(name, name.replace("_", " ").capitalize())


def sample_path(name: str) -> Path:
    """Return the file of a bundled model.

    Parameters
    ----------
    name : str
        Id of one of :func:`bundled_samples`.

    Returns
    -------
    Path
        Its file.

    Raises
    ------
    LoadError
        If there is no such model; lists those there are.
    """
    samples = {sample.id: sample for sample in bundled_samples()}
    if name not in samples:
        allowed = ", ".join(samples) or "none"
        raise LoadError(f"{name} is not a bundled model; allowed: {allowed}.")
    return samples[name].path


def load_sample(name: str) -> TriangleMesh:
    """Read a bundled model, as :func:`load_mesh` does with its file.

    Raises
    ------
    LoadError
        If there is no such model; lists those there are.
    """
    return load_mesh(sample_path(name))
