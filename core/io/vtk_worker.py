"""Reads one file with VTK in a process of its own: ``python -I vtk_worker.py legacy|xml FILE``.

Writes the arrays to standard output in numpy's format, or one line to standard error. It imports
nothing of the project, so that it can be started by its path.
"""

import io
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

_READERS: dict[str, Any] = {"legacy": vtkPolyDataReader, "xml": vtkXMLPolyDataReader}


def _bound_memory(file_size: int) -> None:
    """Let a file that lies about its counts fail here instead of taking the machine's memory."""
    try:
        import resource
    except ImportError:  # not on Windows
        return
    limit = (1 << 30) + 50 * file_size
    resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _read(kind: str, path: str) -> dict[str, NDArray[Any]]:
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    messages = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(messages)
    reader = _READERS[kind]()
    reader.SetFileName(path)
    reader.Update()
    if "ERROR" in messages.GetOutput():
        raise ValueError(messages.GetOutput())
    return _arrays(reader.GetOutput())


def _arrays(data: Any) -> dict[str, NDArray[Any]]:
    points = data.GetPoints()
    arrays = {"vertices": np.zeros((0, 3)) if points is None else vtk_to_numpy(points.GetData())}
    for name, cells in (("face", data.GetPolys()), ("strip", data.GetStrips())):
        arrays[f"{name}_sizes"] = np.diff(vtk_to_numpy(cells.GetOffsetsArray()))
        arrays[f"{name}_corners"] = vtk_to_numpy(cells.GetConnectivityArray())
    return arrays


def _reason(error: Exception) -> str:
    """Return what the first of VTK's messages says, without the source file and the address."""
    lines = [line for line in str(error).splitlines() if line and not line.startswith("ERROR")]
    return (
        lines[0].rpartition("): ")[2].partition(" for file")[0]
        if lines
        else "nothing more is known"
    )


def main() -> int:
    """Read the file named on the command line."""
    kind, path = sys.argv[1:]
    _bound_memory(Path(path).stat().st_size)
    try:
        arrays = _read(kind, path)
    except Exception as error:  # noqa: BLE001 - the other process reports it
        sys.stderr.write(_reason(error))
        return 1
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    sys.stdout.buffer.write(buffer.getvalue())
    return 0


if __name__ == "__main__":
    sys.exit(main())
