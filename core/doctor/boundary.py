"""The loops in which a surface ends, followed from fan to fan."""

import numpy as np
import scipy

from core.arrays import IntArray
from core.doctor.spec import Numbers
from core.doctor.splitting import fans
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.mesh.topology import Rows


def boundary_loops(mesh: TriangleMesh) -> Rows:
    """Vertices of each boundary loop, in the order in which a patch has to run along it.

    Loops are followed from fan to fan, so holes that touch at a pinched vertex have one loop, as
    they have once the vertex is split. Where the faces are not wound consistently a loop has no
    direction and is left out.
    """
    start, end, vertex = _half_edges(mesh)
    count = 3 * len(mesh.faces)
    outgoing = np.bincount(start, minlength=count) == 1
    incoming = np.bincount(end, minlength=count) == 1
    at = np.full(count, -1)
    at[start] = np.arange(len(start))
    following = np.where((outgoing & incoming)[end], at[end], -1)
    order, starts = _trace(following)
    return Rows(starts.astype(np.int32), vertex[order])


def _half_edges(mesh: TriangleMesh) -> tuple[Numbers, Numbers, IntArray]:
    """Fans at the start and the end of each boundary edge, run against its face; start vertex."""
    face, c = np.nonzero(mesh.topology.boundary_edges[mesh.topology.face_edges])
    fan = fans(mesh).reshape(-1, 3)
    following = (c + 1) % 3
    return fan[face, following], fan[face, c], mesh.faces[face, following]


@kernel
def _trace(following: Numbers) -> tuple[Numbers, Numbers]:
    """Closed rounds of a successor table, one after the other, and where each begins."""
    n = len(following)
    order, starts = np.zeros(n, np.int64), np.zeros(n + 1, np.int64)
    state = np.zeros(n, np.int8)  # 1: walked over
    length, loops = 0, 0
    for seed in range(n):
        at, first = seed, length
        while at >= 0 and state[at] == 0:
            state[at] = 1
            order[length] = at
            length += 1
            at = following[at]
        if at == seed and length > first:
            loops += 1
            starts[loops] = length
        else:
            length = first
    return order[:length], starts[: loops + 1]


def loop_count(mesh: TriangleMesh) -> int:
    """Number of boundary loops; counts those too that have no direction."""
    start, end, _ = _half_edges(mesh)
    names, numbers = np.unique(np.concatenate([start, end]), return_inverse=True)
    if not len(names):
        return 0
    first, second = numbers.reshape(2, -1)
    ones = np.ones(len(first), np.int8)
    graph = scipy.sparse.coo_array((ones, (first, second)), shape=(len(names), len(names)))
    return int(scipy.sparse.csgraph.connected_components(graph, directed=False)[0])


def simple_loops(mesh: TriangleMesh) -> Rows:
    """Boundary loops, cut where they come back to a vertex."""
    starts, items = _cut(*boundary_loops(mesh), len(mesh.vertices))
    return Rows(starts, items)


@kernel
def _cut(starts: IntArray, items: IntArray, vertex_count: int) -> tuple[IntArray, IntArray]:
    """Walk along each loop; what lies between two visits of a vertex is a loop of its own."""
    place = np.full(vertex_count, -1)  # on the walk
    walk, parts = np.empty_like(items), np.empty_like(items)
    ends = np.zeros(len(items) + 1, np.int32)
    filled, count = 0, 0
    for loop in range(len(starts) - 1):
        length = 0
        for slot in range(starts[loop], starts[loop + 1] + 1):
            is_over = slot == starts[loop + 1]
            back = 0 if is_over else place[items[slot]]
            if back >= 0:
                for vertex in walk[back:length]:
                    parts[filled] = vertex
                    place[vertex] = -1
                    filled += 1
                count += 1
                ends[count] = filled
                length = back
            if not is_over:
                walk[length] = items[slot]
                place[items[slot]] = length
                length += 1
    return ends[: count + 1], parts
