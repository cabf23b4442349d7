"""A camera that comes as close to a model as the view allows."""

import numpy as np

from app.scene.camera import CameraPose, preset_directions
from core.arrays import FloatArray

_VIEW_ANGLE = 30.0
_MARGIN = 1.15
_HEADROOM = 0.08


def fitting_pose(preset: str, points: FloatArray, aspect: float) -> CameraPose:
    """Pose from a preset direction in which all points fill a view of this aspect.

    A point at height z towards the camera and x beside its axis is seen if the camera stands
    farther than z + x/tan(α), where α is half the view angle.
    """
    direction, up = preset_directions(preset, points)
    forward = -np.array(direction) / np.linalg.norm(direction)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(right, forward), -forward])
    seen = points @ axes.T
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    seen = seen - middle
    slope = np.tan(np.radians(_VIEW_ANGLE / 2))
    across = np.maximum(np.abs(seen[:, 0]) / aspect, np.abs(seen[:, 1])) * _MARGIN / slope
    distance = float((seen[:, 2] + across).max())
    # A little above the middle there is room for the caption.
    middle[1] += _HEADROOM * slope * distance
    focal = middle @ axes
    position = focal - forward * distance
    return CameraPose(tuple(position), tuple(focal), up)
