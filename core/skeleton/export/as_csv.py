"""CSV: one table whose rows are the nodes, the arcs, and how the graph was made."""

import csv
import io
from typing import Any

from core.skeleton.export.record import Heading, graph_from
from core.skeleton.graph import SkeletalGraph

COLUMNS = ("kind", "number", "x", "y", "z", "band", "area", "source", "target", "value")


def to_text(graph: SkeletalGraph) -> str:
    """Write the table; ``kind`` tells node, arc, field, bands and resolution apart."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for kind, value in Heading.of(graph).as_dict().items():
        writer.writerow({"kind": kind, "value": value})
    columns = (graph.nodes, graph.band, graph.area)
    rows = zip(*(c.tolist() for c in columns), strict=True)
    for number, ((x, y, z), band, area) in enumerate(rows):
        place = {"x": repr(x), "y": repr(y), "z": repr(z), "area": repr(area)}
        writer.writerow({"kind": "node", "number": number, "band": band, **place})
    for number, (source, target) in enumerate(graph.arcs.tolist()):
        writer.writerow({"kind": "arc", "number": number, "source": source, "target": target})
    return stream.getvalue()


def from_text(text: str) -> SkeletalGraph:
    """Read such a table; the nodes stand in the order of their numbers."""
    rows: list[dict[str, Any]] = list(csv.DictReader(io.StringIO(text)))
    about = {row["kind"]: row["value"] for row in rows if row["kind"] not in {"node", "arc"}}
    nodes = [row for row in rows if row["kind"] == "node"]
    arcs = [row for row in rows if row["kind"] == "arc"]
    return graph_from(
        Heading(about["field"], about["bands"], int(about["resolution"])),
        [(float(row["x"]), float(row["y"]), float(row["z"])) for row in nodes],
        [int(row["band"]) for row in nodes],
        [float(row["area"]) for row in nodes],
        [(int(row["source"]), int(row["target"])) for row in arcs],
    )
