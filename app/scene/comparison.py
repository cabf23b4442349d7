"""The panes of the denoising comparison: original, noisy, and one for each method."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.scene.colouring import colour_map, colour_range, shares_between
from app.scene.colours import LIGHT, NOISY_COLOUR, ORIGINAL_COLOUR, Theme, method_colour
from app.scene.grid import CAPACITY
from app.scene.panes import NO_FACES, Look, Pane, Points
from app.session import Meshes, Run, Session
from core.arrays import FloatArray
from core.comparison import Comparison, MethodResult, StudyResult
from core.metrics import METRICS, MetricSpec
from core.smoothing import METHODS
from core.study import MethodChoice, Study

METHOD_CAPACITY = CAPACITY - 2
"""Methods that fit beside the original and the noisy mesh."""


def error_text(metric: MetricSpec, value: float) -> str:
    """An error as a caption shows it, with three digits as in the table."""
    symbol = "D" if metric.id == "visual_error" else metric.title
    unit = "°" if metric.unit == "°" else ""
    digits = f"{value:#.3g}".rstrip(".") if value else "0"
    return f"{symbol} = {digits}{unit}"


def end_panes(study: Study, comparison: Comparison, original: Points, noisy: Points) -> list[Pane]:
    """Panes of the original and of the noisy mesh, with their points already centred."""
    mesh, metric = comparison.original, study.metrics[study.metric]
    counts = f"{len(mesh.faces):,} faces"
    source = "from file" if study.noisy else f"σ = {study.noise.sigma:g} ℓ̄"
    caption = f"{source}   {error_text(metric, comparison.noisy_errors[metric.id])}"
    return [
        Pane("original", "Original", counts, ORIGINAL_COLOUR, original),
        Pane("noisy", "Noisy input", caption, NOISY_COLOUR, noisy),
    ]


def method_pane(
    choice: MethodChoice,
    metric: MetricSpec,
    points: Points,
    shown: int,
    error: float,
    diverged: int | None,
) -> Pane:
    """Pane of a method at the iteration `shown`."""
    text = f"k = {shown}   {error_text(metric, error)}"
    warning = diverged is not None and choice.iterations >= diverged
    if warning:
        text = f"diverged at iteration {diverged}   {text}"
    elif shown < choice.iterations:
        text = f"k = {shown} of {choice.iterations}   {error_text(metric, error)}"
    title, colour = METHODS[choice.method].title, method_colour(choice.method)
    return Pane(choice.method, title, text, colour, points, warning=warning)


def build_look(
    study: Study,
    comparison: Comparison,
    panes: list[Pane],
    theme: Theme,
    text_scale: float,
    selected: str | None = None,
) -> Look:
    """How the panes of a study are drawn."""
    metric = study.metrics.get(study.view.colour)
    ends = colour_range(study.view, panes)
    with_histogram = metric is not None and study.view.histogram
    return Look(
        topology=comparison.original.topology,
        theme=theme,
        smooth=study.view.smooth_shading,
        edges=study.view.edges,
        values_on=metric.elements_on if metric else "vertex",
        colour_title=_bar_title(metric) if metric else "",
        colour_range=ends,
        colour_map=colour_map(study.view),
        histogram=shares_between(panes, selected, ends) if with_histogram else None,
        selected=selected,
        text_scale=text_scale,
    )


class ComparisonScene:
    """Builds the panes from a session, and keeps the values of panes that did not change."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._meshes: Meshes | None = None
        self._ends: tuple[Points, Points] = (np.zeros((0, 3), np.float32),) * 2
        self._values: dict[str, tuple[Points, str, NDArray[np.float64]]] = {}

    def panes(self) -> list[Pane]:
        """Panes of the current study in display order; empty before a model is there."""
        meshes, study = self._session.meshes, self._session.study
        if meshes is None:
            return []
        if meshes is not self._meshes:
            self._place_ends(meshes)
        choices = [choice for choice in study.methods if choice.enabled]
        panes = end_panes(study, meshes.comparison, *self._ends)
        panes += [self._method(choice) for choice in choices[:METHOD_CAPACITY]]
        return [self._coloured(pane, meshes.comparison) for pane in panes]

    def look(self, panes: list[Pane], theme: Theme, selected: str | None, scale: float) -> Look:
        """How the panes of the current study are drawn."""
        meshes = self._session.meshes
        if meshes is None:
            return Look(NO_FACES, theme)
        study = self._session.study
        return build_look(study, meshes.comparison, panes, theme, scale, selected)

    def _place_ends(self, meshes: Meshes) -> None:
        """Centre the original and the noisy mesh as the runs are."""
        self._meshes = meshes
        comparison = meshes.comparison
        centre = comparison.original.vertices.mean(axis=0)
        self._ends = (
            _centred(comparison.original.vertices, centre),
            _centred(comparison.noisy.vertices, centre),
        )
        self._values.clear()

    def _method(self, choice: MethodChoice) -> Pane:
        run: Run | None = self._session.run(choice.method)
        metric = self._session.study.metrics[self._session.study.metric]
        if run is None:
            return method_pane(choice, metric, self._ends[1], 0, 0.0, None)
        shown = self._session.shown_iteration(choice.method)
        error = run.errors[shown][metric.id]
        return method_pane(choice, metric, run.snapshot(shown), shown, error, run.diverged)

    def _coloured(self, pane: Pane, comparison: Comparison) -> Pane:
        metric = self._session.study.view.colour
        if metric not in METRICS or pane.id == "original":
            return pane
        known = self._values.get(pane.id)
        if known is None or known[0] is not pane.points or known[1] != metric:
            centre = comparison.original.vertices.mean(axis=0)
            vertices = pane.points.astype(np.float64) + centre
            values = comparison.evaluators[metric].elements(vertices)
            self._values[pane.id] = known = (pane.points, metric, values)
        return replace(pane, values=known[2])


def study_panes(result: StudyResult) -> list[Pane]:
    """Panes of a finished study, each method at its last good iteration."""
    comparison, study = result.comparison, result.study
    centre = comparison.original.vertices.mean(axis=0)
    ends = [_centred(mesh.vertices, centre) for mesh in (comparison.original, comparison.noisy)]
    panes = end_panes(study, comparison, *ends)
    return panes + [
        _result_pane(study, method, centre) for method in result.methods[:METHOD_CAPACITY]
    ]


def study_look(result: StudyResult, panes: list[Pane], text_scale: float) -> Look:
    """How the panes of a finished study are drawn."""
    return build_look(result.study, result.comparison, panes, LIGHT, text_scale)


def _result_pane(study: Study, result: MethodResult, centre: FloatArray) -> Pane:
    metric = study.metrics[study.metric]
    error = result.errors[metric.id][-1]
    points = _centred(result.mesh.vertices, centre)
    return method_pane(result.choice, metric, points, result.iterations, error, result.diverged)


def _centred(vertices: FloatArray, centre: FloatArray) -> Points:
    return (vertices - centre).astype(np.float32)


def _bar_title(metric: MetricSpec) -> str:
    # The title stands above a narrow bar, so a long one takes two lines.
    title = metric.heat_title.replace(" to ", "\nto ")
    gap = " " if "\n" in title else "\n"
    return f"{title}{gap}({metric.elements_unit})"
