"""Shortening a Reeb graph: short branches are pruned, short loops are closed."""

import heapq
from collections.abc import Iterable
from itertools import pairwise

import numpy as np

from core.arrays import FloatArray, IntArray


class _Net:
    """A Reeb graph that can be changed. Node numbers ascend with the field."""

    def __init__(self, values: FloatArray, arcs: IntArray) -> None:
        self.values: list[float] = values.tolist()
        self.down: list[set[int]] = [set() for _ in self.values]
        self.up: list[set[int]] = [set() for _ in self.values]
        self.arcs: dict[int, tuple[int, int]] = {}
        self._next = 0
        for low, high in arcs.tolist():
            self.add(low, high)

    def add(self, low: int, high: int) -> int:
        arc = self._next
        self._next += 1
        self.arcs[arc] = (low, high)
        self.up[low].add(arc)
        self.down[high].add(arc)
        return arc

    def remove(self, arc: int) -> None:
        low, high = self.arcs.pop(arc)
        self.up[low].remove(arc)
        self.down[high].remove(arc)

    def length(self, arc: int) -> float:
        low, high = self.arcs[arc]
        return self.values[high] - self.values[low]

    def is_branch(self, arc: int) -> bool:
        """Whether an arc leads to an end and can go without the rest falling apart."""
        low, high = self.arcs[arc]
        hangs = not self.down[low] and len(self.up[low]) == 1 and len(self.down[high]) > 1
        stands = not self.up[high] and len(self.down[high]) == 1 and len(self.up[low]) > 1
        return hangs or stands

    def contract(self, node: int) -> int | None:
        """Join the two arcs at a node that has one below and one above; return the new arc."""
        if len(self.down[node]) != 1 or len(self.up[node]) != 1:
            return None
        (below,), (above,) = self.down[node], self.up[node]
        low, high = self.arcs[below][0], self.arcs[above][1]
        self.remove(below)
        self.remove(above)
        return self.add(low, high)

    def prune(self, limit: float) -> None:
        """Remove branches up to a length, the shortest first."""
        heap = [(self.length(arc), arc) for arc in self.arcs if self.is_branch(arc)]
        heapq.heapify(heap)
        while heap and heap[0][0] <= limit:
            arc = heapq.heappop(heap)[1]
            if arc not in self.arcs or not self.is_branch(arc):
                continue
            ends = self.arcs[arc]
            self.remove(arc)
            for node in ends:
                joined = self.contract(node)
                # What is left at the node may have become a branch in its turn.
                for other in self.at(node) if joined is None else (joined,):
                    if self.is_branch(other):
                        heapq.heappush(heap, (self.length(other), other))

    def at(self, node: int) -> list[int]:
        return sorted(self.down[node] | self.up[node])

    def cycle_below(self, top: int, limit: float) -> tuple[float, list[int]] | None:
        """Find the shortest cycle that has its highest node at `top`: its length and its arcs.

        All arcs below the node are followed at once, the highest reached node first. The first
        two of them to meet close the cycle whose lowest node is highest.
        """
        floor = self.values[top] - limit
        came: dict[int, tuple[int, int, int]] = {}
        heap = [(-self.arcs[arc][0], arc, top, arc) for arc in sorted(self.down[top])]
        heapq.heapify(heap)
        while heap:
            node, arc, last, source = heapq.heappop(heap)
            node = -node
            if self.values[node] < floor:
                return None
            if node not in came:
                came[node] = (arc, last, source)
                for other in self.at(node):
                    far = sum(self.arcs[other]) - node
                    if other != arc and far < top:
                        heapq.heappush(heap, (-far, other, node, source))
            elif came[node][2] != source:
                first, bottom = _walk_back(came, node, top)
                second, also = _walk_back(came, last, top)
                return self.values[top] - self.values[min(bottom, also)], [*first, arc, *second]
        return None

    def close(self, cycle: list[int]) -> list[int]:
        """Slide the two sides of a cycle together level by level; return the nodes on it."""
        nodes = sorted({node for arc in cycle for node in self.arcs[arc]})
        for arc in cycle:
            self.remove(arc)
        for low, high in pairwise(nodes):
            self.add(low, high)
        for node in nodes:
            self.contract(node)
        return nodes

    def close_loops(self, limit: float) -> bool:
        """Close loops up to a length, the shortest first; return whether there were any."""
        heap: list[tuple[float, int]] = []
        closed = False
        self._queue(heap, range(len(self.values)), limit)
        while heap:
            length, top = heapq.heappop(heap)
            found = self.cycle_below(top, limit) if len(self.down[top]) > 1 else None
            if found is None:
                continue
            if found[0] > length:
                heapq.heappush(heap, (found[0], top))
                continue
            self._queue(heap, self.close(found[1]), limit)
            closed = True
        return closed

    def _queue(self, heap: list[tuple[float, int]], tops: Iterable[int], limit: float) -> None:
        for top in tops:
            found = self.cycle_below(top, limit) if len(self.down[top]) > 1 else None
            if found is not None:
                heapq.heappush(heap, (found[0], top))


def _walk_back(came: dict[int, tuple[int, int, int]], node: int, top: int) -> tuple[list[int], int]:
    """Arcs from a node back to the top, and the lowest node on the way."""
    arcs, bottom = [], node
    while node != top:
        bottom = min(bottom, node)
        arc, node, _ = came[node]
        arcs.append(arc)
    return arcs, bottom


def simplified_arcs(values: FloatArray, arcs: IntArray, limit: float) -> IntArray:
    """Prune branches and close loops that are not longer than `limit`.

    Parameters
    ----------
    values : (k,) float64 ndarray
        Field at the nodes, in ascending order.
    arcs : (a, 2) int32 ndarray
        Node pairs, the lower one first.
    limit : float
        Largest length that goes.

    Returns
    -------
    (a', 2) int32 ndarray
        The arcs that are left, in ascending order, between nodes of the same numbers.
    """
    net = _Net(values, arcs)
    net.prune(limit)
    while net.close_loops(limit):
        net.prune(limit)
    return np.array(sorted(net.arcs.values()), np.int32).reshape(-1, 2)
