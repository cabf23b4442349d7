"""Skeletal graphs as files: one format per file, chosen by the suffix.

Every format keeps positions, arcs, bands, areas, the root and how the graph was made, so that
reading a file gives the graph that was written. What a format has no place for stands in
comments that other programs skip.
"""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from core.skeleton.export import as_csv, as_graphml, as_json, as_obj, as_swc
from core.skeleton.graph import GraphError, SkeletalGraph
from core.whole_files import write_atomically


class Format(NamedTuple):
    """A file format: its name, and the functions from a graph to text and back."""

    title: str
    to_text: Callable[[SkeletalGraph], str]
    from_text: Callable[[str], SkeletalGraph]


FORMATS: dict[str, Format] = {
    ".graphml": Format("GraphML", as_graphml.to_text, as_graphml.from_text),
    ".json": Format("JSON", as_json.to_text, as_json.from_text),
    ".obj": Format("Wavefront OBJ lines", as_obj.to_text, as_obj.from_text),
    ".csv": Format("CSV table of nodes and arcs", as_csv.to_text, as_csv.from_text),
    ".swc": Format("SWC, for graphs without loops", as_swc.to_text, as_swc.from_text),
}
"""All formats by suffix."""

__all__ = ["FORMATS", "Format", "read_graph", "write_graph"]


def _format(path: Path) -> Format:
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise GraphError(f"{path.name}: a graph file ends in one of {', '.join(FORMATS)}.")
    return FORMATS[suffix]


def write_graph(graph: SkeletalGraph, path: str | Path) -> None:
    """Write a graph in the format that the file's suffix names.

    Parameters
    ----------
    graph : SkeletalGraph
        The graph.
    path : str or Path
        File to write, ending in .graphml, .json, .obj, .csv or .swc.

    Raises
    ------
    GraphError
        If the suffix is none of these, or a graph with loops is to become an SWC file.
    OSError
        If the file cannot be written.
    """
    path = Path(path)
    text = _format(path).to_text(graph)
    write_atomically(path, text.encode())


def read_graph(path: str | Path) -> SkeletalGraph:
    """Read a graph that :func:`write_graph` wrote.

    Parameters
    ----------
    path : str or Path
        File in one of the five formats.

    Returns
    -------
    SkeletalGraph
        Equal to the one that was written, without its pieces of surface.

    Raises
    ------
    GraphError
        If the suffix is none of the five, or the content is no graph in that format.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    chosen = _format(path)
    try:
        return chosen.from_text(path.read_text(encoding="utf-8"))
    except (ValueError, KeyError, IndexError, TypeError, SyntaxError) as error:
        raise GraphError(f"{path.name} is not a graph in the format {chosen.title}.") from error
