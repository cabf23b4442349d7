"""The mathematics of Burnish: meshes, noise, smoothing methods, metrics and studies."""

from core.comparison import run
from core.doctor import examine, repair
from core.fields import FIELDS, scalar_field
from core.io import LoadError, SaveError, load_mesh, save_mesh
from core.mesh import MeshError, TriangleMesh
from core.metrics import METRICS, visual_error
from core.noise import add_noise
from core.parameters import ParameterError
from core.skeleton import skeletal_graph
from core.smoothing import METHODS, DivergenceError, smooth
from core.statistics import mesh_statistics
from core.study import Study

__all__ = [
    "FIELDS",
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
    "examine",
    "load_mesh",
    "mesh_statistics",
    "repair",
    "run",
    "save_mesh",
    "scalar_field",
    "skeletal_graph",
    "smooth",
    "visual_error",
]
