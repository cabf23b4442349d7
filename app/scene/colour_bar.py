"""The colour bar that all panes share, with a histogram, in a renderer of its own."""

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkCoordinate, vtkPolyDataMapper2D

from app.scene.caption import text_line
from app.scene.panes import Look
from core.arrays import FloatArray

_LABEL_SIZE = 12
_LABELS = 5
_BOTTOM, _TOP = 0.06, 0.86
_STEPS = 256
# Where the bar stands across its renderer, without and with a histogram on its left.
_PLAIN, _BESIDE = (0.12, 0.32), (0.36, 0.48)
_HISTOGRAM_LEFT = 0.06
_GAP = 0.05


class ColourBar:
    """A vertical scale of colours with numbers, a title and a histogram of the values."""

    def __init__(self) -> None:
        self._scale, self._histogram = _Boxes(), _Boxes()
        self._labels = [text_line(_LABEL_SIZE) for _ in range(_LABELS)]
        self._title = text_line(_LABEL_SIZE)
        for line in (*self._labels, self._title):
            line.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        self._title.SetPosition(0.5, 0.985)
        self._title.prop.SetJustificationToCentered()
        for label in self._labels:
            label.prop.SetVerticalJustificationToCentered()

    def add_to(self, renderer: pv.Renderer) -> None:
        """Put the bar into a renderer."""
        for part in (self._scale.actor, self._histogram.actor, *self._labels, self._title):
            renderer.AddViewProp(part)

    def show(self, look: Look, table: pv.LookupTable) -> None:
        """Draw the scale of a look."""
        visible = bool(look.colour_title)
        for part in (self._scale.actor, *self._labels, self._title):
            part.SetVisibility(visible)
        self._histogram.actor.SetVisibility(visible and look.histogram is not None)
        if not visible:
            return
        left, right = _PLAIN if look.histogram is None else _BESIDE
        self._show_scale(left, right, table)
        self._show_labels(right + _GAP, look)
        if look.histogram is not None:
            self._show_histogram(look.histogram, left - _GAP / 2, look.theme.ink)

    def _show_scale(self, left: float, right: float, table: pv.LookupTable) -> None:
        edges = np.linspace(_BOTTOM, _TOP, _STEPS + 1)
        ones = np.ones(_STEPS)
        low, high = table.scalar_range
        self._scale.show(left * ones, right * ones, edges, np.linspace(low, high, _STEPS))
        self._scale.mapper.SetLookupTable(table)
        self._scale.mapper.SetScalarRange(table.scalar_range)

    def _show_labels(self, left: float, look: Look) -> None:
        ink = pv.Color(look.theme.ink).float_rgb
        heights = np.linspace(_BOTTOM, _TOP, _LABELS)
        for label, height, value in zip(
            self._labels, heights, np.linspace(*look.colour_range, _LABELS), strict=True
        ):
            label.SetPosition(left, height)
            label.input = f"{value:.3g}"
        self._title.input = look.colour_title
        for line in (*self._labels, self._title):
            line.prop.SetColor(ink)
            line.prop.SetFontSize(int(_LABEL_SIZE * look.text_scale))

    def _show_histogram(self, heights: FloatArray, right: float, ink: str) -> None:
        """Draw the bins as boxes that grow to the left, away from the bar."""
        edges = np.linspace(_BOTTOM, _TOP, len(heights) + 1)
        left = right - (right - _HISTOGRAM_LEFT) * heights
        self._histogram.show(left, np.full(len(heights), right), edges, None)
        self._histogram.actor.GetProperty().SetColor(pv.Color(ink).float_rgb)
        self._histogram.actor.GetProperty().SetOpacity(0.45)


class _Boxes:
    """Boxes above each other, in shares of the viewport."""

    def __init__(self) -> None:
        self.mapper = vtkPolyDataMapper2D()
        place = vtkCoordinate()
        place.SetCoordinateSystemToNormalizedViewport()
        self.mapper.SetTransformCoordinate(place)
        self.actor = vtkActor2D()
        self.actor.SetMapper(self.mapper)
        self.actor.SetVisibility(False)

    def show(
        self,
        left: FloatArray,
        right: FloatArray,
        edges: FloatArray,
        values: NDArray[np.float64] | None,
    ) -> None:
        """Draw boxes from `left` to `right` between consecutive `edges`, coloured by values."""
        low, high = edges[:-1], edges[1:]
        x = np.stack([left, right, right, left], axis=1).ravel()
        y = np.stack([low, low, high, high], axis=1).ravel()
        corners = np.stack([x, y, np.zeros_like(x)], axis=1)
        boxes = pv.PolyData.from_regular_faces(corners, np.arange(len(x)).reshape(-1, 4))
        if values is not None:
            boxes.cell_data["value"] = values
            boxes.cell_data.active_scalars_name = "value"
        self.mapper.SetInputData(boxes)
        self.mapper.SetScalarVisibility(values is not None)
