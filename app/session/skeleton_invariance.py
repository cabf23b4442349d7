"""Does the graph stay the same when the model is turned, moved, scaled and mirrored? Figure 5.7."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import scipy

from app.session.skeleton_maker import Skeleton
from core.arrays import FloatArray
from core.fields import scalar_field
from core.mesh.geometry import bounding_box
from core.skeleton import SkeletalGraph, band_levels, graph_of
from core.statistics import Progress

_LARGEST_SCALE = 10.0


@dataclass(frozen=True)
class Motion:
    """A similarity transform x → s·Qx + t; `matrix` is s·Q, a reflection where it is mirrored."""

    angle: float
    scale: float
    shift: FloatArray
    matrix: FloatArray

    def move(self, points: FloatArray) -> FloatArray:
        """Carry points along, (k, 3)."""
        return np.asarray(points @ self.matrix.T + self.shift, np.float64)

    def undo(self, points: FloatArray) -> FloatArray:
        """Bring points back, (k, 3)."""
        return np.linalg.solve(self.matrix, (points - self.shift).T).T.astype(np.float64)


@dataclass(frozen=True)
class InvarianceReport:
    """What a motion did to a graph.

    Attributes
    ----------
    motion : Motion
        The motion.
    before, after : tuple of int
        Nodes, arcs and loops.
    isomorphic : bool
        Whether one graph is the other with its nodes renumbered, bands kept.
    displacement : float
        Largest distance of a node from where the motion should have left it, as a share of the
        model's size.
    """

    motion: Motion
    before: tuple[int, int, int]
    after: tuple[int, int, int]
    isomorphic: bool
    displacement: float

    @property
    def text(self) -> str:
        """Report in one sentence."""
        motion = self.motion
        did = f"Turned by {motion.angle:.0f}°, moved, scaled × {motion.scale:.3g} and mirrored"
        if self.isomorphic:
            nodes, arcs, loops = self.after
            same = f"the same graph ({nodes} nodes, {arcs} arcs, {loops} loops)"
            return f"{did}: {same}; nodes within {self.displacement:.1e} of the model's size."
        counts = " → ".join(f"{n} nodes, {a} arcs, {o} loops" for n, a, o in self._counts)
        return f"{did}: another graph ({counts}), nodes up to {self.displacement:.2%} away."

    @property
    def _counts(self) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
        return self.before, self.after


def random_motion(seed: int, size: float) -> Motion:
    """Draw a rotation, a shift of up to the model's size, a scale and a mirror plane."""
    rng = np.random.default_rng(seed)
    rotation = scipy.spatial.transform.Rotation.random(rng=rng)
    scale = float(_LARGEST_SCALE ** rng.uniform(-1, 1))
    matrix = scale * rotation.as_matrix() @ np.diag([1.0, 1.0, -1.0])
    angle = float(np.degrees(rotation.magnitude()))
    return Motion(angle, scale, rng.uniform(-1, 1, 3) * size * scale, matrix)


def invariance_steps(skeleton: Skeleton, seed: int) -> Iterator[Progress[InvarianceReport]]:
    """Move the model of a skeleton at random, draw its graph again and compare."""
    view, mesh = skeleton.view, skeleton.mesh
    low, high = bounding_box(mesh.vertices)
    size = float(np.linalg.norm(high - low))
    motion = random_motion(seed, size)
    moved = mesh.with_vertices(motion.move(mesh.vertices))
    field = scalar_field(moved, view.field, **view.params)
    yield Progress(None, 0.25)
    levels = band_levels(moved, field, view.resolution, view.spacing)
    yield Progress(None, 0.5)
    graph = graph_of(moved, field, levels, bands=view.bands, root=view.root)
    yield Progress(None, 0.75)
    report = InvarianceReport(
        motion,
        _counts(skeleton.graph),
        _counts(graph),
        is_same_graph(skeleton.graph, graph),
        _displacement(skeleton.graph, motion.undo(graph.nodes)) / size,
    )
    yield Progress(report, 1.0)


def is_same_graph(one: SkeletalGraph, other: SkeletalGraph) -> bool:
    """Whether two graphs are isomorphic with bands kept."""
    if np.array_equal(one.arcs, other.arcs) and np.array_equal(one.band, other.band):
        return True
    import networkx as nx  # late, because its import takes a while

    return bool(nx.vf2pp_is_isomorphic(one.to_networkx(), other.to_networkx(), node_label="band"))


def _counts(graph: SkeletalGraph) -> tuple[int, int, int]:
    return len(graph.nodes), len(graph.arcs), graph.loops


def _displacement(graph: SkeletalGraph, nodes: FloatArray) -> float:
    """Largest distance node by node, or to the nearest node where the graphs differ."""
    if len(nodes) == len(graph.nodes):
        return float(np.linalg.norm(nodes - graph.nodes, axis=1).max())
    distances, _ = scipy.spatial.KDTree(graph.nodes).query(nodes)
    return float(np.max(distances))
