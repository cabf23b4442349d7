"""Mean angle between the face normals of two meshes, in degrees."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import parallel_kernel, prange, unsigned
from core.mesh import TriangleMesh
from core.mesh.geometry import face_vectors
from core.mesh.triangles import triangle_vector
from core.metrics.arctangent import angle_of
from core.metrics.spec import MetricSpec


@parallel_kernel
def _angles(vertices: FloatArray, faces: IntArray, vectors: FloatArray) -> FloatArray:
    """Angle between each face's normal and its vector in degrees; 0 where one has no length."""
    angles = np.empty(len(faces))
    for t in prange(len(faces)):
        ax, ay, az = vectors[t, 0], vectors[t, 1], vectors[t, 2]
        bx, by, bz = triangle_vector(vertices, faces[t, 0], faces[t, 1], faces[t, 2])
        cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        sine = np.sqrt(cx * cx + cy * cy + cz * cz)
        angles[t] = np.degrees(angle_of(sine, ax * bx + ay * by + az * bz))
    return angles


class NormalAngleEvaluator:
    """Mean of ∠(n(tᵢ), n(t̂ᵢ)) over all faces, against one original."""

    def __init__(self, original: TriangleMesh) -> None:
        (self._faces,) = unsigned(original.faces)
        self._vectors: FloatArray = face_vectors(original.vertices, self._faces)

    def value(self, vertices: FloatArray) -> float:
        """Return the mean of `elements`."""
        return float(self.elements(vertices).mean()) if len(self._faces) else 0.0

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the angle of each face in degrees, (n,); 0 for a face without area."""
        angles: FloatArray = _angles(vertices, self._faces, self._vectors)
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
