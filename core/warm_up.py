"""Compiles every kernel once, so that no user waits for it: ``python -m core.warm_up``.

Kernels are compiled at their first call and then kept on disk, so running everything on a tiny
mesh is enough.
"""

from core.mesh import TriangleMesh, primitives
from core.mesh.geometry import shading_normals
from core.metrics import METRICS
from core.noise import add_noise
from core.smoothing import METHODS, smooth


def warm_up() -> None:
    """Run every method and every metric on a tiny mesh."""
    original = primitives.torus(8, 6)
    noisy = add_noise(original)
    _touch_topology(noisy)
    for method in METHODS:
        smooth(noisy, method, 1)
    for metric in METRICS.values():
        metric.evaluator(original).value(noisy.vertices)
    shading_normals(noisy.vertices, noisy.faces)


def _touch_topology(mesh: TriangleMesh) -> None:
    topology = mesh.topology
    _ = topology.face_ring, topology.genus, topology.boundary_vertices


if __name__ == "__main__":
    warm_up()
