"""What every reader hands over, and how it becomes a triangle mesh.

Readers only say what the file holds. Here, once for all formats, polygons become fans of
triangles, collapsed faces and unreferenced vertices go, and bad numbers are refused. Vertices keep
the order of the file, so a noisy file and its original match vertex by vertex.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.arrays import BoolArray, FloatArray
from core.io.errors import LoadError
from core.mesh import TriangleMesh

Numbers = NDArray[np.int64]


class Lists(NamedTuple):
    """Lists of different lengths, one after the other.

    Attributes
    ----------
    sizes : (p,) int64 ndarray
        Length of each list.
    items : (s,) ndarray
        All entries, list after list.
    """

    sizes: Numbers
    items: NDArray[Any]

    @classmethod
    def empty(cls) -> "Lists":
        """Return no lists at all."""
        return cls(np.zeros(0, np.int64), np.zeros(0, np.int64))

    @classmethod
    def of_rows(cls, rows: NDArray[Any]) -> "Lists":
        """Return the rows of an (n, k) array as n lists."""
        return cls(np.full(len(rows), rows.shape[1]), rows.ravel())

    @classmethod
    def chain(cls, parts: Sequence["Lists"]) -> "Lists":
        """Return the lists of all parts, one part after the other."""
        if len(parts) == 1:
            return parts[0]
        sizes, items = zip(cls.empty(), *parts, strict=True)
        return cls(np.concatenate(sizes), np.concatenate(items))


@dataclass(frozen=True)
class Polygons:
    """Vertices and polygons as they stand in a file.

    Attributes
    ----------
    vertices : (m, 3) float64 ndarray
        Positions in the file's order.
    faces : Lists
        Vertex numbers of each polygon, counted from 0.
    changes : tuple of str
        What the reader itself had to change, in short phrases.
    first_number : int
        Number of the first vertex in the file's own counting, for messages.
    """

    vertices: FloatArray
    faces: Lists
    changes: tuple[str, ...] = ()
    first_number: int = 0


def counted(number: int, singular: str, plural: str = "") -> str:
    """Return a number with its noun: ``counted(2, "face")`` is "2 faces"."""
    return f"{number:,} {singular if number == 1 else plural or singular + 's'}"


def assemble(polygons: Polygons) -> tuple[TriangleMesh, tuple[str, ...]]:
    """Turn polygons into a checked triangle mesh.

    Parameters
    ----------
    polygons : Polygons
        What a reader found in a file.

    Returns
    -------
    mesh : TriangleMesh
        Fan-triangulated; every vertex belongs to a face.
    report : tuple of str
        One short phrase for each kind of change, in the order they were made.

    Raises
    ------
    LoadError
        If there are no faces, a vertex number is out of range, or a coordinate is not finite.
    """
    _check_numbers(polygons)
    faces = fan_triangles(polygons.faces)
    collapsed = _is_collapsed(faces)
    if collapsed.any():
        faces = faces[~collapsed]
    if not len(faces):
        raise LoadError("none of its faces has three different corners")
    used = np.zeros(len(polygons.vertices), np.bool_)
    used[faces] = True
    _check_positions(polygons, used)
    changes = _changes(polygons.faces.sizes, int(collapsed.sum()), int((~used).sum()))
    if not used.all():
        faces = (np.cumsum(used) - 1)[faces]
    vertices = polygons.vertices if used.all() else polygons.vertices[used]
    return TriangleMesh(vertices, faces), polygons.changes + changes


def _check_numbers(polygons: Polygons) -> None:
    sizes, items = polygons.faces
    if not len(sizes):
        raise LoadError(f"it has no faces, only {counted(len(polygons.vertices), 'point')}")
    if items.size and (items.min() < 0 or items.max() >= len(polygons.vertices)):
        outside = np.flatnonzero((items < 0) | (items >= len(polygons.vertices)))
        face = np.searchsorted(np.cumsum(sizes), outside[0], side="right")
        first = polygons.first_number
        raise LoadError(
            f"face {face + first} names vertex {items[outside[0]] + first}; "
            f"allowed are {first} to {len(polygons.vertices) - 1 + first}"
        )


def _check_positions(polygons: Polygons, used: BoolArray) -> None:
    if np.isfinite(polygons.vertices).all():
        return
    bad = np.flatnonzero(used & ~np.isfinite(polygons.vertices).all(axis=1))
    if len(bad):
        number = bad[0] + polygons.first_number
        position = polygons.vertices[bad[0]].tolist()
        raise LoadError(f"vertex {number} is {position}; coordinates must be finite")


def _changes(sizes: Numbers, collapsed: int, unused: int) -> tuple[str, ...]:
    polygons, slivers = int((sizes > 3).sum()), int((sizes < 3).sum())
    phrases = (
        (polygons, f"{counted(polygons, 'polygon')} triangulated"),
        (slivers, f"{counted(slivers, 'face')} with fewer than three corners dropped"),
        (collapsed, f"{counted(collapsed, 'collapsed face')} dropped"),
        (unused, f"{counted(unused, 'unreferenced vertex', 'unreferenced vertices')} dropped"),
    )
    return tuple(phrase for number, phrase in phrases if number)


def fan_triangles(polygons: Lists) -> NDArray[Any]:
    """Cut each polygon into a fan of triangles around its first corner, (n, 3).

    The cut depends on the numbers alone, so two files with the same polygons get the same faces.
    """
    sizes, items = polygons
    if (sizes == 3).all():
        return items.reshape(-1, 3)
    triangles = np.maximum(sizes - 2, 0)
    owner, step = _positions(triangles)
    first = (np.cumsum(sizes) - sizes)[owner]
    corners = np.stack([first, first + step + 1, first + step + 2], axis=1)
    return items[corners].astype(np.int64)


def cut_strips(strips: Lists) -> tuple[Lists, str]:
    """Cut triangle strips into triangles of equal winding, and say so.

    A strip a, b, c, d, e stands for the triangles abc, cbd, cde. A corner that is repeated only
    joins two strips into one; the empty triangles it makes are left out.
    """
    sizes, items = strips
    owner, step = _positions(np.maximum(sizes - 2, 0))
    start = (np.cumsum(sizes) - sizes)[owner] + step
    odd = step % 2
    corners = np.stack([start + odd, start + 1 - odd, start + 2], axis=1)
    faces = items[corners].astype(np.int64)
    faces = faces[~_is_collapsed(faces)]
    phrase = f"{counted(len(sizes), 'triangle strip')} cut into {counted(len(faces), 'face')}"
    return Lists.of_rows(faces), phrase


def _is_collapsed(faces: NDArray[Any]) -> BoolArray:
    """Mask of the faces that name a vertex twice, (n,)."""
    a, b, c = faces.T
    repeated: BoolArray = (a == b) | (b == c) | (c == a)
    return repeated


def _positions(lengths: Numbers) -> tuple[Numbers, Numbers]:
    """For lists of the given lengths: the list of each entry, and its place in that list."""
    owner = np.repeat(np.arange(len(lengths)), lengths)
    first = np.cumsum(lengths) - lengths
    return owner, np.arange(len(owner)) - first[owner]
