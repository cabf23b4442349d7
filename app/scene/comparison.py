"""The panes of the denoising comparison: original, noisy, and one for each checked method."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.scene.colours import NOISY_COLOUR, ORIGINAL_COLOUR, Theme, method_colour
from app.scene.grid import CAPACITY
from app.scene.panes import Look, Pane, Points, shared_range
from app.session import Meshes, Run, Session
from core.metrics import METRICS, MetricSpec
from core.smoothing import METHODS
from core.study import MethodChoice


def error_text(metric: MetricSpec, value: float) -> str:
    """An error as a caption shows it."""
    symbol = "D" if metric.id == "visual_error" else metric.title
    unit = "°" if metric.unit == "°" else ""
    return f"{symbol} = {value:.3g}{unit}"


class ComparisonScene:
    """Builds the panes from a session, and keeps the values of panes that did not change."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._meshes: Meshes | None = None
        self._ends: dict[str, Points] = {}
        self._values: dict[str, tuple[Points, str, NDArray[np.float64]]] = {}

    def panes(self) -> list[Pane]:
        """Panes of the current study in display order; empty before a model is there."""
        meshes = self._session.meshes
        if meshes is None:
            return []
        if meshes is not self._meshes:
            self._place_ends(meshes)
        choices = [choice for choice in self._session.study.methods if choice.enabled]
        panes = [self._original(meshes), self._noisy(meshes)]
        panes += [self._method(choice) for choice in choices[: CAPACITY - 2]]
        return [self._coloured(pane) for pane in panes]

    def look(self, panes: list[Pane], theme: Theme, selected: str | None, scale: float) -> Look:
        """How the panes of the current study are drawn."""
        view, meshes = self._session.study.view, self._session.meshes
        metric = METRICS.get(view.colour)
        faces = meshes.comparison.original.faces if meshes else np.zeros((0, 3), np.int32)
        return Look(
            faces=faces,
            theme=theme,
            smooth=view.smooth_shading,
            edges=view.edges,
            values_on=metric.elements_on if metric else "vertex",
            colour_title=_bar_title(metric) if metric else "",
            colour_range=shared_range(panes),
            selected=selected,
            text_scale=scale,
        )

    def _place_ends(self, meshes: Meshes) -> None:
        """Centre the original and the noisy mesh as the runs are."""
        self._meshes = meshes
        comparison = meshes.comparison
        centre = comparison.original.vertices.mean(axis=0)
        self._ends = {
            "original": (comparison.original.vertices - centre).astype(np.float32),
            "noisy": (comparison.noisy.vertices - centre).astype(np.float32),
        }
        self._values.clear()

    def _original(self, meshes: Meshes) -> Pane:
        mesh = meshes.comparison.original
        caption = f"{len(mesh.vertices):,} vertices, {len(mesh.faces):,} faces"
        return Pane("original", "Original", caption, ORIGINAL_COLOUR, self._ends["original"])

    def _noisy(self, meshes: Meshes) -> Pane:
        study = self._session.study
        metric = METRICS[study.metric]
        error = error_text(metric, meshes.comparison.noisy_errors[metric.id])
        source = "from file" if study.noisy else f"σ = {study.noise.sigma:g} ℓ"
        return Pane(
            "noisy", "Noisy input", f"{source}   {error}", NOISY_COLOUR, self._ends["noisy"]
        )

    def _method(self, choice: MethodChoice) -> Pane:
        run = self._session.run(choice.method)
        title, colour = METHODS[choice.method].title, method_colour(choice.method)
        if run is None:
            return Pane(choice.method, title, "waiting", colour, self._ends["noisy"])
        shown = self._session.shown_iteration(choice.method)
        caption, warning = self._caption(run, choice, shown)
        return Pane(choice.method, title, caption, colour, run.positions[shown], warning=warning)

    def _caption(self, run: Run, choice: MethodChoice, shown: int) -> tuple[str, bool]:
        metric = METRICS[self._session.study.metric]
        error = error_text(metric, run.values(metric.id)[shown])
        if run.diverged and choice.iterations >= run.diverged:
            return f"diverged at iteration {run.diverged}   k = {shown}   {error}", True
        more = f" of {choice.iterations}" if shown < choice.iterations else ""
        return f"k = {shown}{more}   {error}", False

    def _coloured(self, pane: Pane) -> Pane:
        metric, meshes = self._session.study.view.colour, self._session.meshes
        if metric not in METRICS or pane.id == "original" or meshes is None:
            return pane
        known = self._values.get(pane.id)
        if known is None or known[0] is not pane.points or known[1] != metric:
            centre = meshes.comparison.original.vertices.mean(axis=0)
            vertices = pane.points.astype(np.float64) + centre
            values = meshes.comparison.evaluators[metric].elements(vertices)
            self._values[pane.id] = known = (pane.points, metric, values)
        return replace(pane, values=known[2])


def _bar_title(metric: MetricSpec) -> str:
    unit = {"ℓ̄²": "mean edge²", "ℓ̄": "mean edge"}.get(metric.elements_unit, metric.elements_unit)
    return f"{metric.title}\n({unit})"
