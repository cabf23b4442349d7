"""How meshes are looked at: shading, colours, cameras. A part of a study, so undo covers it."""

import math
from typing import Literal

from pydantic import model_validator

from core.parameters import Params, param

ColourMap = Literal["viridis", "cividis", "magma", "inferno", "gray"]
ColourRange = Literal["percentile", "full", "manual"]
Coordinates = tuple[float, float, float]

# A renderer squares lengths and holds them in single precision; models end long before these.
_SHORTEST, _LONGEST = 1e-18, 1e18
# Sine of the smallest angle between the line of sight and the direction that is up.
_PARALLEL = 1e-6


def check_camera(position: Coordinates, focal_point: Coordinates, view_up: Coordinates) -> None:
    """See that a renderer can draw what a camera sees.

    Raises
    ------
    ValueError
        One sentence: a coordinate that is not finite or too large, or a direction that is none.
    """
    numbers = (*position, *focal_point, *view_up)
    if not all(abs(number) <= _LONGEST for number in numbers):
        raise ValueError(
            f"Coordinates of a camera must be numbers from −{_LONGEST:g} to {_LONGEST:g}."
        )
    sight = tuple(to - at for to, at in zip(focal_point, position, strict=True))
    shortest = min(math.hypot(*sight), math.hypot(*view_up))
    if shortest < _SHORTEST or not _sine(sight, view_up) > _PARALLEL:
        raise ValueError(
            "This camera sees nothing: its position must lie off the point it looks at, "
            "and its view_up must point sideways to that line."
        )


def _sine(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    """Sine of the angle between two directions, whose lengths are not zero."""
    ax, ay, az = (number / math.hypot(*a) for number in a)
    bx, by, bz = (number / math.hypot(*b) for number in b)
    return math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)


class NamedCamera(Params):
    """A camera that was saved: its name, and where it stands in model units from the centroid."""

    name: str = param(..., help="Name that a person gave it.")
    position: Coordinates = param(..., help="Where the camera is.")
    focal_point: Coordinates = param(..., help="The point it looks at.")
    view_up: Coordinates = param(..., help="Direction that is up in the picture.")

    @model_validator(mode="after")
    def _sees_something(self) -> "NamedCamera":
        check_camera(self.position, self.focal_point, self.view_up)
        return self


class ViewSettings(Params):
    """How the panes show the meshes."""

    smooth_shading: bool = param(True, help="Smooth shading; off shows every face flat.")
    edges: bool = param(False, help="Draw the edges of the triangles.")
    colour: str = param("none", help="Metric that colours the panes, or none.")
    colour_map: ColourMap = param(
        "viridis", help="Colours of the values; all grow evenly and suit colour-blind eyes."
    )
    colour_reversed: bool = param(False, help="Give the largest value the darkest colour.")
    colour_range: ColourRange = param(
        "percentile",
        help="Ends of the colour bar: 0 to the 98th percentile of the middling pane, "
        "smallest to largest value of all panes, or two numbers.",
    )
    colour_low: float = param(0.0, help="Value at the lower end of the bar, where set by hand.")
    colour_high: float = param(1.0, help="Value at the upper end of the bar, where set by hand.")
    histogram: bool = param(True, help="Draw the histogram of the values beside the bar.")
    compare_with: str = param(
        "original", help="Pane that the selected one is compared with: original, noisy or a method."
    )
    linked: bool = param(True, help="Move the cameras of all panes together.")
    cameras: tuple[NamedCamera, ...] = param((), help="Cameras that were saved by name.")

    def coloured_by(self, metric: str) -> "ViewSettings":
        """Return the settings with another metric; ends set by hand belong to the old one."""
        update: dict[str, object] = {"colour": metric}
        if metric != self.colour and self.colour_range == "manual":
            update["colour_range"] = "percentile"
        return self.model_copy(update=update)

    def with_camera(self, camera: NamedCamera) -> "ViewSettings":
        """Return the settings with a camera added, in place of one of the same name."""
        others = tuple(old for old in self.cameras if old.name != camera.name)
        return self.model_copy(update={"cameras": (*others, camera)})

    def without_camera(self, name: str) -> "ViewSettings":
        """Return the settings without the camera of a name."""
        kept = tuple(camera for camera in self.cameras if camera.name != name)
        return self.model_copy(update={"cameras": kept})
