"""Small pictures of meshes made of points, without any graphics: on any thread, in moments.

Random points of the surface are projected; in each pixel those near the eye are averaged. With
some ten points a pixel the surface is closed and without grain.
"""

import numpy as np
from numpy.typing import NDArray

from app.export.pictures import Picture
from app.scene.camera import OBLIQUE, preset_directions
from app.scene.colours import LIGHT
from core.arrays import FloatArray
from core.mesh import TriangleMesh
from core.mesh.geometry import shading_normals

_POINTS_PER_PIXEL = 8
# Depth in pixels that belongs to one sheet of the surface.
_SHEET = 5.0
# Points, as a share of the middling pixel's, that cover a pixel.
_COVERING = 0.15
_MARGIN = 0.06
_AMBIENT = 0.25


def sketch_picture(mesh: TriangleMesh, size: tuple[int, int]) -> Picture:
    """Draw a mesh from an oblique direction, without perspective.

    Parameters
    ----------
    mesh : TriangleMesh
        What is drawn, as large as fits.
    size : (int, int)
        Width and height in pixels.

    Returns
    -------
    (height, width, 4) uint8 ndarray
        RGBA with straight alpha; transparent where nothing is.
    """
    wide, high = size
    points, light = _seen_points(mesh, _POINTS_PER_PIXEL * wide * high)
    if not len(points):
        return np.zeros((high, wide, 4), np.uint8)
    pixel, depth = _pixels(points, wide, high)
    order = np.argsort(depth)
    nearest = np.full(wide * high, -np.inf)
    nearest[pixel[order]] = depth[order]
    seen = depth > nearest[pixel] - _SHEET
    counts = np.bincount(pixel[seen], minlength=wide * high)
    sums = np.bincount(pixel[seen], light[seen], minlength=wide * high)
    usual = float(np.median(counts[counts > 0])) if counts.any() else 1.0
    alpha = np.clip(counts / (_COVERING * usual), 0, 1)
    return _coloured(sums / np.maximum(counts, 1), alpha).reshape(high, wide, 4)


def _seen_points(mesh: TriangleMesh, count: int) -> tuple[FloatArray, FloatArray]:
    """Random points of a surface along the axes of the picture, and how bright each is."""
    random = np.random.default_rng(0)
    if not len(mesh.faces):
        return np.zeros((0, 3)), np.zeros(0)
    corners = mesh.vertices[mesh.faces]
    doubled = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    bounds = np.cumsum(doubled)
    if not bounds[-1] > 0:
        return np.zeros((0, 3)), np.zeros(0)
    places = (np.arange(count) + random.random(count)) * (bounds[-1] / count)
    face = np.minimum(np.searchsorted(bounds, places), len(bounds) - 1)
    root, other = np.sqrt(random.random(count)), random.random(count)
    shares = np.stack([1 - root, root * (1 - other), root * other], axis=1)[:, :, None]
    axes = _axes(mesh)
    normals = shading_normals(mesh.vertices, mesh.faces)
    points = (shares * corners[face]).sum(axis=1) @ axes.T
    normal = (shares * normals[mesh.faces[face]]).sum(axis=1)
    facing = np.abs(normal @ axes[2]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    return points, _AMBIENT + (1 - _AMBIENT) * facing


def _axes(mesh: TriangleMesh) -> FloatArray:
    """Directions to the right, up, and towards the eye, as rows."""
    directions = preset_directions(OBLIQUE, mesh.vertices)
    towards, up = (np.array(each, np.float64) for each in directions)
    towards /= np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])


def _pixels(points: FloatArray, wide: int, high: int) -> tuple[NDArray[np.intp], FloatArray]:
    """Pixel of each point in a picture that all of them fill, and its depth in pixels."""
    low, top = points.min(axis=0), points.max(axis=0)
    room = np.array([wide, high]) * (1 - 2 * _MARGIN)
    scale = float((room / np.maximum(top - low, 1e-300)[:2]).min())
    centred = (points - (low + top) / 2) * scale
    column = np.clip((wide / 2 + centred[:, 0]).astype(np.intp), 0, wide - 1)
    row = np.clip((high / 2 - centred[:, 1]).astype(np.intp), 0, high - 1)
    return row * wide + column, centred[:, 2]


def _coloured(light: FloatArray, alpha: FloatArray) -> Picture:
    colour = np.array([int(LIGHT.surface[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    rgba = np.column_stack([light[:, None] * colour, alpha])
    picture: Picture = np.round(255 * np.clip(rgba, 0, 1)).astype(np.uint8)
    return picture
