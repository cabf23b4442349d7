"""Mean angle between the face normals of two meshes, in degrees."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange
from core.mesh import TriangleMesh
from core.mesh.geometry import face_vectors
from core.metrics.spec import MetricSpec


@parallel_kernel
def _angles(first: FloatArray, second: FloatArray) -> FloatArray:
    """Angle between corresponding rows in degrees; 0 where one of them has no length."""
    angles = np.zeros(len(first))
    for t in prange(len(first)):
        ax, ay, az = first[t, 0], first[t, 1], first[t, 2]
        bx, by, bz = second[t, 0], second[t, 1], second[t, 2]
        cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        # atan2 keeps its precision for nearly equal normals, where acos loses it.
        sine = np.sqrt(cx * cx + cy * cy + cz * cz)
        angles[t] = np.degrees(np.arctan2(sine, ax * bx + ay * by + az * bz))
    return angles


class NormalAngleEvaluator:
    """Mean of ∠(n(tᵢ), n(t̂ᵢ)) over all faces, against one original."""

    def __init__(self, original: TriangleMesh) -> None:
        self._faces: IntArray = original.faces
        self._vectors: FloatArray = face_vectors(original.vertices, original.faces)

    def value(self, vertices: FloatArray) -> float:
        """Return the mean of `elements`."""
        return float(self.elements(vertices).mean()) if len(self._faces) else 0.0

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the angle of each face in degrees, (n,); 0 for a face without area."""
        angles: FloatArray = _angles(self._vectors, face_vectors(vertices, self._faces))
        return angles


SPEC = MetricSpec(
    id="normal_angle",
    title="Normal angle",
    unit="°",
    elements_unit="°",
    elements_on="face",
    evaluator=NormalAngleEvaluator,
    summary="Mean angle between the face normals and those of the original.",
    formula="1/n Σᵢ ∠(n(tᵢ), n(t̂ᵢ))",
    reference="Sun, Rosin, Martin, Langbein, IEEE TVCG 2007, and others",
)
