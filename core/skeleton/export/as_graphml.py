"""GraphML, for Gephi, yEd, igraph and networkx."""

import io
from typing import Any

from core.skeleton.export.record import Heading, graph_from
from core.skeleton.graph import SkeletalGraph


def to_text(graph: SkeletalGraph) -> str:
    """Write the graph's networkx form with all attributes."""
    import networkx as nx

    stream = io.BytesIO()
    nx.write_graphml_xml(graph.to_networkx(), stream)
    return stream.getvalue().decode("utf-8")


def from_text(text: str) -> SkeletalGraph:
    """Read a graph whose nodes have the numbers 0, 1, 2 … and carry x, y, z, band and area."""
    import networkx as nx

    graph: Any = nx.parse_graphml(text, node_type=int)
    nodes = [graph.nodes[node] for node in range(len(graph))]
    about = graph.graph
    return graph_from(
        Heading(about["field"], about["bands"], about["resolution"]),
        [(node["x"], node["y"], node["z"]) for node in nodes],
        [node["band"] for node in nodes],
        [node["area"] for node in nodes],
        list(graph.edges),
    )
