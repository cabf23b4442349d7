"""What a pane shows, as values: the window and a headless picture draw the same ones."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.scene.colours import LIGHT, Theme
from core.arrays import FloatArray, IntArray
from core.mesh.topology import Topology

Points = NDArray[np.float32]

NO_FACES = Topology(np.zeros((0, 3), np.int32), 0)
"""Connectivity where there is no mesh yet."""


@dataclass(frozen=True, eq=False)
class Pane:
    """One mesh of the grid.

    Attributes
    ----------
    id : str
        "original", "noisy" or a method's id.
    title, caption : str
        First and second line above the mesh.
    colour : str
        Colour of the title.
    points : (m, 3) float32 ndarray
        Positions relative to the common centre.
    values : (m,) or (n,) float64 ndarray or None
        Error of each vertex or face, for colouring.
    warning : bool
        Whether the caption is a warning.
    """

    id: str
    title: str
    caption: str
    colour: str
    points: Points
    values: NDArray[np.float64] | None = None
    warning: bool = False


@dataclass(frozen=True, eq=False)
class Look:
    """How all panes are drawn.

    Attributes
    ----------
    topology : Topology
        Connectivity that the meshes of all panes share.
    theme : Theme
        Colours.
    smooth, edges : bool
        Smooth shading instead of flat; draw the edges.
    values_on : {"vertex", "face"}
        What the panes' values belong to.
    colour_title : str
        Title of the colour bar; empty where no values are shown.
    colour_range : (float, float)
        Values at the ends of the colour bar, the same for all panes.
    colour_map : str
        Name of the colour map; "_r" at its end reverses it.
    histogram : (b,) float64 ndarray or None
        Heights of the bins beside the colour bar, 0 to 1 from the lower end up.
    bar, framed : bool
        Whether the colour bar and the frames of the panes are drawn.
    selected : str or None
        Pane with a frame.
    text_scale : float
        Size of the captions; 1 on a plain screen.
    marks : (k,) int64 ndarray or None
        Vertices that are pointed out with dots.
    """

    topology: Topology
    theme: Theme = LIGHT
    smooth: bool = True
    edges: bool = False
    values_on: Literal["vertex", "face"] = "vertex"
    colour_title: str = ""
    colour_range: tuple[float, float] = (0.0, 1.0)
    colour_map: str = "viridis"
    histogram: FloatArray | None = None
    bar: bool = True
    framed: bool = True
    selected: str | None = None
    text_scale: float = 1.0
    marks: NDArray[np.int64] | None = None

    @property
    def faces(self) -> IntArray:
        """Faces of all meshes, (n, 3)."""
        return self.topology.faces


def shared_range(panes: list[Pane]) -> tuple[float, float]:
    """Range of the colour bar: from 0 to what 98 % of the values of the middling pane stay below.

    One wild method would make all others look alike, so the panes vote: the median of their
    98th percentiles is taken.
    """
    tops = [float(np.percentile(pane.values, 98)) for pane in panes if pane.values is not None]
    top = float(np.median(tops)) if tops else 1.0
    return 0.0, top if top > 0 else 1.0
