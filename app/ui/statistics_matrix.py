"""The cell that draws a matrix of the mesh beside the model, thesis figures 1.12–1.13."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from matplotlib.figure import Figure
from PySide6.QtWidgets import QComboBox

from app.export.statistics_matrix import MATRIX_TITLES, draw_matrix, matrix_words
from app.export.statistics_plots import save_figure
from app.scene.colours import LIGHT, Theme
from app.ui.statistics_plot import Cell
from core.mesh import TriangleMesh
from core.mesh.matrices import MATRICES, MATRIX_SUFFIXES, save_matrix

SAVE_FILTERS = "PNG (*.png);;SVG (*.svg);;PDF (*.pdf);;Matrix Market (*.mtx);;NumPy NPZ (*.npz)"


class MatrixCell(Cell):
    """Shows where a matrix of the mesh has entries; saves the picture or the matrix itself."""

    def __init__(self) -> None:
        super().__init__("matrix", "Matrix")
        self.choice = QComboBox()
        self.choice.setAccessibleName("Matrix")
        for id_, title in MATRIX_TITLES.items():
            self.choice.addItem(title, id_)
        self.choice.setCurrentIndex(self.choice.findData("laplacian"))
        self.choice.currentIndexChanged.connect(self._draw)
        self.head.insertWidget(1, self.choice)
        self.head.insertSpacing(1, 10)
        self.save.setToolTip("Save the picture, or the matrix as Matrix Market or NPZ")
        self.copy.hide()
        self._mesh: TriangleMesh | None = None
        self._theme = LIGHT

    def show_mesh(self, mesh: TriangleMesh | None, theme: Theme) -> None:
        """Draw the chosen matrix of a mesh."""
        if mesh is not self._mesh or theme is not self._theme:
            self._mesh, self._theme = mesh, theme
            self._draw()

    def writer(self) -> Callable[[Path], None]:
        """Return what writes the matrix of now or its picture, as the suffix says."""
        return partial(_write, self.choice.currentData(), self._mesh)

    def _draw(self) -> None:
        if self._mesh is None:
            return
        matrix = MATRICES[self.choice.currentData()](self._mesh)
        with self.canvas.making():
            draw_matrix(self.canvas.figure, matrix, self._theme)
        self._say(matrix_words(matrix))
        self.canvas.draw_idle()


def _write(name: str, mesh: TriangleMesh, path: Path) -> None:
    matrix = MATRICES[name](mesh)
    if path.suffix.lower() in MATRIX_SUFFIXES:
        save_matrix(matrix, path)
        return
    figure = Figure(figsize=(6, 6), layout="constrained")
    draw_matrix(figure, matrix, LIGHT)
    save_figure(path, figure)
