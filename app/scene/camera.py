"""Moving cameras: presets, zooming into a rectangle, flying to a point."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkCamera

from core.arrays import FloatArray

PRESETS: dict[str, tuple[tuple[float, float, float], tuple[float, float, float]]] = {
    "Oblique": ((0.55, 0.35, 1.0), (0, 1, 0)),
    "Front (+Z)": ((0, 0, 1), (0, 1, 0)),
    "Back (−Z)": ((0, 0, -1), (0, 1, 0)),
    "Right (+X)": ((1, 0, 0), (0, 1, 0)),
    "Left (−X)": ((-1, 0, 0), (0, 1, 0)),
    "Top (+Y)": ((0, 1, 0), (0, 0, -1)),
    "Bottom (−Y)": ((0, -1, 0), (0, 0, 1)),
    "Oblique, Z up": ((-0.7, -1.0, 0.5), (0, 0, 1)),
}
"""Direction from the model to the camera, and the direction that is up, by name."""


OBLIQUE = "Oblique"
"""The preset from which a model is seen first."""

_VIEW_ANGLE = 30.0
_DEEP = 1.5


class CameraPose(NamedTuple):
    """Where a camera stands: position, focal point and up, three coordinates each."""

    position: tuple[float, float, float]
    focal_point: tuple[float, float, float]
    view_up: tuple[float, float, float]

    @classmethod
    def of(cls, camera: vtkCamera) -> "CameraPose":
        """Read a camera's pose."""
        return cls(camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp())

    def apply(self, camera: vtkCamera) -> None:
        """Put a camera into this pose."""
        camera.SetPosition(self.position)
        camera.SetFocalPoint(self.focal_point)
        camera.SetViewUp(self.view_up)


def preset_directions(
    name: str, points: NDArray[np.floating[Any]]
) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Direction from a model to the camera, and the direction that is up.

    The oblique one looks across the longer side: a model that is much deeper than it is wide
    would be seen from one of its ends. Which end is its front, and whether Y is up in the file,
    no geometry tells.
    """
    direction, up = PRESETS[name]
    wide, _, deep = np.ptp(points, axis=0)
    return (direction[::-1] if name == OBLIQUE and deep > _DEEP * wide else direction), up


def preset_pose(
    name: str, points: NDArray[np.floating[Any]], radius: float, aspect: float = 1.0
) -> CameraPose:
    """Pose that shows points in a ball of `radius` about the origin from a preset direction.

    `aspect` is width over height of the narrowest view; a narrow one needs more distance.
    """
    direction, up = preset_directions(name, points)
    unit = np.array(direction) / np.linalg.norm(direction)
    return CameraPose(tuple(unit * distance_to(radius, aspect)), (0.0, 0.0, 0.0), up)


def distance_to(radius: float, aspect: float = 1.0) -> float:
    """Distance from which a ball of `radius` fills a view of this width over height."""
    half_angle = np.radians(_VIEW_ANGLE / 2)
    if aspect < 1:
        half_angle = np.arctan(aspect * np.tan(half_angle))
    return float(0.98 * radius / np.sin(half_angle))


def pan_and_dolly(camera: vtkCamera, target: FloatArray, factor: float) -> None:
    """Move the camera sideways to look at `target`, then closer by `factor`."""
    focal, position = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
    shift = target - focal
    camera.SetFocalPoint(*target)
    camera.SetPosition(*(position + shift))
    camera.Dolly(factor)


def point_on_focal_plane(camera: vtkCamera, x: float, y: float, aspect: float) -> FloatArray:
    """Point of the focal plane seen at (x, y), both −1 to 1 from the lower left corner."""
    focal, position = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
    up = np.array(camera.GetViewUp())
    forward = focal - position
    distance = np.linalg.norm(forward)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    true_up = np.cross(right, forward / distance)
    half = distance * np.tan(np.radians(camera.GetViewAngle() / 2))
    x += camera.GetWindowCenter()[0]
    result: FloatArray = focal + half * (x * aspect * right + y * true_up)
    return result
