"""Which views of a window have to be drawn anew; the others keep their pixels."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from vtkmodules.vtkRenderingCore import (
    vtkAssembly,
    vtkCamera,
    vtkProp,
    vtkRenderer,
    vtkRenderWindow,
)


class Seen(NamedTuple):
    """One view of a window.

    Attributes
    ----------
    renderers : tuple of vtkRenderer
        What draws it, from back to front.
    version : int
        Another one where anything but size, place and camera is to be seen otherwise.
    parts : sequence of vtkProp
        Parts of all assemblies in it; they are opaque and take long.
    """

    renderers: tuple[vtkRenderer, ...]
    version: int
    parts: Sequence[vtkProp] = ()


@dataclass
class _Begun:
    """A view of which the first parts are drawn."""

    key: vtkRenderer
    state: tuple[object, ...]
    drawn: int = 0


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
        self._begun: _Begun | None = None
        self._hidden: list[vtkProp] = []
        self._singly = False
        self.is_complete = False

    def forget(self) -> None:
        """Let the next drawing draw everything, because the pixels are lost or out of date."""
        self._drawn.clear()
        self._begun = None

    def draw_one(self) -> bool:
        """Draw a view that is due, or the next part of it, behind what the window shows.

        Returns whether there was one.
        """
        self._singly, self._now = True, ()
        self._window.SetSwapBuffers(False)
        self._window.Render()
        self._window.SetSwapBuffers(True)
        self._singly = False
        return bool(self._now)

    def begin(self) -> None:
        """Leave out of the drawing that begins what would look as it does already."""
        self._views = self._seen()
        due = [view for view in self._views if self._drawn.get(_key(view)) != self._state(view)]
        self._now = due[:1] if self._singly else due
        for view in self._views:
            _set_drawn(view, view in self._now)
        self._begun = self._part_of(self._now[0]) if self._singly and due else None
        left = self._begun is not None and not self._is_last(self._now[0], self._begun)
        self.is_complete = len(due) == len(self._now) and not left

    def end(self) -> None:
        """Note what has been drawn."""
        first = [_key(view) for view in self._views]
        self._drawn = {key: state for key, state in self._drawn.items() if key in first}
        if self._begun is None:
            self._drawn |= {_key(view): self._state(view) for view in self._now}
        elif self._now:
            self._end_part(self._now[0], self._begun)
        for view in self._views:
            _set_drawn(view, True)

    def _part_of(self, view: Seen) -> _Begun:
        """Leave only the next part of a view, with the last one also all that is no part."""
        begun, state = self._begun, self._state(view)
        if begun is None or (begun.key, begun.state) != (_key(view), state):
            begun = _Begun(_key(view), state)
        parts, k = list(view.parts), begun.drawn
        others = parts[:k]
        if not self._is_last(view, begun):
            others += [*parts[k + 1 :], *_beside_assemblies(view)]
        self._hidden = [prop for prop in others if prop.GetVisibility()]
        for prop in self._hidden:
            prop.SetVisibility(False)
        _set_kept(view, k > 0)
        return begun

    def _end_part(self, view: Seen, begun: _Begun) -> None:
        for prop in self._hidden:
            prop.SetVisibility(True)
        self._hidden = []
        _set_kept(view, False)
        if self._is_last(view, begun):
            self._drawn[begun.key] = begun.state
            self._begun = None
        else:
            begun.drawn += 1

    @staticmethod
    def _is_last(view: Seen, begun: _Begun) -> bool:
        return begun.drawn + 1 >= len(view.parts)

    def _state(self, view: Seen) -> tuple[object, ...]:
        first = _key(view)
        place = self._window.GetSize(), first.GetViewport()
        return (view.version, place, *map(_sight, (r.GetActiveCamera() for r in view.renderers)))


def _key(view: Seen) -> vtkRenderer:
    return view.renderers[0]


def _set_drawn(view: Seen, drawn: bool) -> None:
    for renderer in view.renderers:
        renderer.SetDraw(drawn)


def _set_kept(view: Seen, kept: bool) -> None:
    """Let a view be drawn over what is there, or on a clean ground."""
    for renderer in view.renderers:
        renderer.SetPreserveColorBuffer(kept)
        renderer.SetPreserveDepthBuffer(kept)


def _beside_assemblies(view: Seen) -> list[vtkProp]:
    props = (prop for renderer in view.renderers for prop in renderer.GetViewProps())
    return [prop for prop in props if not isinstance(prop, vtkAssembly)]


def _sight(camera: vtkCamera) -> tuple[object, ...]:
    """All of a camera that the picture depends on, and what the depth of a pixel depends on."""
    pose = camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()
    return (*pose, camera.GetViewAngle(), camera.GetWindowCenter(), camera.GetClippingRange())
