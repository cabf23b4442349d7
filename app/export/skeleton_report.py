"""What the command line prints and writes about a skeletal graph."""

import time
from pathlib import Path
from typing import Any

from app.export.pictures import save_picture
from app.scene.skeleton_panes import SkeletonLook, build_pane, field_title
from app.session.skeleton_maker import Skeleton, SkeletonMaker, SkeletonSource
from core.mesh import TriangleMesh
from core.models import read_model
from core.skeleton import FORMATS, automatic_resolution, write_graph
from core.study import SkeletonSettings, SkeletonView

PICTURE_SUFFIX = ".png"
_PICTURE_SIZE = (1600, 1200)


def read_surface(model: str) -> TriangleMesh:
    """Read a model by its path or, as ``sample:ID``, from the bundled ones."""
    return read_model(model).mesh


def draw_skeleton(
    mesh: TriangleMesh, view: SkeletonView, *, automatic: bool
) -> tuple[Skeleton, float]:
    """Draw a graph, at the automatic resolution where asked; also return the time it took."""
    maker, source = SkeletonMaker(), SkeletonSource("", lambda: mesh)
    started = time.perf_counter()
    if automatic:
        field = maker.field(source, view)
        found = automatic_resolution(maker.mesh(source, view), field, spacing=view.spacing)
        view = view.model_copy(update={"resolution": found.resolution})
    return maker.make(source, view), time.perf_counter() - started


def check_output(path: Path) -> None:
    """Refuse a file that could not be written, before any work is done.

    Raises
    ------
    ValueError
        If the suffix is not one of those that can be written, or the folder does not exist.
    """
    allowed = (*FORMATS, PICTURE_SUFFIX)
    if path.suffix.lower() not in allowed:
        raise ValueError(f"{path.name}: a skeleton is written as one of {', '.join(allowed)}.")
    if not path.parent.is_dir():
        raise ValueError(f"{path.parent} is not a folder; the file cannot be written there.")


def write_skeleton(skeleton: Skeleton, path: Path) -> None:
    """Write a graph, or a picture of it on its surface, by the file's suffix."""
    if path.suffix.lower() != PICTURE_SUFFIX:
        write_graph(skeleton.graph, path)
        return
    from app.export.drawing_check import check_drawing
    from app.export.skeleton_pictures import skeleton_picture

    check_drawing()
    pane = build_pane(skeleton, skeleton.mesh.vertices.mean(axis=0))
    look = SkeletonLook(SkeletonSettings(), text_scale=2)
    save_picture(skeleton_picture([pane], look, None, _PICTURE_SIZE), path)


def skeleton_json(skeleton: Skeleton, seconds: float) -> dict[str, Any]:
    """Describe a graph as one JSON object; a genus that is not defined is null."""
    graph, view = skeleton.graph, skeleton.view
    return {
        "model": {"vertices": len(skeleton.mesh.vertices), "faces": len(skeleton.mesh.faces)},
        "field": view.field,
        "params": view.settings.model_dump(),
        "resolution": view.resolution,
        "bands": view.bands,
        "spacing": view.spacing,
        "root": view.root,
        "nodes": len(graph.nodes),
        "arcs": len(graph.arcs),
        "loops": graph.loops,
        "components": graph.components,
        "genus": skeleton.genus,
        "checks": [
            {"loops": c.loops, "genus": c.genus, "bound": c.bound, "reason": c.reason}
            for c in skeleton.checks
        ],
        "notes": list(skeleton.field.notes),
        "seconds": seconds,
    }


def skeleton_text(skeleton: Skeleton, seconds: float) -> str:
    """Describe a graph in a few lines."""
    graph, view = skeleton.graph, skeleton.view
    genus = "–" if skeleton.genus is None else str(skeleton.genus)
    lines = [
        f"{field_title(view)}, R = {view.resolution}, {view.bands} bands",
        f"{len(graph.nodes)} nodes, {len(graph.arcs)} arcs, {graph.components} components, "
        f"{graph.loops} loops, genus {genus}",
        *(f"component {n}: {c.loops} loops, {c.reason}" for n, c in enumerate(skeleton.checks, 1)),
        *skeleton.field.notes,
        f"{seconds:.3f} s",
    ]
    return "\n".join(lines)
