"""A study: the frozen, JSON-serialisable description of one experiment.

It is what a file, an undo step and a command line hold; :mod:`core.comparison` carries it out.
"""

from typing import Literal

from core.doctor import RepairChoice
from core.fields import field_spec
from core.metrics import MetricSpec, metrics_in
from core.noise import NoiseParams
from core.parameters import Params, build_params, param
from core.skeleton import Bands, Spacing
from core.smoothing import METHODS, method_spec
from core.statistics_view import StatisticsSettings
from core.view import ViewSettings

SAMPLE_PREFIX = "sample:"
MOST_ITERATIONS = 1000


class MethodChoice(Params):
    """One method of a study: whether it is shown, how far it runs, and its parameters."""

    method: str = param(..., help="Id of a smoothing method.")
    iterations: int = param(
        6, low=0, high=MOST_ITERATIONS, step=1, help="Number of iterations; more is smoother."
    )
    enabled: bool = param(True, help="Whether the method takes part.")
    params: dict[str, float | int | bool | str | None] = param(
        {}, help="Parameters that differ from their declared defaults."
    )

    @property
    def settings(self) -> Params:
        """The validated parameters of the method."""
        settings: Params = build_params(method_spec(self.method).params, self.params, self.method)
        return settings


def default_choices() -> tuple[MethodChoice, ...]:
    """Choose the thesis' five methods; plain Laplacian flow, the baseline, waits unchecked."""
    return tuple(MethodChoice(method=id_, enabled=id_ != "laplacian") for id_ in METHODS)


class SkeletonView(Params):
    """One skeletal graph: of which surface, in which field, at which resolution."""

    source: str = param("original", help="Surface: original, noisy, or the id of a method.")
    keep: float = param(
        1.0, low=0.005, high=1, help="Share of the faces that decimation leaves; 1 leaves all."
    )
    field: str = param("mixture", help="Id of a field.")
    params: dict[str, float | int | bool | str | None] = param(
        {}, help="Parameters of the field that differ from their declared defaults."
    )
    spacing: Spacing = param(
        "value", help="Levels at equal steps of the field, of the distance, or of the area."
    )
    resolution: int = param(
        22, low=1, high=64, step=1, help="Number of bands R; more show finer branches."
    )
    bands: Bands = param(
        "exact", help="Cut the faces at the levels, or collect vertices as the thesis prints it."
    )
    root: bool = param(False, help="Join the centroid to the nodes of the first band.")

    @property
    def settings(self) -> Params:
        """The validated parameters of the field."""
        spec = field_spec(self.field)
        settings: Params = build_params(spec.params, self.params, self.field)
        return settings


class SkeletonSettings(Params):
    """The Skeleton tab: the graphs that are compared, and how they are drawn."""

    views: tuple[SkeletonView, SkeletonView] = param(
        (SkeletonView(field="euclidean"), SkeletonView()), help="The two views, left and right."
    )
    compare: bool = param(True, help="Show both views; off shows only the right one.")
    node_colour: Literal["band", "kind"] = param(
        "band", help="Colour nodes by their band, or by kind: end, branch, regular."
    )
    node_size: float = param(
        1.0, low=0.2, high=4, step=0.1, help="Size of nodes and tubes; 1 suits the model."
    )
    opacity: float = param(
        0.35, low=0, high=1, step=0.05, help="Opacity of the surface; 0 leaves it out."
    )
    show_bands: bool = param(True, help="Colour the bands on the surface.")
    show_curves: bool = param(True, help="Draw the level curves.")
    show_graph: bool = param(True, help="Draw the skeletal graph.")
    show_shells: bool = param(
        False, help="Draw the spheres or ellipsoids on which the field is constant."
    )

    @property
    def drawing(self) -> "SkeletonSettings":
        """How graphs are drawn, whichever they are: equal drawings look the same."""
        return self.model_copy(update={"views": SkeletonSettings().views, "compare": True})

    def with_view(self, index: int, view: SkeletonView) -> "SkeletonSettings":
        """Return the settings with one view replaced."""
        views = tuple(view if i == index else old for i, old in enumerate(self.views))
        return self.model_copy(update={"views": views})


class Study(Params):
    """Frozen, JSON-serialisable description of one denoising experiment."""

    version: Literal[1] = param(1, help="Version of the format.")
    model: str = param("sample:creature", help="Path of the original, or sample:ID.")
    noisy: str | None = param(None, help="Path of a separate noisy file; then no noise is added.")
    repairs: tuple[RepairChoice, ...] = param((), help="Repairs of the model, in their order.")
    noise: NoiseParams = param(NoiseParams(), help="Noise added to the original.")
    methods: tuple[MethodChoice, ...] = param(default_choices(), help="Methods in display order.")
    metric: str = param("visual_error", help="Metric of the plot.")
    model_units: bool = param(
        False, help="Errors in the file's own units and origin instead of mean edge lengths."
    )
    view: ViewSettings = param(ViewSettings(), help="How the panes look.")
    skeleton: SkeletonSettings = param(SkeletonSettings(), help="What the Skeleton tab shows.")
    statistics: StatisticsSettings = param(
        StatisticsSettings(), help="What the Statistics tab shows."
    )

    @property
    def metrics(self) -> dict[str, MetricSpec]:
        """All metrics by id, in the units of the study."""
        return metrics_in(model_units=self.model_units)

    def compares_like(self, other: "Study") -> bool:
        """Whether both show the same comparison, whatever the other tabs show."""
        others = {"skeleton": other.skeleton, "statistics": other.statistics}
        return self.model_copy(update=others) == other

    def choice(self, method: str) -> MethodChoice:
        """Return the choice made for a method; one that the study leaves out is not enabled."""
        for choice in self.methods:
            if choice.method == method:
                return choice
        return MethodChoice(method=method, enabled=False)

    def with_choice(self, choice: MethodChoice) -> "Study":
        """Return the study with one method's choice replaced, in display order."""
        choices = {old.method: old for old in self.methods} | {choice.method: choice}
        ordered = tuple(choices[method] for method in METHODS if method in choices)
        return self.model_copy(update={"methods": ordered})
