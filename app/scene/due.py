"""Which views of a window have to be drawn anew; the others keep their pixels."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkRenderWindow


class Seen(NamedTuple):
    """One view of a window.

    Attributes
    ----------
    renderers : tuple of vtkRenderer
        What draws it, from back to front.
    version : int
        Another one where anything but size, place and camera is to be seen otherwise.
    """

    renderers: tuple[vtkRenderer, ...]
    version: int


class Due:
    """Lets each drawing of a window draw only what is not to be seen already.

    Parameters
    ----------
    window : vtkRenderWindow
        Its drawings begin with :meth:`begin` and end with :meth:`end`.
    seen : callable
        Returns the views of now; together they fill the window.

    Attributes
    ----------
    is_complete : bool
        Whether the latest drawing left nothing to draw.
    """

    def __init__(self, window: vtkRenderWindow, seen: Callable[[], Sequence[Seen]]) -> None:
        self._window, self._seen = window, seen
        self._drawn: dict[vtkRenderer, tuple[object, ...]] = {}
        self._views: Sequence[Seen] = ()
        self._now: Sequence[Seen] = ()
        self._singly = False
        self.is_complete = False

    def forget(self) -> None:
        """Let the next drawing draw everything, because the pixels are lost or out of date."""
        self._drawn.clear()

    def draw_one(self) -> bool:
        """Draw a view that is due, behind what the window shows; return whether there was one."""
        self._singly, self._now = True, ()
        self._window.SetSwapBuffers(False)
        self._window.Render()
        self._window.SetSwapBuffers(True)
        self._singly = False
        return bool(self._now)

    def begin(self) -> None:
        """Leave out of the drawing that begins what would look as it does already."""
        self._views = self._seen()
        due = [
            view for view in self._views if self._drawn.get(view.renderers[0]) != self._state(view)
        ]
        self._now = due[:1] if self._singly else due
        self.is_complete = len(due) == len(self._now)
        for view in self._views:
            _set_drawn(view, view in self._now)

    def end(self) -> None:
        """Note what has been drawn."""
        first = [view.renderers[0] for view in self._views]
        self._drawn = {key: state for key, state in self._drawn.items() if key in first}
        self._drawn |= {view.renderers[0]: self._state(view) for view in self._now}
        for view in self._views:
            _set_drawn(view, True)

    def _state(self, view: Seen) -> tuple[object, ...]:
        first = view.renderers[0]
        place = self._window.GetSize(), first.GetViewport()
        return (view.version, place, *map(_sight, (r.GetActiveCamera() for r in view.renderers)))


def _set_drawn(view: Seen, drawn: bool) -> None:
    for renderer in view.renderers:
        renderer.SetDraw(drawn)


def _sight(camera: vtkCamera) -> tuple[object, ...]:
    """All of a camera that the picture depends on, and what the depth of a pixel depends on."""
    pose = camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()
    return (*pose, camera.GetViewAngle(), camera.GetWindowCenter(), camera.GetClippingRange())
