"""A camera as text: copied from one window, pasted into another, a note or a script."""

import json
from typing import Any

from app.scene.camera import CameraPose
from core.view import NamedCamera, check_camera

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
    except (ValueError, KeyError, TypeError, OverflowError, RecursionError) as error:
        raise CameraTextError(f"This text is no camera; one has {_EXPECTED}, as JSON.") from error
    _check(pose)
    return pose


def named(name: str, pose: CameraPose) -> NamedCamera:
    """Give a pose a name, for a study to keep.

    Raises
    ------
    CameraTextError
        If nothing can be seen from there.
    """
    _check(pose)
    return NamedCamera(name=name, **pose._asdict())


def pose_of(camera: NamedCamera) -> CameraPose:
    """Return the pose of a camera that a study keeps."""
    return CameraPose(camera.position, camera.focal_point, camera.view_up)


def _coordinates(place: Any) -> tuple[float, float, float]:
    x, y, z = (float(number) for number in place)
    return x, y, z


def _check(pose: CameraPose) -> None:
    try:
        check_camera(*pose)
    except ValueError as error:
        raise CameraTextError(str(error)) from error
