"""Skeletal graphs: levels, bands, the graph, the Reeb graph, and their files."""

from core.skeleton.automatic import (
    AutomaticResolution,
    automatic_resolution,
    automatic_resolution_steps,
)
from core.skeleton.build import graph_of, skeletal_graph
from core.skeleton.curves import LevelCurves, level_curves
from core.skeleton.cut import CutSurface, cut_surface
from core.skeleton.export import FORMATS, read_graph, write_graph
from core.skeleton.graph import Bands, GraphError, Pieces, SkeletalGraph
from core.skeleton.levels import Spacing, band_levels, level_rule
from core.skeleton.loop_check import LoopCheck, loop_checks
from core.skeleton.reeb import ReebGraph, reeb_graph
from core.skeleton.surface import ComponentSurface, component_surfaces

__all__ = [
    "FORMATS",
    "AutomaticResolution",
    "Bands",
    "ComponentSurface",
    "CutSurface",
    "GraphError",
    "LevelCurves",
    "LoopCheck",
    "Pieces",
    "ReebGraph",
    "SkeletalGraph",
    "Spacing",
    "automatic_resolution",
    "automatic_resolution_steps",
    "band_levels",
    "component_surfaces",
    "cut_surface",
    "graph_of",
    "level_curves",
    "level_rule",
    "loop_checks",
    "read_graph",
    "reeb_graph",
    "skeletal_graph",
    "write_graph",
]
