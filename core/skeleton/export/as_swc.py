"""SWC, the format of neuron morphologies: a forest, so only for graphs without loops."""

import json
import math

from core.skeleton.export.record import Heading, graph_from
from core.skeleton.graph import GraphError, SkeletalGraph

_ROOT, _OTHER = 1, 0
"""Types of a sample: the soma for the root, undefined for the rest."""


def to_text(graph: SkeletalGraph) -> str:
    """Write one sample a node: number, type, x, y, z, radius, parent.

    The radius is that of a sphere with the node's area. Each tree starts at the root, or at its
    node in the lowest band; parents come before their children.

    Raises
    ------
    GraphError
        If the graph has loops, be it through the root.
    """
    import networkx as nx

    net = graph.to_networkx()
    trees = list(nx.connected_components(net))
    loops = len(graph.arcs) - len(graph.nodes) + len(trees)
    if loops:
        raise GraphError(f"SWC holds trees only; this graph has {loops} loops, with its root.")
    lines = [f"# graph {json.dumps(Heading.of(graph).as_dict())}"]
    number: dict[int, int] = {}
    for tree in trees:
        start = graph.root if graph.root in tree else min(tree)
        for parent, node in [(-1, start), *nx.bfs_edges(net, start)]:
            number[node] = len(number) + 1
            lines += _sample(graph, node, number[node], number.get(parent, -1))
    return "\n".join(lines) + "\n"


def _sample(graph: SkeletalGraph, node: int, number: int, parent: int) -> list[str]:
    x, y, z = graph.nodes[node].tolist()
    area = float(graph.area[node])
    radius = 0.0 if math.isnan(area) else math.sqrt(area / (4 * math.pi))
    kind = _ROOT if node == graph.root else _OTHER
    return [
        f"# node {node} {graph.band[node]} {area!r}",
        f"{number} {kind} {x!r} {y!r} {z!r} {radius!r} {parent}",
    ]


def from_text(text: str) -> SkeletalGraph:
    """Read samples and the comments that :func:`to_text` writes before each."""
    heading = Heading()
    notes: list[tuple[int, int, float]] = []
    samples: list[tuple[list[float], int]] = []
    for line in text.splitlines():
        match line.split():
            case ["#", "graph", *_]:
                heading = Heading(**json.loads(line.partition("graph")[2]))
            case ["#", "node", node, band, area]:
                notes.append((int(node), int(band), float(area)))
            case [_, _, x, y, z, _, parent]:
                samples.append(([float(x), float(y), float(z)], int(parent)))
    order = sorted(range(len(samples)), key=lambda sample: notes[sample][0])
    arcs = [
        (notes[sample][0], notes[parent - 1][0])
        for sample, (_, parent) in enumerate(samples)
        if parent > 0
    ]
    return graph_from(
        heading,
        [samples[sample][0] for sample in order],
        [notes[sample][1] for sample in order],
        [notes[sample][2] for sample in order],
        arcs,
    )
