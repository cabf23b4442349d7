"""JSON: nodes with position, band, area and component, and arcs as pairs of node numbers."""

import json
import math

from core.skeleton.export.record import Heading, graph_from
from core.skeleton.graph import SkeletalGraph


def to_text(graph: SkeletalGraph) -> str:
    """Write one object; an unknown area is null."""
    columns = (graph.nodes, graph.band, graph.area, graph.component)
    nodes = [
        {
            "position": position,
            "band": band,
            "area": None if math.isnan(area) else area,
            "component": component,
        }
        for position, band, area, component in zip(*(c.tolist() for c in columns), strict=True)
    ]
    content = {
        **Heading.of(graph).as_dict(),
        "root": graph.root,
        "loops": graph.loops,
        "components": graph.components,
        "nodes": nodes,
        "arcs": graph.arcs.tolist(),
    }
    return json.dumps(content, indent=1) + "\n"


def from_text(text: str) -> SkeletalGraph:
    """Read such an object."""
    content = json.loads(text)
    nodes = content["nodes"]
    return graph_from(
        Heading(content["field"], content["bands"], content["resolution"]),
        [node["position"] for node in nodes],
        [node["band"] for node in nodes],
        [math.nan if node["area"] is None else node["area"] for node in nodes],
        content["arcs"],
    )
