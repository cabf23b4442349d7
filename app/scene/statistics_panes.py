"""The models beside the statistics plots as panes, coloured by a quantity of their vertices."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.scene.caption import PART_GAP
from app.scene.colours import Theme
from app.scene.panes import NO_FACES, Look, Pane, Points
from app.scene.statistics_scene import ModelPane
from app.scene.unit_ball import UnitFrame, unit_points
from core.arrays import FloatArray
from core.mesh import TriangleMesh


@dataclass(frozen=True, eq=False)
class ShownModel:
    """A model on show.

    Attributes
    ----------
    name, colour : str
        Its label, and the colour of the label.
    mesh : TriangleMesh
        The mesh.
    values : (m,) float64 ndarray or None
        What colours it; infinite where a vertex has no value.
    """

    name: str
    colour: str
    mesh: TriangleMesh
    values: FloatArray | None = None


class PaneMaker:
    """Makes panes, and keeps the scaled points of meshes that did not change."""

    def __init__(self) -> None:
        self._points: dict[int, tuple[TriangleMesh, Points, UnitFrame]] = {}

    def panes(self, models: Sequence[ShownModel]) -> list[ModelPane]:
        """Return the panes of some models; one alone has room for its numbers."""
        alone = len(models) == 1
        return [self._pane(place, model, alone=alone) for place, model in enumerate(models)]

    def _pane(self, place: int, model: ShownModel, *, alone: bool) -> ModelPane:
        known = self._points.get(place)
        if known is None or known[0] is not model.mesh:
            known = self._points[place] = (model.mesh, *unit_points(model.mesh))
        mesh = model.mesh
        numbers = f"{len(mesh.vertices):,} vertices{PART_GAP}{len(mesh.faces):,} faces"
        values = None if model.values is None else np.nan_to_num(model.values, posinf=np.nan)
        pane = Pane(
            str(place), model.name, numbers if alone else "", model.colour, known[1], values
        )
        return ModelPane(pane, model.mesh.topology, known[2])


def colour_look(models: Sequence[ShownModel], title: str, theme: Theme, text_scale: float) -> Look:
    """How models are drawn: one colour bar for all of them, over all their finite values."""
    known = [
        model.values[np.isfinite(model.values)] for model in models if model.values is not None
    ]
    whole = np.concatenate(known) if known else np.zeros(0)
    ends = (float(whole.min()), float(np.percentile(whole, 99.9))) if len(whole) else (0.0, 1.0)
    return Look(
        topology=NO_FACES,
        theme=theme,
        colour_title=title if len(whole) else "",
        colour_range=ends if ends[0] < ends[1] else (ends[0], ends[0] + 1),
        text_scale=text_scale,
    )
