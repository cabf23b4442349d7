"""Slices: the part of one face between two levels, its area and its centroid.

Corners are taken in ascending order of the field, v₀ v₁ v₂. Points of the face are written as
v₀ + u(v₁ − v₀) + w(v₂ − v₀); in these coordinates the face has the area ½.
"""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.kernels import kernel
from core.mesh.triangles import triangle_vector


@kernel
def ascending_corners(values: FloatArray, faces: IntArray, t: int) -> tuple[int, int, int]:
    """Vertices of face t in ascending order of the field."""
    i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
    if values[i] > values[j]:
        i, j = j, i
    if values[j] > values[k]:
        j, k = k, j
    if values[i] > values[j]:
        i, j = j, i
    return i, j, k


@kernel
def _on_short_edges(low: float, middle: float, high: float, level: float) -> tuple[float, float]:
    if level <= middle:
        return (level - low) / (middle - low), 0.0
    share = (level - middle) / (high - middle)
    return 1.0 - share, share


@kernel
def slice_polygon(
    corners: FloatArray, bands: IntArray, band: int, levels: FloatArray, polygon: FloatArray
) -> int:
    """Write the polygon of a face between two levels into `polygon`; return its corner count.

    `corners` and `bands` are the ascending values at the face's corners and their bands.
    """
    low, middle, high = corners[0], corners[1], corners[2]
    if band == bands[0]:
        polygon[0, 0], polygon[0, 1] = 0.0, 0.0
        count = 1
    else:
        level = levels[band - 1]
        polygon[0, 0], polygon[0, 1] = 0.0, (level - low) / (high - low)
        polygon[1, 0], polygon[1, 1] = _on_short_edges(low, middle, high, level)
        count = 2
    if band == bands[1]:
        polygon[count, 0], polygon[count, 1] = 1.0, 0.0
        count += 1
    if band == bands[2]:
        polygon[count, 0], polygon[count, 1] = 0.0, 1.0
        return count + 1
    level = levels[band]
    polygon[count, 0], polygon[count, 1] = _on_short_edges(low, middle, high, level)
    polygon[count + 1, 0], polygon[count + 1, 1] = 0.0, (level - low) / (high - low)
    return count + 2


@kernel
def polygon_moments(polygon: FloatArray, count: int) -> tuple[float, float, float]:
    """Twice the area of a convex polygon, and that times its centroid's coordinates."""
    area = u = w = 0.0
    for a in range(1, count - 1):
        ax, ay = polygon[a, 0] - polygon[0, 0], polygon[a, 1] - polygon[0, 1]
        bx, by = polygon[a + 1, 0] - polygon[0, 0], polygon[a + 1, 1] - polygon[0, 1]
        # Rounding may turn a sliver over; its area is nothing then, never negative.
        double = max(ax * by - ay * bx, 0.0)
        area += double
        u += double * (polygon[0, 0] + (ax + bx) / 3)
        w += double * (polygon[0, 1] + (ay + by) / 3)
    return area, u, w


@kernel
def _triangle_area(vertices: FloatArray, i: int, j: int, k: int) -> float:
    x, y, z = triangle_vector(vertices, i, j, k)
    area: float = np.sqrt(x * x + y * y + z * z) / 2
    return area


@kernel
def node_moments(
    vertices: FloatArray,
    faces: IntArray,
    values: FloatArray,
    bands: IntArray,
    levels: FloatArray,
    starts: IntArray,
    nodes: IntArray,
    node_count: int,
) -> FloatArray:
    """Area and area times centroid of each node, (k, 4), summed over the slices of its faces."""
    sums = np.zeros((node_count, 4))
    polygon = np.zeros((5, 2))
    corners, corner_bands = np.zeros(3), np.zeros(3, np.int32)
    for t in range(len(faces)):
        i, j, k = faces[t, 0], faces[t, 1], faces[t, 2]
        area = _triangle_area(vertices, i, j, k)
        if starts[t + 1] - starts[t] == 1:
            node = nodes[starts[t]]
            sums[node, 0] += area
            for x in range(3):
                sums[node, 1 + x] += area * (vertices[i, x] + vertices[j, x] + vertices[k, x]) / 3
            continue
        i, j, k = ascending_corners(values, faces, t)
        corners[0], corners[1], corners[2] = values[i], values[j], values[k]
        corner_bands[0], corner_bands[1], corner_bands[2] = bands[i], bands[j], bands[k]
        for slot in range(starts[t], starts[t + 1]):
            band = bands[i] + slot - starts[t]
            count = slice_polygon(corners, corner_bands, band, levels, polygon)
            share, u, w = polygon_moments(polygon, count)
            node = nodes[slot]
            sums[node, 0] += area * share
            for x in range(3):
                origin = vertices[i, x]
                along = u * (vertices[j, x] - origin) + w * (vertices[k, x] - origin)
                sums[node, 1 + x] += area * (share * origin + along)
    return sums


@kernel
def piece_polygons(
    vertices: FloatArray,
    faces: IntArray,
    values: FloatArray,
    bands: IntArray,
    levels: FloatArray,
    owners: IntArray,
    piece_bands: IntArray,
) -> tuple[FloatArray, IntArray]:
    """Corner points of pieces, (p, 5, 3), and how many of them are used, (p,).

    `owners` and `piece_bands` are the face and the band of each piece.
    """
    points = np.zeros((len(owners), 5, 3))
    counts = np.zeros(len(owners), np.int32)
    polygon = np.zeros((5, 2))
    corners, corner_bands = np.zeros(3), np.zeros(3, np.int32)
    for p in range(len(owners)):
        i, j, k = ascending_corners(values, faces, owners[p])
        corners[0], corners[1], corners[2] = values[i], values[j], values[k]
        corner_bands[0], corner_bands[1], corner_bands[2] = bands[i], bands[j], bands[k]
        counts[p] = slice_polygon(corners, corner_bands, piece_bands[p], levels, polygon)
        for c in range(counts[p]):
            for x in range(3):
                origin = vertices[i, x]
                points[p, c, x] = (
                    origin
                    + polygon[c, 0] * (vertices[j, x] - origin)
                    + polygon[c, 1] * (vertices[k, x] - origin)
                )
    return points, counts
