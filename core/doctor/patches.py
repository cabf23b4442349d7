"""The best way to cut a closed loop into triangles, as a compiled loop."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.doctor.degenerate import FLAT
from core.doctor.spec import Numbers
from core.kernels import kernel
from core.mesh.triangles import triangle_vector

# Weight of an edge's squared length beside twice the area: it only decides between equal areas.
_EDGE = 1e-3


@kernel
def _doubled_area(points: FloatArray, i: int, j: int, k: int) -> float:
    """Twice the area of a triangle, infinite where it has next to none."""
    x, y, z = triangle_vector(points, i, j, k)
    doubled = np.sqrt(x * x + y * y + z * z)
    longest = 0.0
    for a, b in ((i, j), (j, k), (k, i)):
        longest = max(longest, np.sum((points[a] - points[b]) ** 2))
    return doubled if doubled > FLAT * longest else np.inf


@kernel
def _is_edge(starts: IntArray, items: IntArray, a: int, b: int) -> bool:
    row = items[starts[a] : starts[a + 1]]
    place = np.searchsorted(row, b)
    return bool(place < len(row) and row[place] == b)


@kernel
def _chords(points: FloatArray, loop: IntArray, starts: IntArray, items: IntArray) -> FloatArray:
    """Cost of each chord: its squared length, infinite where it is an edge of the mesh already."""
    n = len(loop)
    cost = np.zeros((n, n))
    for i in range(n):
        for j in range(i + 2, n):
            if i == 0 and j == n - 1:
                continue
            cost[i, j] = _EDGE * np.sum((points[j] - points[i]) ** 2)
            if _is_edge(starts, items, loop[i], loop[j]):
                cost[i, j] = np.inf
    return cost


@kernel
def patches_of(
    vertices: FloatArray,
    starts: IntArray,
    loops: IntArray,
    ring_starts: IntArray,
    ring_items: IntArray,
) -> tuple[IntArray, FloatArray]:
    """Best patch of each loop and its area, infinite where there is none.

    Loop i is ``loops[starts[i]:starts[i + 1]]`` and has two faces less than vertices, (k, 3), by
    places in the loop.
    """
    count = len(starts) - 1
    faces = np.zeros((starts[count] - starts[0] - 2 * count, 3), np.int32)
    areas = np.empty(count)
    filled = 0
    for i in range(count):
        loop = loops[starts[i] : starts[i + 1]]
        found, areas[i] = patch(vertices[loop], loop, ring_starts, ring_items)
        faces[filled : filled + len(found)] = found
        filled += len(loop) - 2
    return faces, areas


@kernel
def patch(
    points: FloatArray, loop: IntArray, starts: IntArray, items: IntArray
) -> tuple[IntArray, float]:
    """Triangles between the points of a loop, and their area; none where it cannot be done.

    The cost of a stretch i … j is the least over k between of the two stretches i … k and k … j
    with the triangle ijk. `loop` has the points' numbers in the mesh, `starts` and `items` the
    rings of the mesh: a chord may not be an edge that is there already.
    """
    n = len(loop)
    chords = _chords(points, loop, starts, items)
    cost, middle = np.zeros((n, n)), np.zeros((n, n), np.int64)
    for width in range(2, n):
        for i in range(n - width):
            j = i + width
            best = np.inf
            for k in range(i + 1, j):
                value = cost[i, k] + cost[k, j] + _doubled_area(points, i, k, j)
                if value < best:
                    best = value
                    middle[i, j] = k
            cost[i, j] = best + chords[i, j]
    faces = np.zeros((n - 2, 3), np.int32)
    if not np.isfinite(cost[0, n - 1]):
        return faces[:0], np.inf
    return faces, _collect(points, middle, faces)


@kernel
def _collect(points: FloatArray, middle: Numbers, faces: IntArray) -> float:
    """Write the chosen triangles into `faces` and return their area."""
    n = len(middle)
    stack = [(0, n - 1)]
    count, doubled = 0, 0.0
    while len(stack) > 0:
        i, j = stack.pop()
        if j - i < 2:
            continue
        k = int(middle[i, j])
        faces[count, 0], faces[count, 1], faces[count, 2] = i, k, j
        doubled += _doubled_area(points, i, k, j)
        count += 1
        stack.append((i, k))
        stack.append((k, j))
    return doubled / 2
