"""Mean angle between the face normals of two meshes, in degrees."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange, unsigned
from core.lanes import every, numbers, row, turned, xyz
from core.mesh import TriangleMesh
from core.metrics.arctangent import angle_of
from core.metrics.spec import MetricSpec

Rows = tuple[FloatArray, FloatArray, FloatArray]
"""The x, the y and the z of vectors: side by side they compile to vector instructions."""

# So many faces side by side stay in the second cache; fewer, and their arrays cost too much.
_BLOCK = 1024


@kernel
def _set_face_vectors(vertices: FloatArray, faces: IntArray, vectors: Rows) -> None:
    """Note twice the area times the unit normal of each face.

    Its z stands first, then x, then y: that saves turning it and is the same for both meshes, so
    the angle is not changed.
    """
    x, y, z = vectors
    for t in range(np.uint64(len(faces))):
        i, j, k = faces[t]
        corner = xyz(vertices, i)
        a, b = xyz(vertices, j) - corner, xyz(vertices, k) - corner
        x[t], y[t], z[t], _ = numbers(a * turned(b) - turned(a) * b)


@kernel
def _set_angles(a: Rows, b: Rows, angles: FloatArray) -> None:
    """Note the angle ∠(a, b) of each pair, from ‖a × b‖ and ⟨a, b⟩; 0 where one has no length."""
    (ax, ay, az), (bx, by, bz) = a, b
    for t in range(len(angles)):
        x = ay[t] * bz[t] - az[t] * by[t]
        y = az[t] * bx[t] - ax[t] * bz[t]
        z = ax[t] * by[t] - ay[t] * bx[t]
        product = ax[t] * bx[t] + ay[t] * by[t] + az[t] * bz[t]
        angles[t] = angle_of(np.sqrt(x * x + y * y + z * z), product)


@kernel
def _sum(rows: FloatArray) -> float:
    """Σ of all numbers of an (r, 4) array; four sums, because each has to wait for itself."""
    total = every(0.0)
    for i in range(len(rows)):
        total = total + row(rows, i)
    a, b, c, d = numbers(total)
    return a + b + c + d


@parallel_kernel
def _total_angle(vertices: FloatArray, faces: IntArray, vectors: Rows) -> float:
    """Σᵢ of the angles between the faces' normals and the vectors, in radians."""
    x, y, z = vectors
    total = 0.0
    for block in prange((len(faces) + _BLOCK - 1) // _BLOCK):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, len(faces))
        ours = np.empty(_BLOCK), np.empty(_BLOCK), np.empty(_BLOCK)
        angles = np.zeros((_BLOCK // 4, 4))
        _set_face_vectors(vertices, faces[first:last], ours)
        theirs = x[first:last], y[first:last], z[first:last]
        _set_angles(theirs, ours, angles.reshape(-1)[: last - first])
        total += _sum(angles)
    return total


class NormalAngleEvaluator:
    """Mean of ∠(n(tᵢ), n(t̂ᵢ)) over all faces, against one original."""

    def __init__(self, original: TriangleMesh) -> None:
        (self._faces,) = unsigned(original.faces)
        self._vectors = self._face_vectors(original.vertices)

    def _face_vectors(self, vertices: FloatArray) -> Rows:
        n = len(self._faces)
        vectors = np.empty(n), np.empty(n), np.empty(n)
        _set_face_vectors(np.ascontiguousarray(vertices), self._faces, vectors)
        return vectors

    def value(self, vertices: FloatArray) -> float:
        """Return the mean of `elements`."""
        total = _total_angle(np.ascontiguousarray(vertices), self._faces, self._vectors)
        return float(np.degrees(total / max(len(self._faces), 1)))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the angle of each face in degrees, (n,); 0 for a face without area."""
        angles = np.empty(len(self._faces))
        _set_angles(self._vectors, self._face_vectors(vertices), angles)
        return np.degrees(angles)


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
