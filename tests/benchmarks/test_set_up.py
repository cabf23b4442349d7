"""Set-up of a mesh before its first iteration, and opening its file.

Set-up is everything that depends on the faces alone: numbers that follow the surface, rings,
edges, winding, components, genus. Opening is compared with reading the bytes of the file.
"""

from dataclasses import replace
from timeit import repeat

import numpy as np
import pytest

from core.io import load_mesh, save_mesh
from core.mesh import TriangleMesh
from core.mesh.remesh import midpoint_subdivision

_ROUNDS = 9


@pytest.fixture(scope="module")
def meshes(original):
    """The small mesh, and the same with sixteen times the faces."""
    return {"small": original, "large": midpoint_subdivision(midpoint_subdivision(original))}


def set_up(mesh):
    topology = TriangleMesh(mesh.vertices, mesh.faces).topology
    along = topology.along_surface
    return along.face_ring, along.edge_corners, along.ring_edges, topology.genus


@pytest.mark.parametrize("size", ["small", "large"])
def test_set_up_along_the_surface(benchmark, ruler, meshes, size):
    mesh = meshes[size]
    ruler = replace(ruler, mesh=mesh, units=[])
    ruler.measure(benchmark, lambda: set_up(mesh), _ROUNDS)
    ruler.compare(
        benchmark, "small mesh", lambda: set_up(mesh), lambda: set_up(meshes["small"]), _ROUNDS
    )


@pytest.mark.parametrize("suffix", [".ply", ".stl", ".obj"])
def test_opening(benchmark, ruler, meshes, tmp_path, suffix):
    path = tmp_path / f"large{suffix}"
    save_mesh(meshes["large"], path)
    replace(ruler, mesh=meshes["large"], units=[]).measure(benchmark, lambda: load_mesh(path), 3)
    seconds = min(benchmark.stats.stats.data)
    reading = min(repeat(lambda: np.fromfile(path, np.uint8), number=1, repeat=_ROUNDS))
    benchmark.extra_info["MB/s"] = round(path.stat().st_size / 1e6 / seconds)
    benchmark.extra_info["times reading"] = round(seconds / reading, 1)
