"""A study: the frozen, JSON-serialisable description of one experiment.

It is what a file, an undo step and a command line hold; :mod:`core.comparison` carries it out.
"""

from typing import Literal

from core.noise import NoiseParams
from core.parameters import Params, build_params, param
from core.smoothing import METHODS, method_spec

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


class ViewSettings(Params):
    """How the panes show the meshes."""

    smooth_shading: bool = param(True, help="Smooth shading; off shows every face flat.")
    edges: bool = param(False, help="Draw the edges of the triangles.")
    colour: str = param("none", help="Metric that colours the panes, or none.")
    linked: bool = param(True, help="Move the cameras of all panes together.")


class Study(Params):
    """Frozen, JSON-serialisable description of one denoising experiment."""

    version: Literal[1] = param(1, help="Version of the format.")
    model: str = param("sample:creature", help="Path of the original, or sample:ID.")
    noisy: str | None = param(None, help="Path of a separate noisy file; then no noise is added.")
    noise: NoiseParams = param(NoiseParams(), help="Noise added to the original.")
    methods: tuple[MethodChoice, ...] = param(default_choices(), help="Methods in display order.")
    metric: str = param("visual_error", help="Metric of the plot.")
    view: ViewSettings = param(ViewSettings(), help="How the panes look.")

    def choice(self, method: str) -> MethodChoice:
        """Return the choice made for a method."""
        return next(choice for choice in self.methods if choice.method == method)

    def with_choice(self, choice: MethodChoice) -> "Study":
        """Return the study with one method's choice replaced."""
        methods = tuple(choice if old.method == choice.method else old for old in self.methods)
        return self.model_copy(update={"methods": methods})
