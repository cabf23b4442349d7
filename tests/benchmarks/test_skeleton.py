"""Speed of the skeletal graph, in products of the mesh's adjacency with its positions."""

import time

import numpy as np
import pytest

from core.fields import scalar_field
from core.io import load_mesh
from core.skeleton import band_levels, graph_of, level_curves, reeb_graph


@pytest.fixture(scope="module")
def cow(shared_models):
    mesh = load_mesh(shared_models / "cow_92864.ply")
    return mesh, scalar_field(mesh, "mixture")


def shortest(action, repeats=9):
    """Shortest of several runs in seconds, after one that warms up."""
    action()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return min(times)


@pytest.mark.parametrize("resolution", [5, 22, 64])
def test_change_of_resolution(benchmark, ruler, cow, resolution):
    mesh, field = cow
    ruler.measure(benchmark, lambda: graph_of(mesh, field, band_levels(mesh, field, resolution)))
    if resolution == 22:
        assert benchmark.extra_info["units"] <= 25


def test_level_curves(benchmark, ruler, cow):
    mesh, field = cow
    ruler.measure(benchmark, lambda: level_curves(mesh, field, band_levels(mesh, field, 22)))


def test_full_reeb_graph(benchmark, ruler, cow):
    mesh, field = cow
    ruler.measure(benchmark, lambda: reeb_graph(mesh, field), rounds=10)


def test_a_hundredth_of_vtk(benchmark, ruler, cow):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkReebGraph

    mesh, field = cow
    points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.array(mesh.vertices), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(mesh.faces.ravel().astype(np.int64), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(cells)
    scalars = numpy_to_vtk(np.array(field.values), deep=True)
    levels = band_levels(mesh, field, 22)
    ours = shortest(lambda: graph_of(mesh, field, levels))
    ruler.measure(benchmark, lambda: vtkReebGraph().Build(surface, scalars), rounds=1)
    benchmark.extra_info["ratio"] = benchmark.stats.stats.min / ours
    assert benchmark.extra_info["ratio"] >= 100
