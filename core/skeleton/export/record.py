"""What every format stores, and the graph made of it again."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from core.arrays import IntArray, frozen
from core.skeleton.graph import ROOT_BAND, Bands, GraphError, SkeletalGraph, label_components


@dataclass(frozen=True)
class Heading:
    """How a graph was made."""

    field: str = ""
    bands: Bands = "exact"
    resolution: int = 0

    @classmethod
    def of(cls, graph: SkeletalGraph) -> "Heading":
        """Take the heading of a graph."""
        return cls(graph.field, graph.bands, graph.resolution)

    def as_dict(self) -> dict[str, Any]:
        """Return the entries by name."""
        return asdict(self)


def graph_from(
    heading: Heading,
    nodes: Sequence[Sequence[float]],
    bands: Sequence[int],
    areas: Sequence[float],
    arcs: Sequence[Sequence[int]],
) -> SkeletalGraph:
    """Put a graph together from what a file says; a node in band −1 is the root."""
    position = np.array(nodes, np.float64).reshape(-1, 3)
    band = np.array(bands, np.int32)
    pairs = np.array(arcs, np.int32).reshape(-1, 2)
    count = len(position)
    if not count or len(band) != count or len(areas) != count:
        raise GraphError("Not every node has a position, a band and an area.")
    if np.any((pairs < 0) | (pairs >= count)) or np.any(band[:-1] == ROOT_BAND):
        raise GraphError("An arc leads to a node that is not there, or the root is not the last.")
    root = count - 1 if band[-1] == ROOT_BAND else None
    component = _components(count, pairs, root)
    # Arcs in the order in which they are drawn: lower node first, those of the root last.
    low, high = np.sort(pairs, axis=1).T
    pairs = np.where((high == root)[:, None], np.stack([high, low], 1), np.stack([low, high], 1))
    pairs = pairs[np.lexsort(pairs.T[::-1])].astype(np.int32)
    area = np.array(areas, np.float64)
    for array in (position, pairs, band, area, component):
        frozen(array)
    return SkeletalGraph(position, pairs, band, area, component, root, **heading.as_dict())


def _components(count: int, pairs: IntArray, root: int | None) -> IntArray:
    if root is None:
        return label_components(count, pairs)
    component = label_components(count, pairs[(pairs != root).all(axis=1)])
    # The root comes last, so leaving it out leaves no gap in the numbers.
    component[root] = ROOT_BAND
    return component
