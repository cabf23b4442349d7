"""The colour bar that all panes share, in a renderer of its own."""

import pyvista as pv
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

from app.scene.caption import text_line, text_style
from app.scene.panes import Look

_LABEL_SIZE = 12
_LABELS = 5


class ColourBar:
    """A vertical scale of colours with numbers and a title."""

    def __init__(self) -> None:
        self._bar = vtkScalarBarActor()
        self._bar.SetOrientationToVertical()
        self._bar.SetLookupTable(pv.LookupTable())
        self._bar.SetNumberOfLabels(_LABELS)
        self._bar.SetMaximumNumberOfColors(256)
        self._bar.UnconstrainedFontSizeOn()
        self._bar.SetPosition(0.1, 0.06)
        self._bar.SetPosition2(0.8, 0.82)
        self._bar.SetBarRatio(0.26)
        self._bar.SetTitle("")
        self._bar.SetLabelTextProperty(text_style(_LABEL_SIZE))
        self._title = text_line(_LABEL_SIZE)
        self._title.SetPosition(0.5, 0.985)
        self._title.prop.SetJustificationToCentered()
        self._title.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()

    def add_to(self, renderer: pv.Renderer) -> None:
        """Put the bar into a renderer."""
        renderer.AddViewProp(self._bar)
        renderer.AddViewProp(self._title)

    def show(self, look: Look, table: pv.LookupTable) -> None:
        """Draw the scale of a look."""
        self._bar.SetVisibility(bool(look.colour_title))
        self._title.input = look.colour_title
        self._bar.SetLookupTable(table)
        self._bar.SetLabelFormat("{:.3g}")
        ink = pv.Color(look.theme.ink).float_rgb
        for prop in (self._bar.GetLabelTextProperty(), self._title.prop):
            prop.SetColor(ink)
            prop.SetFontSize(int(_LABEL_SIZE * look.text_scale))
            prop.ShadowOff()
            prop.ItalicOff()
            prop.BoldOff()
