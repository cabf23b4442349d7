"""Wavefront OBJ: nodes as ``v``, arcs as ``l``; bands and areas in comments."""

import json

from core.skeleton.export.record import Heading, graph_from
from core.skeleton.graph import SkeletalGraph


def to_text(graph: SkeletalGraph) -> str:
    """Write vertices and lines, counted from 1 as OBJ does."""
    lines = [f"# graph {json.dumps(Heading.of(graph).as_dict())}"]
    columns = (graph.nodes, graph.band, graph.area)
    for (x, y, z), band, area in zip(*(c.tolist() for c in columns), strict=True):
        lines += [f"# node {band} {area!r}", f"v {x!r} {y!r} {z!r}"]
    lines += [f"l {first + 1} {second + 1}" for first, second in graph.arcs.tolist()]
    return "\n".join(lines) + "\n"


def from_text(text: str) -> SkeletalGraph:
    """Read vertices, lines and the comments that :func:`to_text` writes."""
    heading = Heading()
    nodes: list[list[float]] = []
    bands: list[int] = []
    areas: list[float] = []
    arcs: list[list[int]] = []
    for line in text.splitlines():
        match line.split():
            case ["#", "graph", *_]:
                heading = Heading(**json.loads(line.partition("graph")[2]))
            case ["#", "node", band, area]:
                bands.append(int(band))
                areas.append(float(area))
            case ["v", *position]:
                nodes.append([float(x) for x in position])
            case ["l", *ends]:
                arcs.append([int(end) - 1 for end in ends])
    return graph_from(heading, nodes, bands, areas, arcs)
