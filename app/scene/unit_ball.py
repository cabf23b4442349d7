"""Models of any size moved and scaled into the unit ball, so that one camera serves any two."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.scene.camera import CameraPose
from core.arrays import FloatArray
from core.mesh import TriangleMesh


@dataclass(frozen=True)
class UnitFrame:
    """How a model was moved and scaled into the unit ball, so that one camera serves any two.

    Attributes
    ----------
    middle : (float, float, float)
        Middle of its box, seen from its centroid, in model units.
    radius : float
        Largest distance of a vertex from the middle, in model units.
    """

    middle: tuple[float, float, float] = (0.0, 0.0, 0.0)
    radius: float = 1.0

    def to_model(self, pose: CameraPose) -> CameraPose:
        """Turn a pose beside the unit ball into one beside the model."""
        return self._moved(pose, lambda place: self.radius * place + self.middle)

    def to_unit(self, pose: CameraPose) -> CameraPose:
        """Turn a pose beside the model into one beside the unit ball."""
        return self._moved(pose, lambda place: (place - self.middle) / self.radius)

    @staticmethod
    def _moved(pose: CameraPose, move: Callable[[FloatArray], FloatArray]) -> CameraPose:
        position, focal = (move(np.array(place)).tolist() for place in pose[:2])
        return CameraPose(tuple(position), tuple(focal), pose.view_up)


def unit_points(mesh: TriangleMesh) -> tuple[NDArray[np.float32], UnitFrame]:
    """Vertices moved and scaled into the unit ball, and how."""
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    centred = mesh.vertices - (low + high) / 2
    radius = float(np.linalg.norm(centred, axis=1).max(initial=0)) or 1.0
    points: NDArray[np.float32] = (centred / radius).astype(np.float32)
    middle = (low + high) / 2 - mesh.vertices.mean(axis=0)
    return points, UnitFrame(tuple(middle.tolist()), radius)
