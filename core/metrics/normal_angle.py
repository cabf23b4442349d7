"""Mean angle between the face normals of two meshes, in degrees."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel, parallel_kernel, prange, unsigned
from core.lanes import Lanes, Point, row, set_row, totals, xyz
from core.mesh import TriangleMesh
from core.metrics.arctangent import angle_of
from core.metrics.spec import Evaluator, MetricSpec

# So many faces side by side stay in the second cache; fewer, and their arrays cost too much.
_BLOCK = 1024


@kernel
def _face_vector(positions: FloatArray, faces: IntArray, t: int) -> Point:
    """Twice the area times the unit normal of face t."""
    i, j, k = faces[t]
    (x, y, z), (ax, ay, az), (bx, by, bz) = (
        xyz(positions, i),
        xyz(positions, j),
        xyz(positions, k),
    )
    ax, ay, az, bx, by, bz = ax - x, ay - y, az - z, bx - x, by - y, bz - z
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


@kernel
def _face_vectors(vertices: FloatArray, faces: IntArray) -> FloatArray:
    """Twice the area times the unit normal of each face of one mesh, (n, 3)."""
    vectors = np.empty((len(faces), 3))
    for t in range(np.uint64(len(faces))):
        vectors[t, 0], vectors[t, 1], vectors[t, 2] = _face_vector(vertices, faces, t)
    return vectors


@kernel
def _set_products(
    positions: FloatArray,
    faces: IntArray,
    vectors: FloatArray,
    squares: FloatArray,
    products: FloatArray,
) -> None:
    """Note ‖n × n̂‖² and ⟨n, n̂⟩ of each face, n̂ from the vectors."""
    for t in range(np.uint64(len(faces))):
        (x, y, z), (a, b, c) = _face_vector(positions, faces, t), xyz(vectors, t)
        sx, sy, sz = y * c - z * b, z * a - x * c, x * b - y * a
        set_row(squares, t, sx * sx + sy * sy + sz * sz)
        set_row(products, t, x * a + y * b + z * c)


@kernel
def _set_angles(squares: FloatArray, products: FloatArray, angles: FloatArray) -> None:
    """Note the angle of each sine² and cosine; three flat arrays compile to vector instructions."""
    for k in range(len(angles)):
        angles[k] = angle_of(np.sqrt(squares[k]), products[k])


@kernel
def _sum(rows: FloatArray) -> Lanes:
    """Σ of 4k rows; four sums, because each has to wait for itself."""
    a = b = c = d = 0.0
    for k in range(0, len(rows), 4):
        a = a + row(rows, k)
        b = b + row(rows, k + 1)
        c = c + row(rows, k + 2)
        d = d + row(rows, k + 3)
    return (a + b) + (c + d)


@kernel
def _block_angles(positions: FloatArray, faces: IntArray, vectors: FloatArray) -> Lanes:
    """Σᵢ ∠(n(tᵢ), n(t̂ᵢ)) of at most a block of faces, in radians."""
    shape, n = (_BLOCK, *positions.shape[2:]), len(faces)
    squares, products, angles = np.zeros(shape), np.zeros(shape), np.empty(shape)
    _set_products(positions, faces, vectors, squares[:n], products[:n])
    _set_angles(squares.reshape(-1), products.reshape(-1), angles.reshape(-1))
    return _sum(angles)


@parallel_kernel
def _angles(positions: FloatArray, faces: IntArray, vectors: FloatArray) -> FloatArray:
    """Σᵢ ∠(n(tᵢ), n(t̂ᵢ)) over each block of faces, in radians."""
    n = len(faces)
    blocks = (n + _BLOCK - 1) // _BLOCK
    angles = np.empty((blocks, *positions.shape[2:]))
    for block in prange(blocks):
        first, last = block * _BLOCK, min((block + 1) * _BLOCK, n)
        set_row(angles, block, _block_angles(positions, faces[first:last], vectors[first:last]))
    return angles


class NormalAngleEvaluator(Evaluator):
    """Mean of ∠(n(tᵢ), n(t̂ᵢ)) over all faces, against one original."""

    def __init__(self, original: TriangleMesh) -> None:
        (self._faces,) = unsigned(original.faces)
        self._vectors = _face_vectors(original.vertices, self._faces)

    def values(self, positions: FloatArray) -> FloatArray:
        """Return the mean of `elements` of each mesh."""
        angles = _angles(positions, self._faces, self._vectors)
        return np.degrees(totals(angles) / max(len(self._faces), 1))

    def elements(self, vertices: FloatArray) -> FloatArray:
        """Return the angle of each face in degrees, (n,); 0 for a face without area."""
        squares, products, angles = np.empty((3, len(self._faces)))
        vertices = np.ascontiguousarray(vertices)
        _set_products(vertices, self._faces, self._vectors, squares, products)
        _set_angles(squares, products, angles)
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
