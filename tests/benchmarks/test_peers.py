"""One iteration of other programs' smoothing, on the same mesh in the same process.

They come with the extra ``bench`` (``pip install .[bench]``); each is skipped where it is missing.
"""

from importlib import import_module

import numpy as np
import pytest


def peer(name):
    try:
        return import_module(name)
    except ModuleNotFoundError:
        pytest.skip(f"{name} is not installed; it comes with the extra bench")
    except ImportError as error:
        pytest.skip(f"{name} does not work here: {error}")


@pytest.fixture
def meshlab(noisy):
    pymeshlab = peer("pymeshlab")
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(np.array(noisy.vertices), np.array(noisy.faces)))
    return meshes


def test_meshlab_laplacian(benchmark, ruler, meshlab):
    """The flow that our `laplacian` is."""
    ruler.measure_iteration(
        benchmark,
        lambda n: meshlab.apply_coord_laplacian_smoothing(
            stepsmoothnum=n, boundary=False, cotangentweight=False
        ),
    )


def test_meshlab_cotangent_laplacian(benchmark, ruler, meshlab):
    """The flow that our `weighted_laplacian` is."""
    ruler.measure_iteration(
        benchmark,
        lambda n: meshlab.apply_coord_laplacian_smoothing(
            stepsmoothnum=n, boundary=False, cotangentweight=True
        ),
    )


def test_meshlab_two_steps(benchmark, ruler, meshlab):
    """Normals averaged, then vertices fitted, once each: the nearest to our `mean`."""
    ruler.measure_iteration(
        benchmark,
        lambda n: meshlab.apply_coord_two_steps_smoothing(
            stepsmoothnum=n, stepnormalnum=1, stepfitnum=1
        ),
    )


def test_meshlib_relax(benchmark, ruler, noisy):
    """Every vertex half the way to the mean of its ring: the nearest to our `laplacian`."""
    peer("meshlib")
    from meshlib import mrmeshnumpy, mrmeshpy

    mesh = mrmeshnumpy.meshFromFacesVerts(np.array(noisy.faces), np.array(noisy.vertices))
    settings = mrmeshpy.MeshRelaxParams()

    def run(n):
        settings.iterations = n
        mrmeshpy.relax(mesh, settings)

    ruler.measure_iteration(benchmark, run)


def test_vtk_windowed_sinc(benchmark, ruler, noisy):
    pyvista = peer("pyvista")
    from vtkmodules.vtkFiltersCore import vtkWindowedSincPolyDataFilter

    surface = pyvista.PolyData.from_regular_faces(np.array(noisy.vertices), np.array(noisy.faces))

    def run(n):
        smoother = vtkWindowedSincPolyDataFilter()
        smoother.SetInputData(surface)
        smoother.SetNumberOfIterations(n)
        smoother.Update()

    ruler.measure_iteration(benchmark, run)


def test_open3d_simple(benchmark, ruler, noisy):
    """Every vertex to the mean of its ring and itself."""
    open3d = peer("open3d")
    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(np.array(noisy.vertices)),
        open3d.utility.Vector3iVector(np.array(noisy.faces)),
    )
    ruler.measure_iteration(benchmark, mesh.filter_smooth_simple)
