"""The rings of all faces of any mesh, a part at a time.

k faces around a vertex have k² neighbours together. Of some ten thousand, the rings take more
memory than there is, and going through them takes seconds.
"""

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from core.arrays import IntArray
from core.mesh.topology import MOST_NEIGHBOURS, Topology

# Few enough to be gone through in a moment, even where others load the machine; an ordinary mesh of
# half a million faces has fewer.
_FEW_NEIGHBOURS = 10_000_000


class RingPart(NamedTuple):
    """Rings of faces with consecutive numbers.

    Attributes
    ----------
    first : int
        The first of these faces.
    starts, items : int32 ndarray
        Row i, ``items[starts[i]:starts[i + 1]]``, is the ring of face ``first + i``.
    """

    first: int
    starts: IntArray
    items: IntArray


class FaceRings:
    """The rings tᵢ* of :attr:`Topology.face_ring`, in parts.

    Parameters
    ----------
    topology : Topology
        Whose faces.
    """

    def __init__(self, topology: Topology) -> None:
        self._topology = topology
        around = topology.vertex_faces.lengths.astype(np.int64)
        # A ring has at most as many faces as meet in its three vertices.
        most = np.cumsum(around[topology.faces].sum(axis=1))
        total = int(most[-1]) if len(most) else 0
        self._are_kept = total <= MOST_NEIGHBOURS
        cuts = np.searchsorted(most, np.arange(_FEW_NEIGHBOURS, total, _FEW_NEIGHBOURS)) + 1
        self._bounds = np.unique([0, *cuts, len(most)]).tolist()

    def parts(self) -> Iterator[RingPart]:
        """Yield the rings of all faces; an ordinary mesh has one part.

        Each part is computed when it is its turn, and kept unless they are too many.
        """
        topology = self._topology
        rows = topology.kept_face_rings if self._are_kept else topology.face_rings
        for first, last in pairwise(self._bounds):
            yield RingPart(first, *rows(first, last))
