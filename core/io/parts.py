"""Joining the parts of a scene, each moved to its place, into one set of polygons."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.io.errors import LoadError
from core.io.polygons import Lists, Numbers, Polygons, counted

# A small file can ask for a part any number of times. These bound the work and the memory.
MOST_PARTS = 100_000
MOST_ROWS = 5_000_000


class Part(NamedTuple):
    """A mesh and where it stands.

    Attributes
    ----------
    vertices : (m, 3) float64 ndarray
        Positions in the part's own frame.
    faces : (n, 3) int64 ndarray
        Vertex numbers, counted from 0.
    matrix : (4, 4) float64 ndarray
        Affine map into the scene, acting on columns.
    """

    vertices: FloatArray
    faces: Numbers
    matrix: FloatArray

    def placed_vertices(self) -> FloatArray:
        """Return the positions in the scene; untouched, bit for bit, where the map is identity."""
        if np.array_equal(self.matrix, np.eye(4)):
            return self.vertices
        return self.vertices @ self.matrix[:3, :3].T + self.matrix[:3, 3]

    def placed_faces(self) -> Numbers:
        """Return the faces; a mirror turns them round, so that outside stays outside."""
        mirrored = np.linalg.det(self.matrix[:3, :3]) < 0
        return self.faces[:, ::-1] if mirrored else self.faces


def join_parts(parts: Iterable[Part], *, file_size: int, changes: tuple[str, ...] = ()) -> Polygons:
    """Join parts in their order.

    Parameters
    ----------
    parts : iterable of Part
        Taken one by one, and no further than the limits.
    file_size : int
        Bytes of the file; the larger, the more it may hold.
    changes : tuple of str
        What the reader itself had to change.

    Returns
    -------
    Polygons
        All parts that have faces, in one frame.

    Raises
    ------
    LoadError
        If there are more parts than anybody could look at, or a part names a vertex that it does
        not have.
    """
    placed = list(_within_limits(parts, MOST_ROWS + file_size))
    if not placed:
        return Polygons(np.zeros((0, 3)), Lists.empty(), changes)
    starts = np.cumsum([0] + [len(part.vertices) for part in placed])
    faces = [part.placed_faces() + start for part, start in zip(placed, starts[:-1], strict=True)]
    vertices = np.concatenate([part.placed_vertices() for part in placed])
    joined = (f"{counted(len(placed), 'part')} joined",) if len(placed) > 1 else ()
    return Polygons(vertices, Lists.of_rows(np.concatenate(faces)), (*joined, *changes))


def _within_limits(parts: Iterable[Part], most_rows: int) -> Iterator[Part]:
    rows = 0
    for number, part in enumerate(parts):
        rows += len(part.vertices) + len(part.faces)
        if number >= MOST_PARTS or rows > most_rows:
            raise LoadError("its parts are repeated more often than anybody could look at")
        if len(part.faces):
            _check(part)
            yield part


def _check(part: Part) -> None:
    """Refuse numbers out of a part's own range: joined, they would name another part's vertex."""
    outside = (part.faces < 0) | (part.faces >= len(part.vertices))
    if outside.any():
        raise LoadError(
            f"a face names vertex {part.faces[outside][0]}; its part has 0 to "
            f"{len(part.vertices) - 1}"
        )
