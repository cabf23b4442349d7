"""Reading a mesh from a file of any supported format."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.io.errors import LoadError, one_line, printable
from core.io.gltf import read_gltf
from core.io.obj import read_obj
from core.io.off import read_off
from core.io.ply import read_ply
from core.io.polygons import Polygons, assemble
from core.io.stl import read_stl
from core.io.threemf import read_3mf
from core.io.vtk_polydata import read_vtk, read_vtp
from core.mesh import TriangleMesh

_READERS: dict[str, Callable[[Path], Polygons]] = {
    ".ply": read_ply,
    ".obj": read_obj,
    ".off": read_off,
    ".stl": read_stl,
    ".glb": read_gltf,
    ".gltf": read_gltf,
    ".vtp": read_vtp,
    ".vtk": read_vtk,
    ".3mf": read_3mf,
}
SUPPORTED_READ = tuple(_READERS)


@dataclass(frozen=True)
class LoadedMesh:
    """A mesh from a file, and what had to be changed to get it.

    Attributes
    ----------
    name : str
        Name of the file.
    mesh : TriangleMesh
        The mesh.
    report : tuple of str
        One short phrase for each kind of change; empty where nothing was changed.
    """

    name: str
    mesh: TriangleMesh
    report: tuple[str, ...] = ()

    @property
    def summary(self) -> str:
        """The report as one line; empty where nothing was changed."""
        return "; ".join(self.report)


def load_mesh(path: str | os.PathLike[str]) -> TriangleMesh:
    """Read a triangle mesh from a file; :func:`read_mesh` without the report.

    Parameters
    ----------
    path : str or path-like
        File whose suffix is one of `SUPPORTED_READ`.

    Returns
    -------
    TriangleMesh
        Vertices in the file's order.

    Raises
    ------
    LoadError
        One sentence with the file's name, whatever is wrong with the file.
    """
    return read_mesh(path).mesh


def read_mesh(path: str | os.PathLike[str]) -> LoadedMesh:
    """Read a triangle mesh from a file and tell what was changed.

    Polygons and strips become triangles; collapsed faces and unreferenced vertices are dropped;
    the parts of a scene are joined; equal corners of an STL file become one vertex. Apart from
    that, vertices keep the order and count of the file.

    Parameters
    ----------
    path : str or path-like
        File whose suffix is one of `SUPPORTED_READ`.

    Returns
    -------
    LoadedMesh
        The mesh and its report.

    Raises
    ------
    LoadError
        One sentence with the file's name: no such file, no permission, not of this format, cut
        short, vertex numbers out of range, coordinates that are not finite, no faces.
    """
    file = Path(path)
    name = printable(file.name or str(file))
    try:
        _check_file(file)
        # Numbers that are not finite travel quietly until they are refused with their vertex.
        with np.errstate(all="ignore"):
            mesh, report = assemble(_READERS[file.suffix.lower()](file))
    except LoadError as error:
        raise LoadError(f"{name}: {one_line(str(error))}.") from error
    except OSError as error:
        raise LoadError(
            f"{name}: cannot be read ({one_line(error.strerror or str(error))})."
        ) from error
    except MemoryError as error:
        raise LoadError(f"{name}: needs more memory than there is.") from error
    except Exception as error:
        # Readers of others raise whatever they like on a broken file.
        raise LoadError(f"{name}: is not well-formed ({_reason(error)}).") from error
    return LoadedMesh(name, mesh, report)


def _check_file(file: Path) -> None:
    if not file.exists():
        raise LoadError("there is no such file")
    if file.is_dir():
        raise LoadError("this is a folder, not a file")
    if file.suffix.lower() not in _READERS:
        raise LoadError(f"files of this kind are not read; allowed are {' '.join(SUPPORTED_READ)}")
    if not file.is_file():
        raise LoadError("this is not an ordinary file")
    if not file.stat().st_size:
        raise LoadError("the file is empty")


def _reason(error: Exception) -> str:
    text = f"{error} is missing or unknown" if isinstance(error, KeyError) else str(error)
    return one_line(text, 160) or "its parts do not fit together"
