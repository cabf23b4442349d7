"""Triangulate curved panels between given border points, so that neighbours fit together.

A panel lies on a plane, a cylinder or a cone: all can be unrolled into the plane without
stretching. There the panel is filled with points that keep their distance, and triangulated.
The border points stay where they are, which keeps sharp edges sharp.
"""

from typing import NamedTuple, Protocol

import numpy as np
import trimesh
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import Delaunay, cKDTree

from resources.models.surface import Faces, Mesh

Array = NDArray[np.float64]
Panel = tuple[Array, Faces]


class Sheet(Protocol):
    """A surface that can be unrolled."""

    def unroll(self, points: Array) -> Array:
        """Take points (k, 3) on the surface to the plane, (k, 2), keeping lengths."""

    def roll(self, flat: Array) -> Array:
        """Take points (k, 2) back to the surface, (k, 3)."""


class Plane(NamedTuple):
    """The plane through `origin` spanned by two perpendicular unit vectors."""

    origin: ArrayLike
    first: ArrayLike
    second: ArrayLike

    def unroll(self, points: Array) -> Array:
        """See `Sheet`."""
        return (points - np.asarray(self.origin)) @ np.array([self.first, self.second], float).T

    def roll(self, flat: Array) -> Array:
        """See `Sheet`."""
        return np.asarray(self.origin) + flat @ np.array([self.first, self.second], float)


class Frame(NamedTuple):
    """Cylindrical coordinates: angles about `axis` are counted from the direction `zero`."""

    origin: ArrayLike
    axis: ArrayLike
    zero: ArrayLike

    def matrix(self) -> Array:
        """Unit vectors of the frame as rows: angle zero, a right angle, the axis."""
        return np.array([self.zero, np.cross(self.axis, self.zero), self.axis], float)

    def at(self, angle: ArrayLike, radius: ArrayLike, height: ArrayLike) -> Array:
        """Points with the given coordinates, (k, 3)."""
        local = np.broadcast_arrays(radius * np.cos(angle), radius * np.sin(angle), height)
        return np.asarray(self.origin) + np.stack(local, axis=-1) @ self.matrix()

    def coordinates(self, points: Array) -> tuple[Array, Array, Array]:
        """Angle between −π and π, radius and height of the points."""
        x, y, z = ((points - np.asarray(self.origin)) @ self.matrix().T).T
        return np.arctan2(y, x), np.hypot(x, y), z


class Cylinder(NamedTuple):
    """A cylinder, unrolled about angle zero of its frame."""

    frame: Frame
    radius: float

    def unroll(self, points: Array) -> Array:
        """See `Sheet`."""
        angle, _, height = self.frame.coordinates(points)
        return np.stack([self.radius * angle, height], axis=1)

    def roll(self, flat: Array) -> Array:
        """See `Sheet`."""
        return self.frame.at(flat[:, 0] / self.radius, self.radius, flat[:, 1])


class Cone(NamedTuple):
    """The cone through two circles (radius, height) of its frame, unrolled about angle zero."""

    frame: Frame
    low: tuple[float, float]
    high: tuple[float, float]

    def _shrink(self) -> float:
        """Radius for a length of one along the slant; also the ratio of the angles."""
        (radius, height), (other, end) = self.low, self.high
        return abs(other - radius) / float(np.hypot(other - radius, end - height))

    def unroll(self, points: Array) -> Array:
        """See `Sheet`."""
        angle, radius, _ = self.frame.coordinates(points)
        slant, turn = radius / self._shrink(), angle * self._shrink()
        return np.stack([slant * np.cos(turn), slant * np.sin(turn)], axis=1)

    def roll(self, flat: Array) -> Array:
        """See `Sheet`."""
        radius = np.hypot(*flat.T) * self._shrink()
        angle = np.arctan2(flat[:, 1], flat[:, 0]) / self._shrink()
        (start, height), (end, top) = self.low, self.high
        return self.frame.at(
            angle, radius, height + (radius - start) / (end - start) * (top - height)
        )


def line(start: ArrayLike, end: ArrayLike, spacing: float) -> Array:
    """Points along a straight line, both ends included, about `spacing` apart."""
    first, last = np.asarray(start, float), np.asarray(end, float)
    count = max(round(float(np.linalg.norm(last - first)) / spacing), 1)
    return first + np.linspace(0, 1, count + 1)[:, None] * (last - first)


def arc(
    frame: Frame, angles: tuple[float, float], radius: float, height: float, spacing: float
) -> Array:
    """Points along a circular arc, both ends included, about `spacing` apart."""
    count = max(round(abs(angles[1] - angles[0]) * radius / spacing), 2)
    return frame.at(np.linspace(*angles, count + 1), radius, height)


