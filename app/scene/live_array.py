"""Numbers that Python writes and VTK draws, without a copy or a wrapper in between."""

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import numpy_to_vtk


class LiveArray:
    """A float32 array shared with VTK, to be written again and again.

    PyVista's own way to replace an array keeps the old one alive each time.

    Parameters
    ----------
    shape : tuple of int
        Number of rows, and of columns if there is more than one.
    name : str
        Name of the array in VTK.
    """

    def __init__(self, shape: tuple[int, ...], name: str) -> None:
        self._values = np.zeros(shape, np.float32)
        self.vtk = numpy_to_vtk(self._values, deep=False)
        self.vtk.SetName(name)

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self._values)

    def write(self, values: ArrayLike) -> None:
        """Replace all numbers; whatever draws them draws the new ones next."""
        self._values[...] = values
        self.vtk.Modified()
