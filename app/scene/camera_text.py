"""A camera as text: copied from one window, pasted into another, a note or a script."""

import json
from typing import Any

import numpy as np

from app.scene.camera import CameraPose
from core.view import NamedCamera

_EXPECTED = "position, focal_point and view_up with three numbers each"


class CameraTextError(ValueError):
    """Raised when a text is no camera; one sentence says what one looks like."""


def pose_text(pose: CameraPose) -> str:
    """Write a pose as one JSON object; lengths are in model units from the centroid."""
    return json.dumps({name: list(place) for name, place in pose._asdict().items()})


def read_pose(text: str) -> CameraPose:
    """Read a pose from what :func:`pose_text` wrote.

    Raises
    ------
    CameraTextError
        If the text is something else, or nothing can be seen from there.
    """
    try:
        places = json.loads(text)
        pose = CameraPose(*(_coordinates(places[name]) for name in CameraPose._fields))
    except (ValueError, KeyError, TypeError) as error:
        raise CameraTextError(f"This text is no camera; one has {_EXPECTED}, as JSON.") from error
    _check(pose)
    return pose


def named(name: str, pose: CameraPose) -> NamedCamera:
    """Give a pose a name, for a study to keep."""
    return NamedCamera(name=name, **pose._asdict())


def pose_of(camera: NamedCamera) -> CameraPose:
    """Return the pose of a camera that a study keeps."""
    return CameraPose(camera.position, camera.focal_point, camera.view_up)


def _coordinates(place: Any) -> tuple[float, float, float]:
    x, y, z = (float(number) for number in place)
    return x, y, z


def _check(pose: CameraPose) -> None:
    position, focal, up = (np.array(place) for place in pose)
    side = np.cross(focal - position, up)
    if not np.isfinite(side).all() or not np.linalg.norm(side) > 0:
        raise CameraTextError(
            "This camera sees nothing: its position must lie off the point it looks at, "
            "and its view_up must point sideways to that line."
        )
