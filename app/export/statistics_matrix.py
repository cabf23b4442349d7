"""Pictures of sparse matrices that stay readable however many rows there are."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap, LogNorm
from matplotlib.figure import FigureBase

from app.export.statistics_axes import main_axes
from app.scene.colours import Theme
from core.arrays import FloatArray
from core.statistics import AxisLabels

if TYPE_CHECKING:
    from scipy.sparse import csr_array

CELLS = 320
"""Most rows and columns of squares in the picture."""

MATRIX_TITLES = {
    "adjacency": "Adjacency A",
    "edge": "Edge matrix E",
    "degree": "Degree D",
    "laplacian": "Laplacian L = D − A",
    "normalized_laplacian": "Normalised Laplacian",
}


def matrix_density(matrix: "csr_array", cells: int = CELLS) -> FloatArray:
    """Share of entries that are not zero in each square of a coarse grid, (c, c), c ≤ `cells`."""
    m = matrix.shape[0]
    count = min(m, cells)
    entries = matrix.tocoo()
    rows, columns = (place.astype(np.int64) * count // m for place in (entries.row, entries.col))
    found = np.bincount(rows * count + columns, minlength=count**2).reshape(count, count)
    sizes = np.bincount(np.arange(m) * count // m, minlength=count)
    density: FloatArray = found / np.outer(sizes, sizes)
    return density


def draw_matrix(figure: FigureBase, matrix: "csr_array", theme: Theme) -> Axes:
    """Draw where a matrix has entries; a square stands for many rows where the matrix is large."""
    labels = AxisLabels("vertex j", "vertex i")
    axes = main_axes(figure, labels, theme)
    density = matrix_density(matrix)
    axes.grid(visible=False)
    ink = LinearSegmentedColormap.from_list("ink", [theme.faint, theme.ink])
    shown = np.ma.masked_equal(density, 0)
    lowest = float(shown.min()) if shown.count() else 1.0
    m = matrix.shape[0]
    axes.imshow(
        shown,
        cmap=ink.with_extremes(bad=theme.panel),
        norm=LogNorm(lowest / 3, max(float(density.max()), lowest)),
        extent=(0, m, m, 0),
        interpolation="nearest",
    )
    for spine in axes.spines.values():
        spine.set_visible(True)
    return axes


def matrix_words(matrix: "csr_array") -> str:
    """Say how large and how full a matrix is."""
    m, entries = matrix.shape[0], matrix.nnz
    side = -(-m // CELLS)
    rest = f" A square stands for {side} × {side} entries, stronger where more of them are set."
    return (
        f"{m:,} × {m:,}, {entries:,} entries ({100 * entries / max(m**2, 1):.2g} %). "
        "Neighbours with far apart numbers lie far from the diagonal."
        f"{rest if side > 1 else ''}"
    )
