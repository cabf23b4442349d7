"""Level curves as connected polylines, for drawing."""

from dataclasses import dataclass

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray, frozen
from core.fields import ScalarField
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.skeleton.build import check_field
from core.skeleton.levels import vertex_bands


@dataclass(frozen=True, eq=False)
class LevelCurves:
    """Level curves; all arrays are read-only.

    Attributes
    ----------
    points : (p, 3) float64 ndarray
        Points of all curves in order, in model units. A closed curve repeats its first point.
    starts : (c + 1,) int32 ndarray
        Curve i runs through ``points[starts[i]:starts[i + 1]]``.
    levels : (c,) int32 ndarray
        Number of the level of each curve, counted from 0.
    """

    points: FloatArray
    starts: IntArray
    levels: IntArray

    @property
    def is_closed(self) -> BoolArray:
        """Whether each curve ends where it begins, (c,)."""
        ends = self.points[self.starts[1:] - 1]
        closed: BoolArray = np.all(self.points[self.starts[:-1]] == ends, axis=1)
        return closed


def level_curves(mesh: TriangleMesh, field: ScalarField, levels: FloatArray) -> LevelCurves:
    """Trace the curves on which the field has the given values.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh with faces.
    field : ScalarField
        A normalised field.
    levels : (R − 1,) float64 ndarray
        Ascending levels.

    Returns
    -------
    LevelCurves
        One polyline for each closed curve, and for each stretch between boundary or
        non-manifold edges. A level that runs through a vertex passes just below it.

    Raises
    ------
    MeshError
        If the mesh has no faces or the field belongs to another mesh.
    """
    check_field(mesh, field)
    bands = vertex_bands(field.values, levels)
    starts = level_crossings(bands, mesh.edges)
    points, point_levels = crossing_points(
        mesh.vertices, mesh.edges, field.values, bands, levels, starts
    )
    segments = face_segments(bands, mesh.faces, mesh.topology.face_edges, mesh.edges, starts)
    order, rows = chain_segments(segments, len(points))
    curves = (points[order], rows, point_levels[order[rows[:-1]]])
    for array in curves:
        frozen(array)
    return LevelCurves(*curves)


@kernel
def level_crossings(bands: IntArray, edges: IntArray) -> IntArray:
    """First crossing of each edge: an edge has one with each level between its ends, (e + 1,)."""
    starts = np.zeros(len(edges) + 1, np.int32)
    for e in range(len(edges)):
        starts[e + 1] = starts[e] + abs(bands[edges[e, 0]] - bands[edges[e, 1]])
    return starts


@kernel
def crossing_points(
    vertices: FloatArray,
    edges: IntArray,
    values: FloatArray,
    bands: IntArray,
    levels: FloatArray,
    starts: IntArray,
) -> tuple[FloatArray, IntArray]:
    """Position and level of each crossing, (x, 3) and (x,), along each edge upwards."""
    points = np.zeros((starts[-1], 3))
    point_levels = np.zeros(starts[-1], np.int32)
    for e in range(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        if bands[i] > bands[j]:
            i, j = j, i
        for slot in range(starts[e], starts[e + 1]):
            level = bands[i] + slot - starts[e]
            share = (levels[level] - values[i]) / (values[j] - values[i])
            point_levels[slot] = level
            for x in range(3):
                points[slot, x] = vertices[i, x] + share * (vertices[j, x] - vertices[i, x])
    return points, point_levels


@kernel
def face_segments(
    bands: IntArray, faces: IntArray, face_edges: IntArray, edges: IntArray, starts: IntArray
) -> IntArray:
    """Pairs of crossings that a face joins, one for each level through it, (s, 2)."""
    total = 0
    for t in range(len(faces)):
        a, b, c = bands[faces[t, 0]], bands[faces[t, 1]], bands[faces[t, 2]]
        total += max(a, b, c) - min(a, b, c)
    segments = np.zeros((total, 2), np.int32)
    filled = 0
    for t in range(len(faces)):
        a, b, c = bands[faces[t, 0]], bands[faces[t, 1]], bands[faces[t, 2]]
        for level in range(min(a, b, c), max(a, b, c)):
            side = 0
            for e in face_edges[t]:
                low, high = bands[edges[e, 0]], bands[edges[e, 1]]
                if min(low, high) <= level < max(low, high):
                    segments[filled, side] = starts[e] + level - min(low, high)
                    side += 1
            filled += 1
    return segments


@kernel
def _rows(segments: IntArray, count: int) -> tuple[IntArray, IntArray]:
    """Segments at each crossing, as CSR starts and items."""
    starts = np.zeros(count + 1, np.int32)
    for s in range(len(segments)):
        starts[segments[s, 0] + 1] += 1
        starts[segments[s, 1] + 1] += 1
    for x in range(count):
        starts[x + 1] += starts[x]
    items = np.zeros(2 * len(segments), np.int32)
    free = starts[:-1].copy()
    for s in range(len(segments)):
        for side in range(2):
            x = segments[s, side]
            items[free[x]] = s
            free[x] += 1
    return starts, items


@kernel
def chain_segments(segments: IntArray, count: int) -> tuple[IntArray, IntArray]:
    """Join segments end to end into chains: their crossings in order, and where chains start.

    First the chains that start where not exactly two segments meet, then the closed ones.
    """
    starts, items = _rows(segments, count)
    used = np.zeros(len(segments), np.bool_)
    order = np.zeros(2 * len(segments), np.int32)
    rows = np.zeros(len(segments) + 1, np.int32)
    filled = chains = 0
    for round_ in range(2):
        for x in range(count):
            if round_ == 0 and starts[x + 1] - starts[x] == 2:
                continue
            for slot in range(starts[x], starts[x + 1]):
                if used[items[slot]]:
                    continue
                filled = _follow(segments, starts, items, used, order, filled, x, items[slot])
                chains += 1
                rows[chains] = filled
    return order[:filled], rows[: chains + 1]


@kernel
def _follow(
    segments: IntArray,
    starts: IntArray,
    items: IntArray,
    used: BoolArray,
    order: IntArray,
    filled: int,
    x: int,
    segment: int,
) -> int:
    """Write the chain that leaves crossing x along a segment; return the new end of `order`."""
    order[filled] = x
    filled += 1
    while segment >= 0:
        used[segment] = True
        x = segments[segment, 0] + segments[segment, 1] - x
        order[filled] = x
        filled += 1
        segment = -1
        if starts[x + 1] - starts[x] == 2:
            for slot in range(starts[x], starts[x + 1]):
                if not used[items[slot]]:
                    segment = items[slot]
    return filled
