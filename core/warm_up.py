"""Compiles every kernel once, so that no user waits for it: ``python -m core.warm_up``.

Kernels are compiled at their first call and then kept on disk, so running everything on a tiny
mesh is enough.
"""

from collections.abc import Iterator

from core.comparison import Comparison, run_method
from core.doctor import REPAIRS, examine, repair
from core.fields import critical_vertices, scalar_field
from core.io.merging import merge_equal
from core.mesh import TriangleMesh, primitives
from core.mesh.geometry import shading_normals
from core.mesh.ordering import mean_step, surface_ordering
from core.noise import add_noise
from core.parameters import Params, describe
from core.skeleton import (
    automatic_resolution,
    band_levels,
    component_surfaces,
    cut_surface,
    graph_of,
    level_curves,
    loop_checks,
)
from core.smoothing import METHODS
from core.statistics import connectivity
from core.study import MethodChoice


def warm_up() -> None:
    """Run every method, metric and graph on a tiny mesh."""
    original = primitives.torus(8, 6)
    noisy = add_noise(original)
    _touch_topology(noisy)
    comparison = Comparison(original, noisy)
    _warm_up_methods(comparison)
    for vertices in (noisy.vertices, noisy.vertices.copy()):
        shading_normals(vertices, noisy.faces)
        for evaluator in comparison.evaluators.values():
            evaluator.value(vertices)
            evaluator.elements(vertices)
    _warm_up_skeleton(noisy)
    connectivity(noisy)
    _warm_up_doctor(noisy)


def _warm_up_methods(comparison: Comparison) -> None:
    """Run every method in every form, with all metrics.

    Two iterations, because the positions of a mesh are read-only and those of a run are not, and
    because the errors of several are measured in another form: a kernel is compiled for each.
    """
    for method, spec in METHODS.items():
        for params in ({}, *_other_forms(spec.params)):
            run_method(comparison, MethodChoice(method=method, iterations=2, params=params))


def _other_forms(params: type[Params]) -> Iterator[dict[str, bool | str]]:
    """Yield each switch and each choice that differs from its default."""
    for parameter in describe(params):
        allowed = (True, False) if parameter.kind == "bool" else parameter.choices
        yield from ({parameter.name: v} for v in allowed if v != parameter.default)


def _warm_up_skeleton(mesh: TriangleMesh) -> None:
    """Run everything that the resolution slider and the Reeb graph call."""
    field = scalar_field(mesh, "mixture")
    levels = band_levels(mesh, field, 5, "area")
    graph_of(mesh, field, levels, bands="vertices", root=True)
    graph = graph_of(mesh, field, levels)
    cut_surface(mesh, field, graph)
    level_curves(mesh, field, levels)
    automatic_resolution(mesh, field)
    critical_vertices(mesh, field.values)
    loop_checks(mesh, graph, component_surfaces(mesh))


def _warm_up_doctor(mesh: TriangleMesh) -> None:
    """Examine and repair a mesh with a hole."""
    open_mesh = TriangleMesh(mesh.vertices, mesh.faces[1:])
    examine(open_mesh)
    for id_ in REPAIRS:
        repair(open_mesh, id_)


def _touch_topology(mesh: TriangleMesh) -> None:
    topology = mesh.topology
    _ = topology.face_ring, topology.genus, topology.boundary_vertices
    mean_step(mesh.faces)
    _ = surface_ordering(mesh.faces, *topology.vertex_faces).renumbered(mesh.faces)
    turned = TriangleMesh(mesh.vertices, [mesh.faces[0][::-1], *mesh.faces[1:]])
    _ = turned.topology.is_orientable
    merge_equal(mesh.vertices)


if __name__ == "__main__":
    warm_up()
