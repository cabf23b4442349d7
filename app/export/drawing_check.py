"""Whether pictures can be drawn here: VTK ends the process where there is no OpenGL for it."""

import subprocess
import sys
from functools import cache

from app.export.pictures import PictureError

_SECONDS = 60
_PROGRAM = """
from vtkmodules.vtkCommonCore import vtkLogger, vtkUnsignedCharArray
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(8, 8)
window.AddRenderer(vtkRenderer())
window.Render()
pixels = vtkUnsignedCharArray()
window.GetPixelData(0, 0, 7, 7, 1, pixels, 0)
raise SystemExit(pixels.GetNumberOfValues() != 8 * 8 * 3)
"""


def check_drawing() -> None:
    """Draw something in a process of its own, once; the process may die of it.

    Raises
    ------
    PictureError
        If nothing can be drawn: there is no OpenGL 3.2, or no driver at all.
    """
    if not _can_draw():
        raise PictureError(
            "Pictures cannot be drawn here: they need a graphics driver with OpenGL 3.2 or newer, "
            "for which Mesa's software renderer will do. All else was written."
        )


@cache
def _can_draw() -> bool:
    words = [sys.executable, "-I", "-c", _PROGRAM]
    try:
        ended = subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=_SECONDS,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except subprocess.TimeoutExpired:
        return False
    return ended.returncode == 0
