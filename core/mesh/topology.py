"""Topology of a triangle mesh: everything that follows from the faces alone."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy

from core.arrays import BoolArray, IntArray, frozen
from core.mesh import edge_tables, pieces, rings
from core.mesh.errors import MeshError
from core.mesh.ordering import Ordering, follows_surface, surface_ordering

if TYPE_CHECKING:
    from scipy.sparse import csr_array

# A gigabyte. Ordinary meshes have 12 neighbours a face.
MOST_NEIGHBOURS = 250_000_000


class Rows(NamedTuple):
    """A ragged table as compressed sparse rows.

    Attributes
    ----------
    starts : (k + 1,) int32 ndarray
        Row i occupies ``items[starts[i]:starts[i + 1]]``.
    items : (s,) int32 ndarray
        All entries, row after row, each row in ascending order.
    """

    starts: IntArray
    items: IntArray

    def row(self, i: int) -> IntArray:
        """Return row `i`."""
        return self.items[self.starts[i] : self.starts[i + 1]]

    @property
    def lengths(self) -> IntArray:
        """Number of entries of each row."""
        return np.diff(self.starts)


def _rows(starts: IntArray, items: IntArray) -> Rows:
    frozen(starts)
    frozen(items)
    return Rows(starts, items)


@dataclass(frozen=True, eq=False)
class Topology:
    """Connectivity of a triangle mesh, computed on first use and then kept.

    What does not depend on how vertices and faces are numbered (genus, components and the like) is
    computed in numbers that follow the surface.

    Parameters
    ----------
    faces : (n, 3) int32 ndarray
        Vertex numbers of each face.
    vertex_count : int
        Number of vertices m.
    is_along_surface : bool
        Whether the numbers are known to follow the surface.
    """

    faces: IntArray
    vertex_count: int
    is_along_surface: bool = False

    @cached_property
    def ordering(self) -> Ordering:
        """Numbers that follow the surface; no new ones where those of the faces already do."""
        if self.is_along_surface or follows_surface(self.faces, self.vertex_count):
            return Ordering()
        return surface_ordering(self.faces, *self.vertex_faces)

    @cached_property
    def along_surface(self) -> "Topology":
        """The same topology in the numbers of `ordering`; itself where there are no new ones."""
        if self.ordering.vertices.order is None:
            return self
        return Topology(self.ordering.renumbered(self.faces), self.vertex_count, True)

    @cached_property
    def vertex_faces(self) -> Rows:
        """Faces T(vᵢ*) around each vertex."""
        return _rows(*rings.vertex_faces(self.faces, self.vertex_count))

    @cached_property
    def vertex_ring(self) -> Rows:
        """Neighbours vᵢ* of each vertex."""
        return _rows(*rings.vertex_ring(self.faces, *self.vertex_faces))

    @cached_property
    def face_ring(self) -> Rows:
        """Faces tᵢ* that share a vertex or an edge with each face, without the face itself.

        Raises
        ------
        MeshError
            If these are too many, because very many faces meet in one vertex: k faces around a
            vertex have k² neighbours. :class:`~core.mesh.face_rings.FaceRings` knows a way.
        """
        around = self.vertex_faces.lengths.astype(np.int64)
        if (around**2).sum() > MOST_NEIGHBOURS:
            raise MeshError(
                f"{around.max():,} faces meet in one vertex, and each would be compared with all "
                "others there; that takes more memory than is allowed."
            )
        return self.kept_face_rings(0, len(self.faces))

    def kept_face_rings(self, first: int, last: int) -> Rows:
        """Return the rows of `face_ring` from one face on, up to another, and keep them."""
        if (first, last) not in self._known_face_rings:
            self._known_face_rings[first, last] = self.face_rings(first, last)
        return self._known_face_rings[first, last]

    @cached_property
    def _known_face_rings(self) -> dict[tuple[int, int], Rows]:
        return {}

    def face_rings(self, first: int, last: int) -> Rows:
        """Compute the rows of `face_ring` from one face on, up to another."""
        tables = *self.vertex_faces, self.face_edges, *self.edge_corners
        return _rows(*rings.face_ring(self.faces, first, last, *tables))

    @cached_property
    def _numbered_edges(self) -> tuple[IntArray, IntArray]:
        edges, ring_edges = edge_tables.number_edges(*self.vertex_ring)
        frozen(edges)
        frozen(ring_edges)
        return edges, ring_edges

    @property
    def edges(self) -> IntArray:
        """Edges as vertex pairs (i < j), (e, 2), in lexicographic order."""
        return self._numbered_edges[0]

    @property
    def ring_edges(self) -> IntArray:
        """Edge number of each entry of `vertex_ring`."""
        return self._numbered_edges[1]

    @cached_property
    def face_edges(self) -> IntArray:
        """Edge numbers of each face, (n, 3); entry c runs from corner c to corner c + 1."""
        result = edge_tables.face_edges(self.faces, *self.vertex_ring, self.ring_edges)
        frozen(result)
        return result

    @cached_property
    def edge_corners(self) -> Rows:
        """Corners 3·face + corner that lie opposite each edge, one for each face at the edge."""
        return _rows(*edge_tables.edge_corners(self.face_edges, len(self.edges)))

    @property
    def degrees(self) -> IntArray:
        """Number of neighbours dᵢ of each vertex, (m,)."""
        return self.vertex_ring.lengths

    @cached_property
    def adjacency(self) -> "csr_array":
        """Adjacency matrix A of the vertices, (m, m), ones in float64."""
        ring = self.vertex_ring
        ones = np.ones(len(ring.items))
        return scipy.sparse.csr_array(
            (ones, ring.items, ring.starts), shape=(self.vertex_count,) * 2
        )

    @cached_property
    def boundary_edges(self) -> BoolArray:
        """Mask of the edges with one face, (e,)."""
        mask: BoolArray = self.edge_corners.lengths == 1
        return mask

    @cached_property
    def boundary_vertices(self) -> BoolArray:
        """Mask of the vertices on a boundary edge, (m,)."""
        mask = np.zeros(self.vertex_count, np.bool_)
        mask[self.edges[self.boundary_edges].ravel()] = True
        return mask

    @cached_property
    def nonmanifold_edges(self) -> BoolArray:
        """Mask of the edges with more than two faces, (e,)."""
        mask: BoolArray = self.edge_corners.lengths > 2
        return mask

    @cached_property
    def pinched_vertices(self) -> BoolArray:
        """Mask of the vertices whose faces form more than one fan, (m,)."""
        longest = int(self.degrees.max(initial=0))
        mask: BoolArray = pieces.pinched_vertices(
            self.faces, *self.vertex_faces, *self.vertex_ring, longest
        )
        return mask

    @cached_property
    def vertex_components(self) -> IntArray:
        """Number of the connected component of each vertex, (m,)."""
        components: IntArray = pieces.vertex_components(*self.vertex_ring)
        return components

    @cached_property
    def component_count(self) -> int:
        """Number of connected components; an isolated vertex is one."""
        return int(self.along_surface.vertex_components.max(initial=-1)) + 1

    @cached_property
    def is_consistently_wound(self) -> bool:
        """Whether the faces are wound consistently across every edge with two faces."""
        along = self.along_surface
        return not edge_tables.winding_clashes(along.faces, *along.edge_corners)

    @cached_property
    def is_orientable(self) -> bool:
        """Whether the faces can be wound consistently across every edge with two faces."""
        along = self.along_surface
        return self.is_consistently_wound or bool(
            pieces.is_orientable(along.faces, along.face_edges, *along.edge_corners)
        )

    @cached_property
    def is_closed(self) -> bool:
        """Whether every edge has exactly two faces."""
        return bool(np.all(self.along_surface.edge_corners.lengths == 2))

    @cached_property
    def is_manifold(self) -> bool:
        """Whether no edge has more than two faces and no vertex joins two fans."""
        along = self.along_surface
        return not (along.nonmanifold_edges.any() or along.pinched_vertices.any())

    @property
    def euler_characteristic(self) -> int:
        """Euler characteristic χ = m − e + n."""
        return self.vertex_count - len(self.along_surface.edges) + len(self.faces)

    @cached_property
    def genus(self) -> int | None:
        """Genus of the surface, summed over its components: (2·components − χ)/2.

        None where it is not defined: a surface with boundary, with non-manifold edges or
        vertices, with isolated vertices, or one that cannot be oriented.
        """
        surface = self.is_closed and self.is_manifold and self.is_orientable
        if not surface or np.any(self.along_surface.degrees == 0):
            return None
        return (2 * self.component_count - self.euler_characteristic) // 2
