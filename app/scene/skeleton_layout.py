"""Places for the flat drawing of a graph: bands from left to right, branches below each other."""

import numpy as np
import scipy

from core.arrays import FloatArray, IntArray
from core.skeleton import SkeletalGraph


def flat_places(graph: SkeletalGraph) -> FloatArray:
    """Place of each node, (k, 2): its band, −1 for the root, and its row, counted from 0.

    A tree that spans each component gives every end a row of its own; a node stands in the middle
    of its branches. Arcs that close loops are left to run across.
    """
    count = len(graph.nodes)
    ones = np.ones(len(graph.arcs), np.int8)
    matrix = scipy.sparse.coo_array((ones, graph.arcs.T), shape=(count, count)).tocsr()
    rows = np.full(count, -1.0)
    free = 0
    for start in _starts(graph):
        if rows[start] < 0:
            order, parents = scipy.sparse.csgraph.breadth_first_order(matrix, start, directed=False)
            free = _place_tree(order, parents, rows, free)
    return np.column_stack([graph.band.astype(np.float64), rows])


def _starts(graph: SkeletalGraph) -> list[int]:
    """Nodes to begin trees at: the root, then the lowest nodes."""
    lowest = np.argsort(graph.band, kind="stable").tolist()
    return lowest if graph.root is None else [graph.root, *lowest]


def _place_tree(order: IntArray, parents: IntArray, rows: FloatArray, free: int) -> int:
    """Write the rows of one tree, given in breadth-first order; return the next free row."""
    children: dict[int, list[int]] = {int(node): [] for node in order}
    for node in order[1:].tolist():
        children[int(parents[node])].append(node)
    stack = [int(order[0])]
    while stack:
        node = stack.pop()
        if not children[node]:
            rows[node] = free
            free += 1
        stack += reversed(children[node])
    for node in order[::-1].tolist():
        if children[node]:
            rows[node] = np.mean(rows[children[node]])
    return free
