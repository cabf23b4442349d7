"""The mathematics of Burnish: meshes, noise, smoothing methods, metrics and studies."""

from core.comparison import run
from core.io import LoadError, SaveError, load_mesh, save_mesh
from core.mesh import MeshError, TriangleMesh
from core.metrics import METRICS, visual_error
from core.noise import add_noise
from core.parameters import ParameterError
from core.smoothing import METHODS, DivergenceError, smooth
from core.study import Study

__all__ = [
    "METHODS",
    "METRICS",
    "DivergenceError",
    "LoadError",
    "MeshError",
    "ParameterError",
    "SaveError",
    "Study",
    "TriangleMesh",
    "add_noise",
    "load_mesh",
    "run",
    "save_mesh",
    "smooth",
    "visual_error",
]
