"""Shapes as functions of space: negative inside, zero on the surface, positive outside.

A field takes points (k, 3) and gives k values that are close to the distance from the surface.
Parts are blended by a smooth minimum, so that they grow out of each other without a crease.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree

Array = NDArray[np.float64]
Field = Callable[[Array], Array]

# Beyond this distance a tube no longer matters: more than the widest blend.
FAR = 0.2


def ellipsoid(center: ArrayLike, radii: ArrayLike) -> Field:
    """Ellipsoid with axes along x, y and z; the value is a first-order distance."""
    middle, radius = np.asarray(center, float), np.asarray(radii, float)

    def field(points: Array) -> Array:
        scaled = (points - middle) / radius
        size = np.linalg.norm(scaled, axis=1)
        slope = np.linalg.norm(scaled / radius, axis=1)
        return size * (size - 1) / np.maximum(slope, 1e-12)

    return field


def ring(center: ArrayLike, radius: float, tube_radius: float) -> Field:
    """Torus about an axis parallel to z."""
    middle = np.asarray(center, float)

    def field(points: Array) -> Array:
        x, y, z = (points - middle).T
        return np.hypot(np.hypot(x, y) - radius, z) - tube_radius

    return field


def half_space(point: ArrayLike, normal: ArrayLike) -> Field:
    """Everything behind the plane through `point` with the outward `normal`."""
    direction = np.asarray(normal, float) / np.linalg.norm(normal)
    offset = float(np.asarray(point, float) @ direction)
    return lambda points: points @ direction - offset


def tube(path: ArrayLike, radii: ArrayLike, *, pointed: bool = False) -> Field:
    """Round tube with round ends along a smooth curve through the points of `path`.

    The radius follows a smooth curve through `radii`, spread evenly over the path. It is level at
    both ends, so that the round ends begin without a crease; a `pointed` tube may go on shrinking
    up to its last end. Far from the tube the value is a constant, which saves most of the time.
    """
    curve = CubicSpline(np.linspace(0, 1, len(path)), path)
    last = (2, 0.0) if pointed else (1, 0.0)
    size = CubicSpline(np.linspace(0, 1, len(radii)), radii, bc_type=((1, 0.0), last))
    samples = np.linspace(0, 1, 65)
    tree, reach = cKDTree(curve(samples)), max(radii) + FAR

    def field(points: Array) -> Array:
        nearest = tree.query(points, distance_upper_bound=reach)[1]
        near = nearest < len(samples)
        along = _closest(curve, points[near], samples[nearest[near]], samples[1])
        values = np.full(len(points), FAR)
        values[near] = np.linalg.norm(points[near] - curve(along), axis=1) - size(along)
        return values

    return field


def _closest(curve: CubicSpline, points: Array, start: Array, reach: float) -> Array:
    """Where on the curve the closest point lies: Newton steps that stay within `reach`."""
    velocity, bend = curve.derivative(1), curve.derivative(2)
    low, high = np.maximum(start - reach, 0), np.minimum(start + reach, 1)
    along = start
    for _ in range(3):
        gaps, slope = points - curve(along), velocity(along)
        speed = _dot(slope, slope)
        stiffness = np.maximum(speed - _dot(gaps, bend(along)), 0.3 * speed)
        along = np.clip(along + _dot(gaps, slope) / stiffness, low, high)
    return along


def _dot(first: Array, second: Array) -> Array:
    return np.einsum("px,px->p", first, second)


def smooth_minimum(first: Array, second: Array, blend: float) -> Array:
    """Minimum of two values, rounded over with two continuous derivatives within `blend`."""
    overlap = np.maximum(blend - np.abs(first - second), 0) / blend
    return np.minimum(first, second) - overlap**3 * blend / 6


def union(blend: float, *parts: Field) -> Field:
    """Join the parts one after the other, each melting into the ones before within `blend`."""

    def field(points: Array) -> Array:
        values = parts[0](points)
        for part in parts[1:]:
            values = smooth_minimum(values, part(points), blend)
        return values

    return field


def cut(blend: float, body: Field, *tools: Field) -> Field:
    """Take the tools away from the body; the edges of the cuts are rounded within `blend`."""

    def field(points: Array) -> Array:
        values = -body(points)
        for tool in tools:
            values = smooth_minimum(values, tool(points), blend)
        return -values

    return field


def raised(body: Field, height: Callable[[Array], Array]) -> Field:
    """Move the surface outwards by `height`, a function of the points."""
    return lambda points: body(points) - height(points)


def mirrored(part: Field) -> Field:
    """Both the part, which lies clear of the plane y = 0, and its mirror image in that plane."""
    flip = np.array([1.0, -1.0, 1.0])
    return lambda points: np.minimum(part(points), part(points * flip))


def stretched(part: Field, factors: ArrayLike) -> Field:
    """Scale a part along x, y and z; unequal factors give values below the distance."""
    scale = np.asarray(factors, float)
    return lambda points: part(points / scale) * scale.min()


def placed(part: Field, rotation: ArrayLike, origin: ArrayLike) -> Field:
    """Turn a part by the matrix `rotation` about its own origin, then move it to `origin`."""
    turn, home = np.asarray(rotation, float), np.asarray(origin, float)
    return lambda points: part((points - home) @ turn)


def bump(center: ArrayLike, radius: float) -> Callable[[Array], Array]:
    """Weight that falls smoothly from 1 at `center` to 0 at `radius`."""
    middle = np.asarray(center, float)

    def weight(points: Array) -> Array:
        share = np.sum((points - middle) ** 2, axis=1) / radius**2
        return np.clip(1 - share, 0, 1) ** 3

    return weight


def project(field: Field, points: Array, steps: int = 3) -> Array:
    """Move points onto the surface by Newton steps along the gradient."""
    for _ in range(steps):
        slope = _gradient(field, points)
        squared = np.maximum(_dot(slope, slope), 0.1)
        points = points - (field(points) / squared)[:, None] * slope
    return points


def _gradient(field: Field, points: Array, step: float = 1e-4) -> Array:
    offsets = step * np.eye(3)
    slopes = [(field(points + offset) - field(points - offset)) / (2 * step) for offset in offsets]
    return np.stack(slopes, axis=1)
