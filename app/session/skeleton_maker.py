"""Skeletal graphs of the window, each stage kept under what it was computed from."""

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import NDArray

from app.session.kept import Kept
from core.arrays import FloatArray
from core.fields import ScalarField, scalar_field
from core.mesh import TriangleMesh
from core.mesh.geometry import bounding_box
from core.mesh.remesh import decimated, decimation_steps
from core.skeleton import (
    ComponentSurface,
    LevelCurves,
    LoopCheck,
    SkeletalGraph,
    component_surfaces,
    graph_of,
    level_curves,
    level_rule,
    loop_checks,
)
from core.skeleton.levels import LevelRule
from core.statistics import Progress
from core.stepwise import Stepwise, carried_out
from core.study import SkeletonView

_SKETCH_FACES = 24_000
_NOTICED = 0.02
_FEW = 6
_MANY = 160


@dataclass(frozen=True, eq=False)
class SkeletonSource:
    """A surface that a graph can be drawn of.

    Attributes
    ----------
    key : str
        Says what it was made from; equal keys mean equal meshes.
    build : callable
        Makes the mesh; may be called on the worker thread.
    """

    key: str
    build: Callable[[], TriangleMesh]


@dataclass(frozen=True, eq=False)
class Sketch:
    """A coarse copy of a large surface, to be drawn while something moves.

    Attributes
    ----------
    mesh : TriangleMesh
        The coarse surface.
    nearest : (k,) int64 ndarray
        Vertex of the full surface next to each of its vertices, which lends it its values.
    """

    mesh: TriangleMesh
    nearest: NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A skeletal graph with all that it was drawn from.

    Attributes
    ----------
    view : SkeletonView
        What was asked for.
    mesh : TriangleMesh
        The surface; the same object as long as the surface is the same.
    field : ScalarField
        Its field.
    levels : (R − 1,) float64 ndarray
        The levels.
    graph : SkeletalGraph
        The graph.
    curves : LevelCurves
        The level curves.
    checks : tuple of LoopCheck
        Loops beside the genus, component by component.
    seconds : float
        Time from the field to the graph with its curves.
    size : float
        Diagonal of the surface's bounding box.
    sketch : Sketch or None
        Coarse copy of a large surface.
    """

    view: SkeletonView
    mesh: TriangleMesh
    field: ScalarField
    levels: FloatArray
    graph: SkeletalGraph
    curves: LevelCurves
    checks: tuple[LoopCheck, ...]
    seconds: float
    size: float = 0.0
    sketch: Sketch | None = None

    @property
    def genus(self) -> int | None:
        """Genus summed over the components, None where one of them has none."""
        known = [check.genus for check in self.checks]
        return None if None in known else sum(genus or 0 for genus in known)

    @property
    def bytes(self) -> int:
        """Memory that it takes apart from mesh and field, which several graphs share."""
        arrays = (*(self.graph.pieces or ()), self.curves.points, self.curves.starts)
        return sum(array.nbytes for array in arrays)


class SkeletonMaker:
    """Draws skeletal graphs and keeps meshes, fields and graphs; for one thread.

    Parameters
    ----------
    budget : callable
        Returns the memory for graphs in bytes.
    """

    def __init__(self, budget: Callable[[], float] = lambda: math.inf) -> None:
        self._meshes: Kept[TriangleMesh] = Kept(_FEW)
        self._surfaces: Kept[tuple[ComponentSurface, ...]] = Kept(_FEW)
        self._sketches: Kept[Sketch | None] = Kept(_FEW)
        self._sizes: Kept[float] = Kept(_FEW)
        self._fields: Kept[ScalarField] = Kept(_FEW)
        self._rules: Kept[LevelRule] = Kept(_FEW)
        self._graphs: Kept[Skeleton] = Kept(_MANY, lambda skeleton: skeleton.bytes, budget)

    def make(self, source: SkeletonSource, view: SkeletonView) -> Skeleton:
        """Draw the graph of a view.

        Raises
        ------
        ParameterError, MeshError
            If a setting is not allowed or the surface has no graph.
        """
        mesh, field = self.mesh(source, view), self.field(source, view)
        rule, surfaces = self._rule(source, view), self._component_surfaces(source, view)
        sketch = self._sketch(source, view)
        size = self._sizes.get(_mesh_key(source, view), lambda: diagonal(mesh))

        def draw() -> Skeleton:
            drawn = _draw(view, mesh, field, rule(view.resolution), surfaces)
            return replace(drawn, size=size, sketch=sketch)

        key = f"{_mesh_key(source, view)}|{_field_key(view)}"
        return self._graphs.get((key, view.model_dump_json()), draw)

    def steps(self, source: SkeletonSource, view: SkeletonView) -> Iterator[Progress[Skeleton]]:
        """Draw the graph of a view as `make` does, one stage that is not there yet at a time."""
        for _ in self._coarsen(source, view):
            yield Progress(None, 0.0)
        stages = (self.mesh, self.field, self._rule, self._component_surfaces, self._sketch)
        for done, stage in enumerate(stages, 1):
            started = time.perf_counter()
            stage(source, view)
            if time.perf_counter() - started > _NOTICED:
                yield Progress(None, done / (len(stages) + 1))
        yield Progress(self.make(source, view), 1.0)

    def _coarsen(self, source: SkeletonSource, view: SkeletonView) -> Stepwise[None]:
        """Decimate the surface of a view, and what is drawn of it while something moves."""
        key, whole = _mesh_key(source, view), self._meshes.get(source.key, source.build)
        mesh = yield from self._meshes.get_stepwise(key, lambda: decimation_steps(whole, view.keep))
        yield from self._sketches.get_stepwise(key, lambda: sketch_steps(mesh))

    def mesh(self, source: SkeletonSource, view: SkeletonView) -> TriangleMesh:
        """Return the surface of a view, decimated as it asks."""
        whole = self._meshes.get(source.key, source.build)
        return self._meshes.get(_mesh_key(source, view), lambda: decimated(whole, view.keep))

    def field(self, source: SkeletonSource, view: SkeletonView) -> ScalarField:
        """Return the field of a view."""
        mesh = self.mesh(source, view)
        key = f"{_mesh_key(source, view)}|{_field_key(view)}"
        return self._fields.get(key, lambda: scalar_field(mesh, view.field, **view.params))

    def _rule(self, source: SkeletonSource, view: SkeletonView) -> LevelRule:
        mesh, field = self.mesh(source, view), self.field(source, view)
        key = _mesh_key(source, view), _field_key(view), view.spacing
        return self._rules.get(key, lambda: level_rule(mesh, field, view.spacing))

    def _sketch(self, source: SkeletonSource, view: SkeletonView) -> Sketch | None:
        mesh = self.mesh(source, view)
        return self._sketches.get(_mesh_key(source, view), lambda: carried_out(sketch_steps(mesh)))

    def _component_surfaces(
        self, source: SkeletonSource, view: SkeletonView
    ) -> tuple[ComponentSurface, ...]:
        mesh = self.mesh(source, view)
        return self._surfaces.get(mesh.topology, lambda: component_surfaces(mesh))


def diagonal(mesh: TriangleMesh) -> float:
    """Diagonal of a surface's bounding box."""
    low, high = bounding_box(mesh.vertices)
    return float(np.linalg.norm(high - low))


def sketch_steps(mesh: TriangleMesh) -> Stepwise[Sketch | None]:
    """Make the coarse copy of a large surface; a small one needs none."""
    share = _SKETCH_FACES / max(len(mesh.faces), 1)
    if share >= 1:
        return None
    coarse = yield from decimation_steps(mesh, share)
    nearest = np.asarray(scipy.spatial.KDTree(mesh.vertices).query(coarse.vertices)[1], np.int64)
    return Sketch(coarse, nearest)


def _draw(
    view: SkeletonView,
    mesh: TriangleMesh,
    field: ScalarField,
    levels: FloatArray,
    surfaces: tuple[ComponentSurface, ...],
) -> Skeleton:
    started = time.perf_counter()
    graph = graph_of(mesh, field, levels, bands=view.bands, root=view.root)
    curves = level_curves(mesh, field, levels)
    checks = loop_checks(mesh, graph, surfaces)
    seconds = time.perf_counter() - started
    return Skeleton(view, mesh, field, levels, graph, curves, checks, seconds)


def _mesh_key(source: SkeletonSource, view: SkeletonView) -> str:
    return f"{source.key}|{view.keep}"


def _field_key(view: SkeletonView) -> str:
    return f"{view.field} {view.settings.model_dump_json()}"
