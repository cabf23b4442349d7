"""Numbers of vertices and faces that follow the surface.

A file may number its vertices in any order. Where neighbours have distant numbers, every step of a
loop over the rings waits for memory, and on a large mesh an iteration takes several times as long.
A walk over the surface, ring after ring around its start (breadth first, as Cuthill and McKee
number the rows of a matrix), gives neighbours nearby numbers. Whoever works in such numbers undoes
them on the way out.
"""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from core.arrays import IntArray, frozen
from core.kernels import kernel

Item = TypeVar("Item", bound=np.generic)

# Everything about a smaller mesh fits the processor's own memory, in whatever order.
_SMALL = 20_000
# A walk leaves about √m numbers between neighbours, and so does a grid row by row. An order with
# at most this many times as many is left as it is.
_NEAR = 4.0


@dataclass(frozen=True, eq=False)
class Numbering:
    """New numbers of vertices or faces, and the way back.

    Attributes
    ----------
    order : (k,) int32 ndarray or None
        What the file calls the one that comes first, second …; None leaves all as they are.
    """

    order: IntArray | None = None

    def inward(self, values: NDArray[Item]) -> NDArray[Item]:
        """Bring values from the file's order, (k, …), into the new one."""
        return values if self.order is None else values[self.order]

    def outward(self, values: NDArray[Item]) -> NDArray[Item]:
        """Bring values from the new order, (k, …), back into the file's."""
        if self.order is None:
            return values
        restored = np.zeros_like(values)
        restored[self.order] = values
        return restored


@dataclass(frozen=True, eq=False)
class Ordering:
    """Numbers of the vertices and of the faces of a mesh that follow its surface."""

    vertices: Numbering = Numbering()
    faces: Numbering = Numbering()

    def renumbered(self, faces: IntArray) -> IntArray:
        """Return faces in the new order, with the new numbers of their vertices, (n, 3).

        The first corner of a face stays the first.
        """
        order = self.vertices.order
        if order is None:
            return faces
        ranks = np.zeros_like(order)
        ranks[order] = np.arange(len(order), dtype=np.int32)
        result: IntArray = ranks[self.faces.inward(faces)]
        frozen(result)
        return result


def follows_surface(faces: IntArray, vertex_count: int) -> bool:
    """Whether a mesh is small, or its numbers already lead from neighbour to neighbour."""
    return vertex_count < _SMALL or mean_step(faces) <= _NEAR * np.sqrt(vertex_count)


@kernel
def mean_step(faces: IntArray) -> float:
    """Mean difference of the vertex numbers from one corner to the next, faces in their order."""
    total = 0
    last = faces[0, 0] if len(faces) else 0
    for corner in faces.ravel():
        total += abs(corner - last)
        last = corner
    return total / max(faces.size, 1)


def surface_ordering(faces: IntArray, starts: IntArray, items: IntArray) -> Ordering:
    """Number vertices and faces by a walk over the surface; rows are the faces of each vertex."""
    vertices, turns = walk(faces, starts, items)
    frozen(vertices)
    frozen(turns)
    return Ordering(Numbering(vertices), Numbering(turns))


@kernel
def walk(faces: IntArray, starts: IntArray, items: IntArray) -> tuple[IntArray, IntArray]:
    """Vertices (m,) and faces (n,) in the order in which a breadth-first walk meets them.

    Every component is walked through before the next; each begins at its smallest vertex number.
    """
    met_vertex = np.zeros(len(starts) - 1, np.bool_)
    met_face = np.zeros(len(faces), np.bool_)
    vertices = np.zeros(len(starts) - 1, np.int32)
    turns = np.zeros(len(faces), np.int32)
    vertex_count = face_count = done = 0
    for seed in range(len(vertices)):
        if met_vertex[seed]:
            continue
        met_vertex[seed] = True
        vertices[vertex_count] = seed
        vertex_count += 1
        while done < vertex_count:
            i = vertices[done]
            done += 1
            for t in items[starts[i] : starts[i + 1]]:
                if met_face[t]:
                    continue
                met_face[t] = True
                turns[face_count] = t
                face_count += 1
                for c in range(3):
                    j = faces[t, c]
                    if not met_vertex[j]:
                        met_vertex[j] = True
                        vertices[vertex_count] = j
                        vertex_count += 1
    return vertices, turns