def loop(*pieces: Array) -> Array:
    """Join curves that end where the next one starts into a closed border."""
    return np.concatenate([piece[:-1] for piece in pieces])


def panel(sheet: Sheet, *borders: Array, spacing: float) -> Panel:
    """Triangulate the part of a surface inside the first border and outside the others."""
    points, faces = fill([sheet.unroll(border) for border in borders], spacing)
    edge = np.concatenate(borders)
    return np.concatenate([edge, sheet.roll(points[len(edge) :])]), faces


def flat_panel(*borders: Array, spacing: float) -> Panel:
    """Triangulate a panel whose borders lie in a plane."""
    origin, corners = borders[0][0], borders[0] - borders[0][0]
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    first = corners[1] / np.linalg.norm(corners[1])
    second = np.cross(normal / np.linalg.norm(normal), first)
    return panel(Plane(origin, first, second), *borders, spacing=spacing)


def fill(borders: list[Array], spacing: float, rounds: int = 30) -> Panel:
    """Triangulate a flat region; return its points, those of the borders first, and the faces.

    Every round moves each inner point to the middle of its neighbours.
    """
    edge = np.concatenate(borders)
    points = np.concatenate([edge, _lattice(borders, spacing)])
    for _ in range(rounds):
        # Inside, every edge has two faces, which run along it in opposite directions.
        faces = _triangulate(points, borders, spacing)
        start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
        sums = [np.bincount(start, points[end, x], len(points)) for x in range(2)]
        middles = np.stack(sums, axis=1) / np.bincount(start, minlength=len(points))[:, None]
        points = np.concatenate([edge, middles[len(edge) :]])
    return points, _triangulate(points, borders, spacing)


def _lattice(borders: list[Array], spacing: float) -> Array:
    """Points of a triangular lattice inside the borders, not too near to them."""
    low, high = borders[0].min(axis=0), borders[0].max(axis=0)
    columns, rows = np.ceil((high - low) / spacing / [1, np.sqrt(0.75)]).astype(int) + 1
    y, x = np.mgrid[0:rows, 0:columns]
    lattice = np.stack([x + 0.5 * (y % 2), np.sqrt(0.75) * (y + 0.5)], axis=-1).reshape(-1, 2)
    points = low + spacing * lattice
    clear = cKDTree(np.concatenate(borders)).query(points)[0] > 0.65 * spacing
    return points[clear & _inside(points, borders)]


def _triangulate(points: Array, borders: list[Array], spacing: float) -> NDArray[np.int64]:
    """Delaunay triangles inside the borders, counterclockwise."""
    faces = Delaunay(points).simplices.astype(np.int64)
    a, b, c = points[faces].transpose(1, 0, 2)
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    doubled = ux * vy - uy * vx
    faces[doubled < 0] = faces[doubled < 0, ::-1]
    solid = np.abs(doubled) > 1e-6 * spacing**2
    return faces[solid & _inside((a + b + c) / 3, borders)]


def _inside(points: Array, borders: list[Array]) -> NDArray[np.bool_]:
    """Whether a ray from each point to the right crosses the borders an odd number of times."""
    starts = np.concatenate(borders)
    ends = np.concatenate([np.roll(border, -1, axis=0) for border in borders])
    x, y = points.T[:, :, None]
    straddles = (starts[:, 1] > y) != (ends[:, 1] > y)
    rise = np.where(straddles, ends[:, 1] - starts[:, 1], 1.0)
    crossing = starts[:, 0] + (y - starts[:, 1]) / rise * (ends[:, 0] - starts[:, 0])
    return np.sum(straddles & (crossing > x), axis=1) % 2 == 1


def mirror(panels: list[Panel], *axes: int) -> list[Panel]:
    """The panels and their mirror images in the planes across the given axes."""
    for axis in axes:
        flip = np.where(np.arange(3) == axis, -1.0, 1.0)
        panels = panels + [(points * flip, faces) for points, faces in panels]
    return panels


def weld(panels: list[Panel]) -> Mesh:
    """Join panels along their common border points; all faces wound outwards."""
    points = np.concatenate([points for points, _ in panels])
    firsts = np.cumsum([0] + [len(points) for points, _ in panels])
    faces = np.concatenate(
        [faces + first for (_, faces), first in zip(panels, firsts, strict=False)]
    )
    _, kept, numbers = np.unique(
        np.round(points / 1e-7).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    solid = trimesh.Trimesh(points[kept], numbers.ravel()[faces], process=False)
    solid.fix_normals()
    return Mesh(np.asarray(solid.vertices), np.asarray(solid.faces, np.int64))
