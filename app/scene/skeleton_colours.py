"""Colours of bands and of nodes: the same on the surface, in the graph and in its flat drawing."""

import numpy as np
import pyvista as pv
from matplotlib import colormaps
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from app.scene.colours import Theme
from core.arrays import FloatArray
from core.skeleton import SkeletalGraph

Colours = NDArray[np.uint8]

KIND_COLOURS = {"end": "#e69f00", "branch": "#d0342c", "regular": "#1a80c4"}
"""Colour of a node by its kind."""

BAND_MAP = "viridis"
_LOWEST, _HIGHEST = 0.04, 0.98
_EVERY_OTHER = 0.84
_TEXELS = 2048


def band_colours(resolution: int) -> Colours:
    """Colours of the bands from the lowest up, (R, 3); neighbours differ in lightness as well."""
    shares = np.linspace(_LOWEST, _HIGHEST, max(resolution, 2))[:resolution]
    colours = np.asarray(colormaps[BAND_MAP](shares))[:, :3]
    colours[1::2] *= _EVERY_OTHER
    return _bytes(colours)


def node_colours(graph: SkeletalGraph, by: str, theme: Theme) -> Colours:
    """Colour of each node, (k, 3): by its band or by its kind; the root has that of the ink."""
    if by == "kind":
        table = {kind: to_rgb(colour) for kind, colour in KIND_COLOURS.items()}
        colours = _bytes(np.array([table[str(kind)] for kind in graph.kinds]).reshape(-1, 3))
    else:
        colours = band_colours(graph.resolution)[graph.band]
    if graph.root is not None:
        colours[graph.root] = _bytes(np.array(to_rgb(theme.ink)))
    return colours


def band_table(levels: FloatArray, colours: Colours) -> pv.LookupTable:
    """Colours of the field's values from 0 to 1, one colour a band.

    Drawn as a texture, it shows the bands exactly as the levels cut the faces.
    """
    values = (np.arange(_TEXELS) + 0.5) / _TEXELS
    rgba = np.full((_TEXELS, 4), 255, np.uint8)
    rgba[:, :3] = colours[np.searchsorted(levels, values, side="right")]
    table = pv.LookupTable(values=rgba)
    table.scalar_range = (0.0, 1.0)
    return table


def grown_colours(resolution: int, step: int | None, theme: Theme, *, plain: bool) -> Colours:
    """Colours of the bands, those from `step` on in the colour of the plain surface."""
    colours = band_colours(resolution)
    colours[0 if plain else step or resolution :] = _bytes(np.array(to_rgb(theme.surface)))
    return colours


def _bytes(colours: FloatArray) -> Colours:
    return np.round(np.asarray(colours) * 255).astype(np.uint8)
