"""The legend of a field: its bands from the centre outwards, in a corner of the pane."""

import pyvista as pv
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

from app.scene.caption import PLATE_OPACITY, text_style
from app.scene.skeleton_panes import SkeletonLook, SkeletonPane

_LABEL_SIZE = 11
_WIDTH, _HEIGHT = 46.0, 150.0


class BandLegend:
    """A scale from 0 to 1 with the colours of the bands."""

    def __init__(self) -> None:
        self._bar = vtkScalarBarActor()
        self._bar.VisibilityOff()
        self._bar.SetOrientationToVertical()
        self._bar.SetLookupTable(pv.LookupTable())
        self._bar.SetNumberOfLabels(3)
        self._bar.SetLabelFormat("{:.1f}")
        self._bar.SetMaximumNumberOfColors(512)
        self._bar.UnconstrainedFontSizeOn()
        self._bar.SetBarRatio(0.3)
        self._bar.SetTitle("")
        self._bar.SetLabelTextProperty(text_style(_LABEL_SIZE))
        # As behind a caption: the surface may reach below the labels.
        self._bar.DrawBackgroundOn()
        self._bar.GetBackgroundProperty().SetOpacity(PLATE_OPACITY)

    def add_to(self, renderer: pv.Renderer) -> None:
        """Put the legend into a renderer."""
        renderer.AddViewProp(self._bar)

    def show(self, pane: SkeletonPane | None, look: SkeletonLook, table: pv.LookupTable) -> None:
        """Draw the scale of a pane; None draws none."""
        coloured = look.settings.show_bands or look.settings.node_colour == "band"
        self._bar.SetVisibility(pane is not None and pane.skeleton is not None and coloured)
        self._bar.SetLookupTable(table)
        self._bar.GetBackgroundProperty().SetColor(pv.Color(look.theme.ground).float_rgb)
        label = self._bar.GetLabelTextProperty()
        label.SetColor(pv.Color(look.theme.ink).float_rgb)
        label.SetFontSize(int(_LABEL_SIZE * look.text_scale))
        for setting in (label.ShadowOff, label.ItalicOff, label.BoldOff):
            setting()

    def place(self, width: float, height: float, scale: float) -> None:
        """Stand in the lower right corner of a viewport of these pixels."""
        wide, high = _WIDTH * scale / width, min(_HEIGHT * scale / height, 0.6)
        self._bar.SetPosition(1 - wide - 4 * scale / width, 12 * scale / height)
        self._bar.SetPosition2(wide, high)
