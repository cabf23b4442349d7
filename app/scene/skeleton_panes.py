"""What a pane of the Skeleton tab shows, as values: window and headless picture draw the same."""

from dataclasses import dataclass

import numpy as np

from app.scene.colours import LIGHT, Theme
from app.session.skeleton_maker import Skeleton
from core.arrays import BoolArray, FloatArray
from core.fields import FIELDS
from core.parameters import describe
from core.skeleton import SkeletalGraph
from core.smoothing import METHODS
from core.study import SkeletonSettings, SkeletonView


@dataclass(frozen=True, eq=False)
class SkeletonPane:
    """One skeletal graph on its surface.

    Attributes
    ----------
    title, caption, note : str
        First, second and third line above the surface.
    centre : (3,) float64 ndarray
        Point of the model that stands in the middle, the same for all panes.
    skeleton : Skeleton or None
        The graph; None where there is none, for the reason that the caption says.
    step : int or None
        Number of bands that have grown; None for all.
    picked : int or None
        Node that is lit up with its piece of surface.
    warning : bool
        Whether the caption is a warning.
    """

    title: str
    caption: str
    note: str
    centre: FloatArray
    skeleton: Skeleton | None
    step: int | None = None
    picked: int | None = None
    warning: bool = False


@dataclass(frozen=True)
class SkeletonLook:
    """How all panes are drawn.

    Attributes
    ----------
    settings : SkeletonSettings
        What is shown and in which colours.
    theme : Theme
        Colours of ground and ink.
    text_scale : float
        Size of text and lines; 1 on a plain screen.
    selected : int or None
        Pane with a heavy frame; None leaves out all frames.
    legend : bool
        Whether each pane has the scale of its bands.
    """

    settings: SkeletonSettings
    theme: Theme = LIGHT
    text_scale: float = 1.0
    selected: int | None = None
    legend: bool = True


def build_pane(
    skeleton: Skeleton, centre: FloatArray, step: int | None = None, picked: int | None = None
) -> SkeletonPane:
    """Build the pane of a graph with its text."""
    if picked is not None and not grown_nodes(skeleton.graph, step)[picked]:
        picked = None
    note = genus_note(skeleton) if picked is None else node_text(skeleton, picked)
    title = view_title(skeleton.view)
    return SkeletonPane(title, counts_text(skeleton), note, centre, skeleton, step, picked)


def missing_pane(
    view: SkeletonView, centre: FloatArray, reason: str, *, warning: bool
) -> SkeletonPane:
    """Build the pane of a graph that is not there, or not yet."""
    return SkeletonPane(view_title(view), reason, "", centre, None, warning=warning)


def view_title(view: SkeletonView) -> str:
    """Field, resolution and surface of a view in one line."""
    parts = [f"{field_title(view)}, R = {view.resolution}"]
    if view.bands != "exact":
        parts.append("vertex bands")
    if view.source != "original":
        parts.append(METHODS[view.source].title if view.source in METHODS else view.source)
    if view.keep < 1:
        parts.append(
            f"{view.keep:.2g} of the faces" if view.keep < 0.01 else f"{view.keep:.0%} of the faces"
        )
    return " · ".join(parts)


def field_title(view: SkeletonView) -> str:
    """Name of a view's field with the parameters that differ from their defaults."""
    spec = FIELDS[view.field]
    symbols = {"weight": "λ"}
    known = [parameter.name for parameter in describe(spec.params)]
    changed = [f"{symbols.get(n, n)} = {view.params[n]}" for n in known if n in view.params]
    return f"{spec.title} ({', '.join(changed)})" if changed else spec.title


def counts_text(skeleton: Skeleton) -> str:
    """Nodes, arcs, components, and loops against the genus."""
    graph = skeleton.graph
    parts = "component" if graph.components == 1 else "components"
    counts = f"{len(graph.nodes)} nodes   {len(graph.arcs)} arcs   {graph.components} {parts}"
    genus = "–" if skeleton.genus is None else str(skeleton.genus)
    return f"{counts}   {graph.loops} loops / genus {genus}"


def genus_note(skeleton: Skeleton) -> str:
    """Why there is no genus, or nothing."""
    reasons = (check.reason for check in skeleton.checks if check.genus is None)
    reason = next(reasons, None)
    return f"genus –: {reason}" if reason else ""


def node_text(skeleton: Skeleton, node: int) -> str:
    """What is known of a node: band, area, size, position."""
    graph = skeleton.graph
    # A millionth of the model is as good as nothing.
    decimals = 6 - int(np.floor(np.log10(max(skeleton.size, 1e-300))))
    place = ", ".join(f"{x:.4g}" for x in np.round(graph.nodes[node], decimals) + 0.0)
    if node == graph.root:
        return f"root   at ({place})"
    faces, vertices = graph.member_faces(node), graph.member_vertices(node)
    share = graph.area[node] / max(float(graph.area.sum()), 1e-300)
    return (
        f"node {node}, {graph.kinds[node]}   band {graph.band[node] + 1} of {graph.resolution}   "
        f"area {graph.area[node]:.4g} ({share:.2%})\n"
        f"{len(faces):,} faces   {len(vertices):,} vertices   at ({place})"
    )


def grown_nodes(graph: SkeletalGraph, step: int | None) -> BoolArray:
    """Whether each node has grown after `step` bands, (k,); the root always has."""
    return np.asarray(graph.band < (graph.resolution if step is None else step), np.bool_)
